// The passes of every model on every engine, on the tables that real air gives them, against double.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "airlight/sky.h"
#include "arguments.h"
#include "engines.h"

namespace airlight::test {
namespace {

struct Case {
  std::string_view model;
  std::string engine;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.model << " on " << c.engine; }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const ModelInfo& model : models()) {
    if (model.colours) continue;  // published systems have no air to be given: tests/model
    for (const std::string& engine : engine_names()) all.push_back({model.name, engine});
  }
  return all;
}

/// Observers on the ground, in the air and in space, each looking anywhere, the Sun down to 10 degrees below the horizon.
std::vector<Ray> draw_rays() {
  Random random;
  std::vector<Ray> rays;
  for (double altitude : {0.0, 2.0, 3000.0, 12000.0, 60000.0, 400000.0, 4e7}) {
    for (int i = 0; i < 16; ++i) {
      // Whole rays and segments; half of the views within a few degrees of the horizontal.
      const double elevation = (random.unit() - 0.5) * (i % 2 ? 0.2 : std::numbers::pi);
      const double sun = -0.17 + random.unit() * 1.7;
      rays.push_back({altitude, direction(random.unit() * 6.28, elevation), direction(random.unit() * 6.28, sun),
                      i % 4 < 2 ? std::numeric_limits<double>::infinity() : 100 * std::pow(1e4, random.unit())});
    }
  }
  return rays;
}

struct Differences {
  double median, most, worst;  ///< of the values; of 98 % of them; of all
};
/// Relative to the larger of the value and 1e-4 of the brightest.
template <class T>
Differences differences(const std::vector<T>& got, const std::vector<T>& expected) {
  double brightest = 0;
  for (const T v : expected) brightest = std::max(brightest, double(std::fabs(v)));
  std::vector<double> errors;
  for (std::size_t i = 0; i < got.size(); ++i) errors.push_back(error_of(got[i], expected[i], 1e-4 * brightest));
  std::ranges::sort(errors);
  return {errors[errors.size() / 2], errors[errors.size() * 98 / 100], errors.back()};
}

class Passes : public testing::TestWithParam<Case> {
 protected:
  // Float resolves 6e-8; a ray adds up some hundred terms of ln and exp, and its altitude, 1e5 m and more, is known to 1e-2 m. Rays that graze the
  // top of the air or the ground from space, and light that has been weakened e^10 times, lose more digits. Near the Sun's azimuth a cosine
  // known to 1e-7 means an angle known to 1e-5: 6e-5 where peaked light is looked up by it (precomputed, Mars' dust).
  static void expect_close(const char* what, const Differences& d) {
    std::printf("%-16s median %.1e  98 %% below %.1e  worst %.1e\n", what, d.median, d.most, d.worst);
    EXPECT_LT(d.median, 1e-6) << what;
    EXPECT_LT(d.most, 1e-4) << what;
    EXPECT_LT(d.worst, 3e-4) << what;
  }
};

TEST_P(Passes, answers_and_pictures_are_those_of_double) {
  AIRLIGHT_SKIP_WITHOUT(find_engine, GetParam().engine);
  const std::vector<Ray> rays = draw_rays();
  const std::vector<double> wavelengths{440, 550, 610, 680};
  for (const char* air : {"earth", "mars-clear"}) {
    SCOPED_TRACE(air);
    const Atmosphere atmosphere = built_in_atmosphere(air);
    // Full tables take minutes in double and on a GPU that is none.
    const Parameters parameters = GetParam().model == "precomputed" ? Parameters{{"detail", "draft"}} : Parameters{};
    const Sky sky(atmosphere, GetParam().model, find_engine(GetParam().engine).engine, parameters);
    const Sky truth(atmosphere, GetParam().model, find_engine("double").engine, parameters);
    const struct {
      const char* name;
      Quantity quantity;
      std::size_t rays;
    } questions[] = {{"radiance", Quantity::radiance, rays.size()},
                     {"transmittance", Quantity::transmittance, rays.size()},
                     {"sun irradiance", Quantity::sun_irradiance, rays.size()},
                     {"sky irradiance", Quantity::sky_irradiance, 8}};  // each costs 256 rays
    for (const auto& q : questions) {
      std::vector<double> expected(q.rays * wavelengths.size()), got(expected.size());
      const auto asked = std::span(rays).first(q.rays);
      truth.evaluate(q.quantity, asked, wavelengths, expected);
      sky.evaluate(q.quantity, asked, wavelengths, got);
      expect_close(q.name, differences(got, expected));
    }
    if (GetParam().model == "skyview") {
      // Aerial perspective, half of the map in shadow below 3 km: every pass with three coordinates, and the shadow's march.
      std::vector<Sight> points;
      for (const Ray& r : rays) points.push_back({r.view, r.distance, 0.25});
      const std::vector<float> edges{-9000, -8999, 3000, 3100, -9000, -8999, 3000, 3100};
      const AirShadows shadows{
          2, 2, std::make_shared<const std::vector<float>>(edges), {1e-6, 0, 0, 0.5}, {0, 1e-6, 0, 0.5}, 3100, 16};
      std::vector<double> light(points.size() * 4), through(light.size()), expected_light(light.size()),
          expected_through(light.size());
      truth.haze(500, direction(1, 0.1), points, wavelengths, &shadows, expected_light, expected_through);
      sky.haze(500, direction(1, 0.1), points, wavelengths, &shadows, light, through);
      expect_close("haze", differences(light, expected_light));
      expect_close("haze, through", differences(through, expected_through));
    }
    for (double altitude : {2.0, 4e5}) {
      const Camera camera{.width = 48, .height = 24, .altitude = altitude};
      std::vector<float> expected, got;
      const auto render = [&](const Sky& from, std::vector<float>& into) {
        from.render(camera, direction(0.3, 0.2), {.sun_disc = false, .wavelengths = {}},
                    [&](int, int, std::span<const float> rgba) {
                      for (std::size_t i = 0; i < rgba.size(); ++i) {
                        if (i % 4 != 3) into.push_back(rgba[i]);
                      }
                      return true;
                    });
      };
      render(truth, expected);
      render(sky, got);
      expect_close(altitude < 1e5 ? "picture" : "from space", differences(got, expected));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(models, Passes, testing::ValuesIn(cases()), [](const auto& tested) {
  return std::string(tested.param.model) + "_" + tested.param.engine;
});

}  // namespace
}  // namespace airlight::test
