// Density over altitude: values, exact means, and the altitudes where a profile is not smooth.
#include <algorithm>
#include <cmath>

#include "airlight/atmosphere.h"
#include "optics/standard_atmosphere.h"

namespace airlight {
namespace {

// ---- value at an altitude of 0 or more ----

double value(const ExponentialProfile& profile, double altitude) { return std::exp(-altitude / profile.scale_height); }

double value(const TentProfile& profile, double altitude) {
  return std::max(0.0, 1 - std::abs(altitude - profile.altitude) / profile.half_width);
}

double value(const LayersProfile& profile, double altitude) {
  for (const LayersProfile::Layer& layer : profile.layers) {
    if (altitude >= layer.bottom && altitude < layer.top) return layer.density;
  }
  return 0;
}

bool is_logarithmic(const TableProfile& profile, std::size_t above) {
  return profile.logarithmic && profile.densities[above - 1] > 0 && profile.densities[above] > 0;
}

double between(const TableProfile& profile, std::size_t above, double altitude) {
  const double low = profile.densities[above - 1], high = profile.densities[above];
  const double bottom = profile.altitudes[above - 1], top = profile.altitudes[above];
  const double part = (altitude - bottom) / (top - bottom);
  if (is_logarithmic(profile, above)) return low * std::exp(part * std::log(high / low));
  return std::lerp(low, high, part);
}

double value(const TableProfile& profile, double altitude) {
  const auto above = std::upper_bound(profile.altitudes.begin(), profile.altitudes.end(), altitude);
  if (above == profile.altitudes.begin()) return profile.densities.front();
  if (above == profile.altitudes.end()) return altitude == profile.altitudes.back() ? profile.densities.back() : 0;
  return between(profile, std::size_t(above - profile.altitudes.begin()), altitude);
}

double value(const StandardAtmosphereProfile&, double altitude) {
  return altitude <= standard_atmosphere::top ? standard_atmosphere::density(altitude) : 0;
}

// ---- altitudes, in any order, where a profile or its slope jumps ----

std::vector<double> edges(const ExponentialProfile&) { return {}; }

std::vector<double> edges(const TentProfile& profile) {
  return {profile.altitude - profile.half_width, profile.altitude, profile.altitude + profile.half_width};
}

std::vector<double> edges(const LayersProfile& profile) {
  std::vector<double> altitudes;
  for (const LayersProfile::Layer& layer : profile.layers) altitudes.insert(altitudes.end(), {layer.bottom, layer.top});
  return altitudes;
}

std::vector<double> edges(const TableProfile& profile) { return profile.altitudes; }

std::vector<double> edges(const StandardAtmosphereProfile&) {
  std::vector<double> altitudes = standard_atmosphere::edges();
  altitudes.push_back(standard_atmosphere::top);
  return altitudes;
}

// ---- mean over an interval above 0 that holds no edge inside ----

/// (1 - exp(-x)) / x
double mean_decay(double x) { return std::abs(x) < 1e-8 ? 1 - x / 2 : -std::expm1(-x) / x; }

double smooth_mean(const ExponentialProfile& profile, double from, double to) {
  return value(profile, from) * mean_decay((to - from) / profile.scale_height);
}

// The middle's value is the mean of what is linear, and lies safely inside the piece: at a layer's edge two values
// meet.
template <typename PiecewiseLinear>
double smooth_mean(const PiecewiseLinear& profile, double from, double to) {
  return value(profile, from + (to - from) / 2);
}

double smooth_mean(const TableProfile& profile, double from, double to) {
  const double middle = from + (to - from) / 2;
  const auto above = std::upper_bound(profile.altitudes.begin(), profile.altitudes.end(), middle);
  if (above == profile.altitudes.begin() || above == profile.altitudes.end()) return value(profile, middle);
  const std::size_t i = std::size_t(above - profile.altitudes.begin());
  const double low = between(profile, i, from), high = between(profile, i, to);
  return is_logarithmic(profile, i) ? low * mean_decay(std::log(low / high)) : low + (high - low) / 2;
}

double smooth_mean(const StandardAtmosphereProfile& profile, double from, double to) {
  if (from + (to - from) / 2 > standard_atmosphere::top) return value(profile, to);
  return standard_atmosphere::mean_density(from, to);
}

template <typename Shape>
double mean(const Shape& profile, double from, double to) {
  std::vector<double> ends = edges(profile);
  std::erase_if(ends, [&](double altitude) { return !(altitude > from && altitude < to); });
  ends.push_back(to);
  std::sort(ends.begin(), ends.end());
  double sum = 0, below = from;
  for (const double end : ends) {
    if (end > below) sum += smooth_mean(profile, below, end) * (end - below);
    below = end;
  }
  return sum / (to - from);
}

}  // namespace

double density(const Profile& profile, double altitude) {
  return std::visit([&](const auto& shape) { return value(shape, std::max(0.0, altitude)); }, profile);
}

double mean_density(const Profile& profile, double from, double to) {
  if (from > to) std::swap(from, to);
  if (to <= 0 || from == to) return density(profile, to);
  const double above = std::visit([&](const auto& shape) { return mean(shape, std::max(0.0, from), to); }, profile);
  if (from >= 0) return above;
  const double below = density(profile, 0);  // continues downwards
  return std::lerp(below, above, to / (to - from));
}

std::vector<double> kinks(const Profile& profile, double top) {
  std::vector<double> altitudes = std::visit([](const auto& shape) { return edges(shape); }, profile);
  std::erase_if(altitudes, [&](double altitude) { return !(altitude > 0 && altitude < top); });
  std::sort(altitudes.begin(), altitudes.end());
  altitudes.erase(std::unique(altitudes.begin(), altitudes.end()), altitudes.end());
  return altitudes;
}

}  // namespace airlight
