#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "atmospheres.h"

namespace airlight::reference {
namespace {

// Random rays of every kind: up, along the horizon, down, past the limb; sun from the zenith to 8 degrees below the
// horizon.
Ray random_ray(std::mt19937& random, int kind, double planet_radius) {
  const auto between = [&](double low, double high) { return low + (high - low) * double(random()) * 0x1p-32; };
  Ray ray;
  ray.altitude = between(0, 1) < 0.2 ? 0 : std::pow(10, between(0, std::log10(400e3)));
  const double dip = std::acos(planet_radius / (planet_radius + ray.altitude)) / degree;
  const double limb = planet_radius + between(0, std::min(90e3, ray.altitude));
  const double elevation = kind == 0   ? between(0, 90)
                           : kind == 1 ? -dip + between(-1, 1)
                           : kind == 2 ? between(-90, -dip)
                                       : -std::acos(limb / (planet_radius + ray.altitude)) / degree;
  ray.view = towards(elevation, between(0, 360));
  ray.sun = towards(between(0, 1) < 0.5 ? between(-8, 3) : between(3, 90));
  if (between(0, 1) < 0.4) ray.distance = std::pow(10, between(2, 5));
  return ray;
}

// The claim of the header: twice the nodes and parts and a tenth of the tolerance change nothing above 1e-6.
// Profiles with many corners (earth), with three (earth-bruneton), with none (mars-clear). AIRLIGHT_LONG_TESTS=1: 102
// rays in place of 24.
TEST(Refinement, doubling_everything_changes_less_than_1e_minus_6) {
  constexpr unsigned seed = 20;
  const double wavelengths[] = {400, 480, 560, 680};
  std::mt19937 random(seed);
  double worst = 0;
  int solved = 0;
  for (const auto* name : {"earth", "earth-bruneton", "mars-clear"}) {
    const Atmosphere atmosphere = built_in_atmosphere(name);
    const SingleScattering plain(atmosphere),
        fine(atmosphere, {.tolerance = 0.1 * SingleScatteringSettings().tolerance, .fineness = 2});
    const int rays = std::getenv("AIRLIGHT_LONG_TESTS") ? 34 : 8;
    for (int i = 0; i < rays; ++i, ++solved) {
      const Ray ray = random_ray(random, i % 4, atmosphere.planet.ground_radius);
      const RayLight a = plain.along(ray, wavelengths), b = fine.along(ray, wavelengths);
      const auto sun_a = plain.sun_irradiance(ray, wavelengths), sun_b = fine.sun_irradiance(ray, wavelengths);
      const auto compare = [&](double value, double refined, const char* what) {
        if (refined < 1e-200) return;  // near the smallest double: rounding, not quadrature
        const double error = std::abs(value / refined - 1);
        worst = std::max(worst, error);
        EXPECT_LT(error, 1e-6) << what << ", seed " << seed << ", " << name << ", ray " << i;
      };
      for (int w = 0; w < 4; ++w) {
        compare(a.transmittance[w], b.transmittance[w], "transmittance");
        compare(a.path_radiance[w], b.path_radiance[w], "path radiance");
        compare(a.ground_radiance[w], b.ground_radiance[w], "ground radiance");
        compare(sun_a[w], sun_b[w], "sun irradiance");
      }
    }
  }
  RecordProperty("worst_relative_change", std::to_string(worst));
  std::printf("worst relative change of %d rays: %.1e\n", solved, worst);
}

}  // namespace
}  // namespace airlight::reference
