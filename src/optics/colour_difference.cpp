#include "optics/colour_difference.h"

#include <cmath>
#include <numbers>

namespace airlight {
namespace {

constexpr Xyz d65{0.95047, 1, 1.08883};
constexpr double degree = std::numbers::pi / 180;
constexpr double middle_grey = 0.18418651851244416;  // Y of L* = 50: ((50 + 16) / 116)^3

double cube_root(double t) {
  constexpr double linear_below = 216.0 / 24389, slope = 24389.0 / 27;
  return t > linear_below ? std::cbrt(t) : (slope * t + 16) / 116;
}

/// Hue angle in [0, 360); 0 for greys.
double hue(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a) / degree;
  return angle < 0 ? angle + 360 : angle;
}

double seventh_power_part(double chroma) {
  const double c7 = std::pow(chroma, 7);
  return std::sqrt(c7 / (c7 + std::pow(25.0, 7)));
}

}  // namespace

Lab lab_of(const Xyz& xyz) {
  const double x = cube_root(xyz[0] / d65[0]), y = cube_root(xyz[1] / d65[1]), z = cube_root(xyz[2] / d65[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double ciede2000(const Lab& first, const Lab& second) {
  const double mean_chroma = 0.5 * (std::hypot(first[1], first[2]) + std::hypot(second[1], second[2]));
  const double stretch = 1 + 0.5 * (1 - seventh_power_part(mean_chroma));
  const double a1 = stretch * first[1], a2 = stretch * second[1];
  const double c1 = std::hypot(a1, first[2]), c2 = std::hypot(a2, second[2]);
  const double h1 = hue(a1, first[2]), h2 = hue(a2, second[2]);
  const bool grey = c1 * c2 == 0;

  double turn = grey ? 0 : h2 - h1;
  if (turn > 180) turn -= 360;
  if (turn < -180) turn += 360;
  const double lightness = second[0] - first[0], chroma = c2 - c1,
               hues = 2 * std::sqrt(c1 * c2) * std::sin(0.5 * turn * degree);

  const double l = 0.5 * (first[0] + second[0]), c = 0.5 * (c1 + c2);
  double h = h1 + h2;
  if (!grey) h = std::abs(h1 - h2) <= 180 ? 0.5 * h : h < 360 ? 0.5 * (h + 360) : 0.5 * (h - 360);
  const double t = 1 - 0.17 * std::cos((h - 30) * degree) + 0.24 * std::cos(2 * h * degree) +
                   0.32 * std::cos((3 * h + 6) * degree) - 0.20 * std::cos((4 * h - 63) * degree);
  const double rotation = 30 * std::exp(-std::pow((h - 275) / 25, 2));
  const double from_middle = (l - 50) * (l - 50);
  const double dl = lightness / (1 + 0.015 * from_middle / std::sqrt(20 + from_middle)), dc = chroma / (1 + 0.045 * c),
               dh = hues / (1 + 0.015 * c * t);
  const double mixed = -std::sin(2 * rotation * degree) * 2 * seventh_power_part(c) * dc * dh;
  return std::sqrt(dl * dl + dc * dc + dh * dh + mixed);
}

double colour_difference(const Xyz& truth, const Xyz& value) {
  if (!(truth[1] > 0)) return 0;
  const auto shown = [exposure = middle_grey / truth[1]](const Xyz& colour) {
    return lab_of({exposure * colour[0], exposure * colour[1], exposure * colour[2]});
  };
  return ciede2000(shown(truth), shown(value));
}

}  // namespace airlight
