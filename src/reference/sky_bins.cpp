#include "reference/sky_bins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

struct Cuts {
  GaussRule rule{SkyBins::half};
  std::array<double, SkyBins::half + 1> u{};
  Cuts() {
    for (int i = 0; i < SkyBins::half; ++i) u[i + 1] = u[i] + rule.weights[i];
    u.back() = 1;
  }
};
const Cuts& cuts() {
  static const Cuts made;
  return made;
}

/// From the horizon to the end of the half: how far cosines go.
double span_of(bool above, double horizon) { return above ? 1 - horizon : -1 - horizon; }

}  // namespace

SkyBins::Node SkyBins::node(int zenith, double horizon) {
  const bool above = zenith >= half;
  const int i = above ? zenith - half : zenith;
  const double u = cuts().rule.nodes[i], span = span_of(above, horizon);
  return {horizon + span * u * u, std::abs(span) * u * cuts().rule.weights[i]};
}

double SkyBins::azimuth(int bin) { return pi * (bin + 0.5) / azimuths; }

SkyAround::SkyAround(const Vector& position, const Vector& sun, double horizon, const SkyChances& chances)
    : up_(unit(position)), horizon_(horizon), chances_(chances) {
  const Vector level = along(sun, -dot(sun, up_), up_);
  // With the sun at the zenith all azimuths are alike.
  to_sun_ = dot(level, level) > 1e-12 ? unit(level) : across(up_).first;
  across_ = {up_[1] * to_sun_[2] - up_[2] * to_sun_[1], up_[2] * to_sun_[0] - up_[0] * to_sun_[2],
             up_[0] * to_sun_[1] - up_[1] * to_sun_[0]};
}

Vector SkyAround::draw(Random& random) const {
  const auto bin = std::min<std::ptrdiff_t>(
      std::upper_bound(chances_.begin(), chances_.end(), random()) - chances_.begin(), SkyBins::count - 1);
  const int zenith = int(bin) / SkyBins::azimuths, i = zenith % SkyBins::half;
  const double u = cuts().u[i] + random() * (cuts().u[i + 1] - cuts().u[i]);
  const double cosine = std::clamp(horizon_ + span_of(zenith >= SkyBins::half, horizon_) * u * u, -1.0, 1.0);
  const double side = 2 * random() - 1;
  const double azimuth =
      std::copysign(pi * (double(bin % SkyBins::azimuths) + std::abs(side)) / SkyBins::azimuths, side);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return unit(
      along(along(along({}, cosine, up_), sine * std::cos(azimuth), to_sun_), sine * std::sin(azimuth), across_));
}

double SkyAround::density(const Vector& direction) const {
  const double cosine = dot(direction, up_), span = span_of(cosine > horizon_, horizon_);
  const double u = std::clamp(std::sqrt((cosine - horizon_) / span), 1e-12, 1.0);
  const int i =
      std::min(int(std::upper_bound(cuts().u.begin(), cuts().u.end(), u) - cuts().u.begin()) - 1, SkyBins::half - 1);
  const double azimuth = std::abs(std::atan2(dot(direction, across_), dot(direction, to_sun_)));
  const int bin = (i + (cosine > horizon_ ? SkyBins::half : 0)) * SkyBins::azimuths +
                  std::min(int(azimuth / pi * SkyBins::azimuths), SkyBins::azimuths - 1);
  const double chance = chances_[bin] - (bin > 0 ? chances_[bin - 1] : 0);
  const double solid_angle = 2 * std::abs(span) * u * (cuts().u[i + 1] - cuts().u[i]) * 2 * pi / SkyBins::azimuths;
  return chance / solid_angle;
}

}  // namespace airlight::reference
