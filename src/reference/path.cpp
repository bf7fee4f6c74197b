#include "reference/path.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "airlight/error.h"

namespace airlight::reference {
namespace {

Direction normalised(const Direction& d) {
  const double length = std::hypot(d[0], d[1], d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}
double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

void check(const Ray& ray, double planet_radius) {
  const auto refuse = [](const std::string& key, double value, const std::string& range) {
    throw InputError("ray: " + key + " is " + std::to_string(value) + "; legal: " + range);
  };
  if (!std::isfinite(ray.altitude) || ray.altitude <= 1 - planet_radius)
    refuse("altitude", ray.altitude,
           "finite, more than 1 m from the planet's centre (" + std::to_string(1 - planet_radius) + " m)");
  if (!(ray.distance >= 0)) refuse("distance", ray.distance, "0 m or more, infinite included");
  for (const auto& [key, d] : {std::pair{"view", ray.view}, std::pair{"sun", ray.sun}}) {
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!std::isfinite(length) || length == 0) refuse(std::string("length of ") + key, length, "finite, above 0");
  }
}

Path::Path(const Ray& ray, const Air& air) : view_(normalised(ray.view)), sun_(normalised(ray.sun)) {
  check(ray, air.planet_radius());
  ground_radius = air.planet_radius() + (ray.altitude < 0 ? ray.altitude - 1 : 0);
  const double radius = air.planet_radius() + ray.altitude;
  const double sin_zenith = std::hypot(view_[0], view_[1]);
  impact = radius * sin_zenith;
  observer_ = radius * view_[2];
  // The foot of the perpendicular from the centre: radius * (z - view (z . view)), z^2 = 1 - (z . view)^2 without
  // cancellation.
  lowest_ = {-observer_ * view_[0], -observer_ * view_[1], impact * sin_zenith};

  const Direction apart{view_[0] - sun_[0], view_[1] - sun_[1], view_[2] - sun_[2]};
  one_minus_cos = std::min(0.5 * dot(apart, apart), 2.0);

  const double top = half_chord(air.top_radius(), impact);
  begin = std::clamp(observer_, -top, top);
  end = std::clamp(observer_ + ray.distance, begin, std::max(begin, top));
  // A ray meets the ground where it comes down on it; the height c over the ground keeps a ray that starts on it exact.
  const double c = (radius - ground_radius) * (radius + ground_radius);
  const double discriminant = observer_ * observer_ - c;
  meets_ground = false;
  if (observer_ < 0 && discriminant > 0) {
    const double distance = c / (-observer_ + std::sqrt(discriminant));
    if (distance <= ray.distance) {
      meets_ground = true;
      end = std::max(begin, observer_ + distance);
    }
  }
}

Illuminated Path::at(double t) const {
  const Direction p{lowest_[0] + t * view_[0], lowest_[1] + t * view_[1], lowest_[2] + t * view_[2]};
  const Direction across{p[1] * sun_[2] - p[2] * sun_[1], p[2] * sun_[0] - p[0] * sun_[2],
                         p[0] * sun_[1] - p[1] * sun_[0]};
  const double radius = std::hypot(impact, t);
  return {radius, std::atan2(dot(p, sun_), std::sqrt(dot(across, across))),
          std::atan2(half_chord(radius, ground_radius), ground_radius)};
}

// Points P whose sun ray, tilted by `offset` towards the zenith, has the given radius at its lowest point: with p = P .
// sun and q = |P x sun|, q cos(offset) - p sin(offset) = radius, a quadratic equation in t when q^2 = |P|^2 - p^2 is
// put in.
void Path::add_grazing_points(double radius, double offset, std::vector<double>& breaks) const {
  const double sine = std::sin(offset), cosine = std::cos(offset);
  const double p0 = dot(lowest_, sun_), slope = dot(view_, sun_);
  const double a = (cosine - slope) * (cosine + slope);
  const double half_b = -slope * (p0 + radius * sine);
  const double c = (impact * cosine - radius) * (impact * cosine + radius) - p0 * (p0 + 2 * radius * sine);
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0 || a == 0) return;
  const double sum = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  for (const double t : {sum / a, sum != 0 ? c / sum : 0.0}) {
    if (!(t > begin && t < end)) continue;
    const double p = p0 + t * slope;
    const bool ahead = p * cosine < std::abs(sine) * std::hypot(impact, t);  // else the lowest point lies behind P
    if (ahead) breaks.push_back(t);
  }
}

std::vector<double> Path::breaks(const Air& air, double sun_radius) const {
  std::vector<double> breaks{begin, end};
  const auto add = [&](double t) {
    if (t > begin && t < end) breaks.push_back(t);
  };
  add(0);
  for (const double radius : air.landmarks()) {
    const double t = half_chord(radius, impact);
    if (t > 0) {
      add(-t);
      add(t);
    }
  }
  const auto add_grazing = [&](double radius) {
    add_grazing_points(radius, sun_radius, breaks);
    if (sun_radius > 0) add_grazing_points(radius, -sun_radius, breaks);
  };
  add_grazing(ground_radius);
  for (const double jump : air.jumps()) add_grazing(jump);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

}  // namespace airlight::reference
