#include "reference/cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "airlight/error.h"

namespace airlight::reference {
namespace {

template <class... Words>
std::string text(const Words&... words) {
  std::ostringstream out;
  (out << ... << words);
  return out.str();
}

double density_at(const Cloud& cloud, const Vector& place) {
  const double density = cloud.density(place);
  if (!(density >= 0 && density <= 1))
    throw WorkError(text("cloud: density is ", density, " at (", place[0], ", ", place[1], ", ", place[2],
                         ") m from the planet's centre; legal: 0 .. 1"));
  return density;
}

/// Visits places along a line that would be collisions if density were 1, until `visit` returns false.
template <class Visit>
void visit_places(const Cloud& cloud, const Place& from, double to, Random& random, Visit visit) {
  const auto [begin, end] = cloud.box.inside(from);
  double t = begin;
  while (true) {
    t -= std::log1p(-random()) / cloud.extinction;
    if (!(t < std::min(end, to)) || !visit(t, density_at(cloud, along(from.position, t, from.direction)))) return;
  }
}

}  // namespace

std::pair<double, double> Box::inside(const Place& from) const {
  double begin = 0, end = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double x = from.position[k], slope = from.direction[k];
    if (slope == 0) {
      if (x < low[k] || x > high[k]) return {0, 0};
      continue;
    }
    const double a = (low[k] - x) / slope, b = (high[k] - x) / slope;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return {begin, end};
}

void validate(const Cloud& cloud) {
  if (!cloud.density) throw InputError("cloud: density is missing; expected a function");
  if (!(cloud.extinction > 0 && std::isfinite(cloud.extinction)))
    throw InputError(text("cloud: extinction is ", cloud.extinction, " 1/m; legal: above 0"));
  for (int k = 0; k < 3; ++k)
    if (!(cloud.box.low[k] < cloud.box.high[k] && std::isfinite(cloud.box.high[k] - cloud.box.low[k])))
      throw InputError(text("cloud: box reaches from ", cloud.box.low[k], " to ", cloud.box.high[k], " m along ",
                            "xyz"[k], "; expected low < high"));
}

DensityGrid::DensityGrid(const Box& box, std::array<int, 3> counts, std::vector<double> values)
    : box_(box), counts_(counts), values_(std::move(values)) {
  std::size_t cells = 1;
  for (const int count : counts) {
    if (count < 2) throw InputError(text("density grid: ", count, " corners along an axis; legal: 2 or more"));
    cells *= std::size_t(count);
  }
  if (values_.size() != cells)
    throw InputError(text("density grid: ", values_.size(), " values; expected ", cells, " = ", counts[0], " x ",
                          counts[1], " x ", counts[2]));
  for (std::size_t i = 0; i < cells; ++i)
    if (!(values_[i] >= 0 && values_[i] <= 1))
      throw InputError(text("density grid: values[", i, "] is ", values_[i], "; legal: 0 .. 1"));
}

double DensityGrid::operator()(const Vector& place) const {
  std::size_t corner = 0, stride = 1, steps[3];
  double shares[3];
  for (int k = 0; k < 3; ++k) {
    const double x = (place[k] - box_.low[k]) / (box_.high[k] - box_.low[k]) * (counts_[k] - 1);
    const int i = std::clamp(int(x), 0, counts_[k] - 2);
    shares[k] = std::clamp(x - i, 0.0, 1.0);
    corner += std::size_t(i) * stride;
    steps[k] = stride;
    stride *= std::size_t(counts_[k]);
  }
  double density = 0;
  for (int i = 0; i < 8; ++i) {
    std::size_t at = corner;
    double weight = 1;
    for (int k = 0; k < 3; ++k) {
      const bool high = i >> k & 1;
      weight *= high ? shares[k] : 1 - shares[k];
      if (high) at += steps[k];
    }
    density += weight * values_[at];
  }
  return std::min(density, 1.0);  // weights add to 1 but for rounding
}

double draw_collision(const Cloud& cloud, const Place& from, double to, Random& random) {
  double collision = std::numeric_limits<double>::infinity();
  visit_places(cloud, from, to, random, [&](double t, double density) {
    if (random() >= density) return true;
    collision = t;
    return false;
  });
  return collision;
}

double draw_transmittance(const Cloud& cloud, const Place& from, double to, Random& random) {
  double transmittance = 1;
  visit_places(cloud, from, to, random, [&](double, double density) {
    transmittance *= 1 - density;
    // What is nearly dark is finished by Russian roulette, so that thick clouds cost no more than a few steps.
    constexpr double dark = 0.01;
    if (transmittance < dark && transmittance > 0) transmittance = random() * dark < transmittance ? dark : 0;
    return transmittance > 0;
  });
  return transmittance;
}

}  // namespace airlight::reference
