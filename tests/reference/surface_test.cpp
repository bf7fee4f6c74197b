#include "reference/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "atmospheres.h"
#include "reference/monte_carlo.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;
/// Passed by chance in 1 of 1e5 comparisons.
constexpr double far = 4.5;
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double off = 1e-3;  // of the surface [m]: far above the rounding of 6.4e6

/// Surfaces that differ in where they are hit alone.
class Grey : public Surface {
 public:
  explicit Grey(double albedo) : albedo_(albedo) {}
  bool hides(const Place& from) const override { return hit(from, endless).has_value(); }
  void albedo(const Vector&, std::span<double> albedo) const override {
    std::fill(albedo.begin(), albedo.end(), albedo_);
  }

 private:
  double albedo_;
};

/// Around the planet's centre.
class Sphere : public Grey {
 public:
  Sphere(double radius, double albedo) : Grey(albedo), radius_(radius) {}
  std::optional<Hit> hit(const Place& from, double farthest) const override {
    const double b = dot(from.position, from.direction), r = length(from.position);
    const double c = (r - radius_) * (r + radius_), square = b * b - c;
    if (c <= 0 || b >= 0 || square < 0) return std::nullopt;
    const double t = c / (-b + std::sqrt(square));
    if (t > farthest) return std::nullopt;
    const Vector normal = unit(along(from.position, t, from.direction));
    return Hit{t, along({}, radius_ + off, normal), normal};
  }

 private:
  double radius_;
};

/// A rectangle across the north: at `north` metres, from the ground up.
class Wall : public Grey {
 public:
  Wall(double planet_radius, double north, double half_width, double height, double albedo)
      : Grey(albedo), radius_(planet_radius), north_(north), half_width_(half_width), height_(height) {}
  std::optional<Hit> hit(const Place& from, double farthest) const override {
    const double t = (north_ - from.position[1]) / from.direction[1];
    if (!(t > 0 && t <= farthest)) return std::nullopt;
    Vector place = along(from.position, t, from.direction);
    if (std::abs(place[0]) > half_width_ || place[2] > radius_ + height_ || place[2] < radius_ - 100)
      return std::nullopt;
    const double side = from.direction[1] > 0 ? -1 : 1;
    place[1] = north_ + side * off;
    return Hit{t, place, {0, side, 0}};
  }

 private:
  double radius_, north_, half_width_, height_;
};

// A sphere 1 km above black ground is the ground of a planet 1 km larger: all orders, two wavelengths, all kinds of rays.
TEST(Surface, a_sphere_is_a_planets_ground) {
  const double wavelengths[] = {450, 650}, radius = 1e6, lift = 1e3, height = 6e3, albedo = 0.7;
  const auto air = [&](double ground_radius, double raised) {
    Atmosphere a = with(vacuum(ground_radius, 60e3 + raised), ExponentialProfile{height},
                        3e-5 * std::exp(raised / height), 2e-6 * std::exp(raised / height), RayleighPhase{0.03});
    return a;
  };
  Atmosphere plain = air(radius + lift, 0), raised = air(radius, lift);
  plain.planet.albedo = albedo;
  raised.planet.albedo = 0.0;
  const MonteCarlo expected(plain, wavelengths, {.seed = 1, .random_first_order = true}),
      solver(raised, wavelengths, {.seed = 2, .surface = std::make_shared<Sphere>(radius + lift, albedo)});
  const Ray rays[] = {{.altitude = 2, .view = towards(20, 30), .sun = towards(50)},
                      {.altitude = 2, .view = towards(-40, 30), .sun = towards(50)},
                      {.altitude = 2, .view = towards(10, 50), .sun = towards(-4)},
                      {.altitude = 10e3, .view = towards(-12, 80), .sun = towards(8)},
                      {.altitude = 300e3, .view = towards(-60, 80), .sun = towards(30)},
                      {.altitude = 5, .view = towards(-30, 80), .sun = towards(30), .distance = 4}};
  for (const Ray& ray : rays) {
    Ray higher = ray;
    higher.altitude += lift;
    const RandomLight a = expected.radiance(ray, {.walks = 8192}), b = solver.radiance(higher, {.walks = 8192});
    for (std::size_t w = 0; w < 2; ++w)
      EXPECT_NEAR(a.total.mean[w], b.total.mean[w],
                  far * std::hypot(a.total.standard_error[w], b.total.standard_error[w]))
          << ray.altitude;
    EXPECT_LT(b.total.standard_error[0], 0.05 * b.total.mean[0]);
  }
}

// In vacuum a wall has the radiance albedo / pi * irradiance * cosine on its lit side, and the ground lies in its shadow.
TEST(Surface, a_wall_is_lit_by_lamberts_law_and_throws_a_shadow) {
  const double radius = 6.371e6, albedo = 0.5;
  const Atmosphere none = with(vacuum(radius), layer(0, 1e3), 0, 0);
  const MonteCarlo solver(
      none, {&wavelength, 1},
      {.max_order = 1, .point_sun = true, .surface = std::make_shared<Wall>(radius, 1e3, 5e3, 2e3, albedo)});
  const auto radiance = [&](double elevation, double azimuth, const Direction& sun) {
    return solver.radiance({.altitude = 100, .view = towards(elevation, azimuth), .sun = sun}, {.walks = 64})
        .total.mean[0];
  };
  const Direction south = towards(30, 170), north = towards(30, 10);
  const double irradiance = none.sun.irradiance.at(wavelength), ground = none.planet.albedo.at(wavelength);
  EXPECT_NEAR(radiance(5, 20, south), albedo / pi * irradiance * -south[1], 1e-9) << "the lit wall";
  EXPECT_EQ(radiance(5, 20, north), 0) << "its dark side";
  EXPECT_NEAR(radiance(-30, 180, south), ground / pi * irradiance * 0.5, 1e-3) << "lit ground";  // 170 m of 6371 km
  EXPECT_EQ(radiance(-30, 180, north), 0) << "ground in the wall's shadow";
  EXPECT_EQ(radiance(70, 0, south), 0) << "over the wall: black space";
}

// Light scattered once in air that a wall shades, against a sum over points of the line.
TEST(Surface, shadows_in_the_air_agree_with_brute_force) {
  const double radius = 6.371e6, height = 8e3, scattering = 3e-5;
  Atmosphere air = with(vacuum(radius), ExponentialProfile{height}, scattering, 0, IsotropicPhase{});
  air.planet.albedo = 0.0;
  air.sun.irradiance = 1;
  const auto wall = std::make_shared<Wall>(radius, 3e3, 2e3, 1500, 0);
  const MonteCarlo solver(air, {&wavelength, 1}, {.max_order = 1, .point_sun = true, .surface = wall});
  const Direction sun = towards(12, 5);
  const auto altitude = [&](const Vector& place) { return length(place) - radius; };
  const auto optical_depth = [&](const Vector& from, const Direction& towards, double distance) {
    constexpr int steps = 300;
    double column = 0;
    for (int i = 0; i < steps; ++i)
      column += std::exp(-altitude(along(from, distance * (i + 0.5) / steps, towards)) / height);
    return scattering * column * distance / steps;
  };
  for (const Direction& view : {towards(10, 60), towards(20, 20), towards(3, 200), towards(25, -30)}) {
    const Ray ray{.altitude = 50, .view = view, .sun = sun, .distance = 20e3};
    const Place eye{{0, 0, radius + ray.altitude}, view};
    const auto hit = wall->hit(eye, ray.distance);
    const double end = hit ? hit->distance : ray.distance;
    constexpr int points = 2000;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double t = end * (i + 0.5) / points;
      const Vector place = along(eye.position, t, view);
      if (wall->hides({place, sun})) continue;
      // 400 km at this height of the sun: the air above 80 km, 5e-5 of it, is left out.
      const double depth = optical_depth(eye.position, view, t) + optical_depth(place, sun, 400e3);
      sum += scattering * std::exp(-altitude(place) / height) / (4 * pi) * std::exp(-depth) * end / points;
    }
    const RandomLight light = solver.path_radiance(ray, {.walks = 65536});
    EXPECT_NEAR(light.total.mean[0], sum,
                far * light.total.standard_error[0] + 1e-3 * sum);  // edges of shadows fall between points
    EXPECT_LE(light.total.standard_error[0], 0.01 * sum);
  }
}

}  // namespace
}  // namespace airlight::reference
