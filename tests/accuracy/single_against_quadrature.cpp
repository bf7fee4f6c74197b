// The model `single` against the converged quadrature, on every engine of the CPU. AIRLIGHT_LONG_TESTS=1: all 300 rays;
// else a third of each group, in turn, so that all kinds of rays remain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "airlight/sky.h"
#include "rays.h"
#include "reference/single_scattering.h"

namespace airlight {
namespace {

/// All rays and the reference's answers; solved once for all tests.
struct Yardstick {
  struct Group {
    accuracy::RayGroup drawn;
    std::vector<reference::RayLight> lights;
    std::vector<double> brightest;  // path radiance, by wavelength
  };
  std::vector<Group> groups;
};

const Yardstick& yardstick() {
  static const Yardstick made = [] {
    Yardstick yardstick;
    const std::size_t step = std::getenv("AIRLIGHT_LONG_TESTS") ? 1 : 3;
    for (accuracy::RayGroup& drawn : accuracy::draw_rays()) {
      std::vector<Ray> rays;
      for (std::size_t i = yardstick.groups.size() % step; i < drawn.rays.size(); i += step)
        rays.push_back(drawn.rays[i]);
      drawn.rays = rays;
      // A hundredth of the smallest bound below.
      const reference::SingleScattering solver(built_in_atmosphere(drawn.atmosphere), {.tolerance = 1e-5});
      Yardstick::Group group{drawn, {}, std::vector<double>(accuracy::wavelengths.size(), 0.0)};
      for (const Ray& ray : drawn.rays) {
        group.lights.push_back(solver.along(ray, accuracy::wavelengths));
        for (std::size_t w = 0; w < accuracy::wavelengths.size(); ++w)
          group.brightest[w] = std::max(group.brightest[w], group.lights.back().path_radiance[w]);
      }
      yardstick.groups.push_back(std::move(group));
    }
    return yardstick;
  }();
  return made;
}

/// One ray's errors, the worst of its wavelengths.
struct RayError {
  const accuracy::RayGroup* group;
  const Ray* ray;
  double transmittance = 0;                     // absolute
  double path_radiance = 0;                     // relative to the larger of the value and 1e-4 of the group's brightest
  double wavelength = 0, value = 0, truth = 0;  // where path_radiance is worst
};

std::vector<RayError> errors_of(std::string_view model, std::string_view engine_name) {
  const auto& wavelengths = accuracy::wavelengths;
  const std::shared_ptr<Engine> engine = make_engine(engine_name);
  std::vector<RayError> errors;
  for (const Yardstick::Group& group : yardstick().groups) {
    const auto& rays = group.drawn.rays;
    const Sky sky(built_in_atmosphere(group.drawn.atmosphere), model, engine);
    std::vector<double> transmittance(rays.size() * wavelengths.size()), radiance(transmittance.size());
    sky.evaluate(Quantity::transmittance, rays, wavelengths, transmittance);
    sky.evaluate(Quantity::path_radiance, rays, wavelengths, radiance, 1);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RayError error{&group.drawn, &rays[i]};
      for (std::size_t w = 0; w < wavelengths.size(); ++w) {
        const double t = transmittance[i * wavelengths.size() + w], value = radiance[i * wavelengths.size() + w];
        const double truth = group.lights[i].path_radiance[w], scale = std::max(truth, 1e-4 * group.brightest[w]);
        const double relative = scale > 0 ? std::abs(value - truth) / scale : value == 0 ? 0 : INFINITY;
        error.transmittance = std::max(error.transmittance, std::abs(t - group.lights[i].transmittance[w]));
        if (!(relative <= error.path_radiance)) {  // NaN counts as worst
          error.path_radiance = std::isnan(relative) ? INFINITY : relative;
          error.wavelength = wavelengths[w], error.value = value, error.truth = truth;
        }
      }
      errors.push_back(error);
    }
  }
  return errors;
}

double percentile(const std::vector<RayError>& errors, double part) {
  std::vector<double> values;
  for (const RayError& error : errors) values.push_back(error.path_radiance);
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(part * double(values.size())))];
}

void print(const std::vector<RayError>& errors, const char* title) {
  double transmittance = 0;
  for (const RayError& error : errors) transmittance = std::max(transmittance, error.transmittance);
  std::printf("%-34s %4zu  %9.1e  %8.3f %% %8.3f %% %8.3f %%\n", title, errors.size(), transmittance,
              100 * percentile(errors, 0.5), 100 * percentile(errors, 0.9), 100 * percentile(errors, 1));
}

template <class Keep>
void print_those(const std::vector<RayError>& errors, const char* title, Keep keep) {
  std::vector<RayError> some;
  std::copy_if(errors.begin(), errors.end(), std::back_inserter(some), keep);
  if (!some.empty()) print(some, title);
}

class SingleAgainstQuadrature : public testing::TestWithParam<const char*> {};

TEST_P(SingleAgainstQuadrature, is_within_the_stated_errors) {
  std::vector<RayError> errors = errors_of("single", GetParam());
  std::printf("single (%s), seed %u           rays  transm.   path radiance: median, 90 %%, worst\n", GetParam(),
              accuracy::seed);
  print(errors, "all");
  for (const char* name : {"earth", "earth-hazy", "mars-clear"})
    print_those(errors, name, [&](const RayError& e) { return e.group->atmosphere == name; });
  print_those(errors, "segments", [](const RayError& e) { return std::isfinite(e.ray->distance); });
  print_those(errors, "sun 3 degrees up or higher", [](const RayError& e) { return e.group->sun_elevation_deg >= 3; });
  print_those(errors, "sun from 0.5 up to 3 down",
              [](const RayError& e) { return std::abs(e.group->sun_elevation_deg + 1.25) < 2; });
  print_those(errors, "sun 5 to 8 degrees down", [](const RayError& e) { return e.group->sun_elevation_deg <= -5; });

  std::sort(errors.begin(), errors.end(),
            [](const RayError& a, const RayError& b) { return a.path_radiance > b.path_radiance; });
  std::printf("The ten worst:\n");
  for (std::size_t i = 0; i < 10; ++i)
    std::printf("%8.3f %%  %s  at %g nm: %.6g, reference %.6g\n", 100 * errors[i].path_radiance,
                accuracy::describe(*errors[i].group, *errors[i].ray).c_str(), errors[i].wavelength, errors[i].value,
                errors[i].truth);

  // The project's bounds: a hundredth of a display's step in transmittance, below what the eye tells apart in radiance.
  for (const RayError& error : errors)
    EXPECT_LE(error.transmittance, 1e-5) << accuracy::describe(*error.group, *error.ray);
  EXPECT_LE(percentile(errors, 0.5), 0.002);
  EXPECT_LE(percentile(errors, 0.9), 0.01);
  EXPECT_LE(percentile(errors, 1), 0.05);
}

INSTANTIATE_TEST_SUITE_P(engines, SingleAgainstQuadrature, testing::Values("double", "simd"),
                         [](const auto& engine) { return std::string(engine.param); });

}  // namespace
}  // namespace airlight
