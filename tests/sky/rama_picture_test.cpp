// Rama's table of scattered light, as pictures use it.
#include <gtest/gtest.h>

#include "scenes.h"

namespace airlight::test {
namespace {

Camera square() {
  return {.projection = Projection::perspective, .width = 15, .height = 15, .altitude = 100, .azimuth = 180 * degree};
}
std::vector<float> picture(const std::shared_ptr<Engine>& engine, const Parameters& parameters,
                           const Camera& camera = square()) {
  return draw(Sky(built_in_atmosphere("earth"), "rama", engine, parameters), camera, {0, 0, 1});
}

TEST(RamaTable, is_made_once_for_each_air_and_light) {
  const auto engine = make_engine("simd");
  const auto made = [&] { return engine->passes_run("rama.source"); };
  picture(engine, {});
  ASSERT_EQ(made(), 1);
  Camera moved = square();
  moved.altitude = 4000, moved.azimuth = 0;
  picture(engine, {}, moved);
  picture(engine, {{"x", std::vector{12.0}}, {"phi", std::vector{10.0}}, {"exposure", std::vector{1.0}}});
  picture(engine, {{"samples", std::vector{8.0}}, {"albedo", std::vector{0.5}}, {"transmittance", "reference"}});
  EXPECT_EQ(made(), 1) << "nothing of this is in the table";
  picture(engine, {{"light", std::vector{1.0}}});
  EXPECT_EQ(made(), 2);
  picture(engine, {});
  EXPECT_EQ(made(), 2) << "the first table is still there";
}

// The middle of the slice is (10, 0, 0) km, of which G2.12 of the specification says what J is; corners lie outside the hull.
TEST(RamaSlice, shows_the_light_that_air_scatters) {
  const auto engine = make_engine("simd");
  const Parameters at{{"x", std::vector{10.0}}, {"show", "slice_across"}, {"source", "own"}};
  const auto own = picture(engine, at);
  const double luminance = 35000.0 / 133, expected[] = {0.195343, 0.433295, 0.928613};
  const float* const middle = &own[4 * (7 * 15 + 7)];
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(middle[c] / luminance, expected[c], 3e-4 * expected[c]);  // float
    EXPECT_EQ(own[c], 0);
  }
  // From the table it is nearly the same; along the axis the picture's middle is the middle of the sea.
  Parameters table = at;
  table["source"] = "texture";
  EXPECT_NEAR(picture(engine, table)[4 * (7 * 15 + 7) + 2], middle[2], 0.01 * middle[2]);
  table["show"] = "slice_along";
  const auto along = picture(engine, table);
  EXPECT_GT(along[4 * (7 * 15 + 7)], 0);
  EXPECT_LT(along[4 * (7 * 15 + 7)], middle[0]) << "the sea has no strips above it";
  EXPECT_EQ(along[0], 0);
}

}  // namespace
}  // namespace airlight::test
