#include "reference/sun_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/adaptive.h"
#include "reference/quadrature.h"

namespace airlight::reference {

using std::numbers::pi;

SunDisc::SunDisc(const Sun& sun, std::span<const double> wavelengths, bool point, double tolerance, int fineness)
    : radius_(point ? 0 : sun.angular_radius),
      tolerance_(tolerance),
      fineness_(fineness),
      reference_exponent_(sun.limb_darkening.at(550)) {
  for (const double wavelength : wavelengths) {
    const double a = sun.limb_darkening.at(wavelength);
    exponents_.push_back(2 + a);
    // 1 / integral of (1 - x^2)^((1+a)/2) over -1..1: a beta function.
    norms_.push_back(std::exp(std::lgamma(a / 2 + 2) - std::lgamma((a + 3) / 2)) / std::sqrt(pi));
  }
}

SunDisc::Element SunDisc::element(double sun_elevation, double x) const {
  const double s = std::sin(radius_), sine = std::sin(sun_elevation), cosine = std::cos(sun_elevation);
  const double y_squared = s * s * (1 - x) * (1 + x) / (3 + reference_exponent_);
  const double projection = std::sqrt(1 - s * s * x * x - y_squared);
  return {sine * projection + s * x * cosine, std::hypot(cosine * projection - s * x * sine, std::sqrt(y_squared)),
          projection};
}

// The x of the elements at an elevation; beyond -1..1 off the disc. Without y it is sin(elevation - sun's) /
// sin(radius); y lowers elements a little, which the secant step takes in: each gains a factor of about the disc's
// radius.
double SunDisc::height_of(double sun_elevation, double elevation) const {
  const double s = std::sin(radius_);
  double x = std::sin(elevation - sun_elevation) / s;
  for (int step = 0; step < 6 && std::abs(x) < 1.1; ++step) {
    const double inside = std::clamp(x, -1.0, 1.0);
    const Element there = element(sun_elevation, inside);
    x = inside + std::sin(elevation - std::atan2(there.sin_elevation, there.cos_elevation)) / s;
  }
  return x;
}

// Multiplies by the elements' share of the disc's light, dx (1 - x^2)^((1+a)/2) with x = cos(theta).
void SunDisc::weigh(double sin_theta, std::span<double> values) const {
  for (std::size_t w = 0; w < values.size(); ++w) values[w] *= norms_[w] * std::pow(sin_theta, exponents_[w]);
}

std::vector<double> SunDisc::average(double elevation, double horizon, std::span<const double> kinks,
                                     std::span<const double> floors, const Transmission& transmission) const {
  std::vector<double> none(exponents_.size(), 0.0);
  if (radius_ == 0) {
    if (elevation >= -horizon) transmission({std::sin(elevation), std::cos(elevation), 1}, none);
    return none;
  }
  const double lowest = height_of(elevation, -horizon);
  if (lowest >= 1) return none;
  std::vector<double> breaks{0, std::acos(std::max(lowest, -1.0))};
  for (const double kink : kinks) {
    const double x = height_of(elevation, -kink);
    if (x > std::max(lowest, -1.0) && x < 1) breaks.push_back(std::acos(x));
  }
  if (breaks.size() == 2 && lowest <= -1) {
    std::vector<double> whole = average_whole(elevation, floors, transmission);
    if (!whole.empty()) return whole;
  }
  std::sort(breaks.begin(), breaks.end());
  return integrate(breaks, floors, tolerance_, fineness_, [&](double theta, std::span<double> values) {
    transmission(element(elevation, std::cos(theta)), values);
    weigh(std::sin(theta), values);
  });
}

// The usual case, a whole disc whose light varies little: one rule in theta, the weights made to add to 1, is enough.
// Empty where its Gauss and Kronrod sums differ.
std::vector<double> SunDisc::average_whole(double elevation, std::span<const double> floors,
                                           const Transmission& transmission) const {
  const std::size_t count = exponents_.size();
  std::vector<double> sum(count, 0.0), weight_sum(count, 0.0), gauss(count, 0.0), gauss_weight_sum(count, 0.0),
      values(count), weights(count);
  for (int i = 0; i < kronrod::points; ++i) {
    const auto [node, weight, gauss_weight] = kronrod::point(i);
    const double theta = 0.5 * pi * (1 + node);
    std::fill(weights.begin(), weights.end(), 1.0);
    weigh(std::sin(theta), weights);
    transmission(element(elevation, std::cos(theta)), values);
    for (std::size_t w = 0; w < count; ++w) {
      sum[w] += weight * weights[w] * values[w];
      weight_sum[w] += weight * weights[w];
      gauss[w] += gauss_weight * weights[w] * values[w];
      gauss_weight_sum[w] += gauss_weight * weights[w];
    }
  }
  for (std::size_t w = 0; w < count; ++w) {
    sum[w] /= weight_sum[w];
    if (std::abs(sum[w] - gauss[w] / gauss_weight_sum[w]) > tolerance_ * std::max(sum[w], floors[w])) return {};
  }
  return sum;
}

}  // namespace airlight::reference
