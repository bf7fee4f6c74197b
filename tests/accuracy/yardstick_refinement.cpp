// The quadrature against its own refinement on the yardstick's rays: twice the nodes and parts and a tenth of the
// tolerance change nothing above 1e-6. AIRLIGHT_LONG_TESTS=1: all 484 rays (ten minutes: 1.2e-7 at most); else every 52nd, which meets
// day, sunset and twilight on all three atmospheres.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "reference/single_scattering.h"
#include "validate/yardstick.h"

namespace airlight {
namespace {

using reference::SingleScattering;

struct Solvers {
  explicit Solvers(const Atmosphere& air)
      : plain(air), fine(air, {.tolerance = 0.1 * reference::SingleScatteringSettings().tolerance, .fineness = 2}) {}
  SingleScattering plain, fine;
};

TEST(YardstickRefinement, changes_less_than_1e_minus_6) {
  std::ifstream file(AIRLIGHT_YARDSTICK);
  ASSERT_TRUE(file) << AIRLIGHT_YARDSTICK;
  const int step = std::getenv("AIRLIGHT_LONG_TESTS") ? 1 : 52;
  std::map<std::string, std::unique_ptr<Solvers>> solvers;
  double worst = 0;
  int count = 0, solved = 0;
  for (std::string text; std::getline(file, text); ++count) {
    if (count % step != 0) continue;
    const auto line = nlohmann::ordered_json::parse(text);
    const Ray ray = validation::read_ray(line);
    const auto wavelengths = line.at("wavelengths").get<std::vector<double>>();
    auto& pair = solvers[line.at("atmosphere")];
    if (!pair) pair = std::make_unique<Solvers>(built_in_atmosphere(line.at("atmosphere").get<std::string>()));
    const reference::RayLight a = pair->plain.along(ray, wavelengths), b = pair->fine.along(ray, wavelengths);
    const auto compare = [&](const std::vector<double>& value, const std::vector<double>& refined, const char* what) {
      for (std::size_t w = 0; w < wavelengths.size(); ++w) {
        if (refined[w] < 1e-200) continue;  // near the smallest double: rounding, not quadrature
        const double change = std::abs(value[w] / refined[w] - 1);
        worst = std::max(worst, change);
        EXPECT_LT(change, 1e-6) << what << " at " << wavelengths[w] << " nm of " << text;
      }
    };
    compare(a.transmittance, b.transmittance, "transmittance");
    compare(a.path_radiance, b.path_radiance, "path radiance");
    compare(a.ground_radiance, b.ground_radiance, "ground radiance");
    ++solved;
  }
  EXPECT_EQ(count, 484);
  std::printf("worst relative change of %d rays: %.1e\n", solved, worst);
}

}  // namespace
}  // namespace airlight
