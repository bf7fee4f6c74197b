// Key frames: values between them, and what is said of wrong ones.
#include "scenefile/animation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airlight/error.h"
#include "scene/sun_position.h"
#include "scenefile/key_frames.h"

namespace airlight {
namespace {

constexpr char scene[] = R"(place = "46.6,7.9"
[camera]
altitude = 300
position = [0, -5000]
[sun]
time = "2026-06-21T10:00Z"
)";

Animation animation(const std::string& keys) { return {scene + keys, "scene.toml", 24}; }

TEST(KeyFrames, smooth_ones_pass_through_their_keys_at_rest_and_never_beyond) {
  const KeyFrames keys{{0, 1, 3, 4, 10}, {0, 2, 3, 3, -1}, KeyFrames::Interpolation::smooth};
  for (std::size_t i = 0; i < keys.at.size(); ++i) EXPECT_EQ(keys.value(keys.at[i]), keys.values[i]);
  double before = keys.value(0);
  for (int i = 1; i <= 10'000; ++i) {
    const double t = i * 1e-3, value = keys.value(t);
    EXPECT_LE(std::abs(value - before), 0.005);  // slopes up to 3: continuous
    EXPECT_TRUE(t > 3 || value >= before) << t;  // monotone where the keys are
    EXPECT_TRUE(t < 4 || value <= before) << t;
    before = value;
  }
  // It starts and ends at rest: a quadratic beginning, so half the time gives a quarter of the way.
  EXPECT_NEAR(keys.value(0.02) / keys.value(0.01), 4, 0.1);
  EXPECT_NEAR((keys.value(9.98) + 1) / (keys.value(9.99) + 1), 4, 0.1);
  // A straight line stays one inside: the harmonic mean of equal slopes is that slope.
  const KeyFrames line{{0, 1, 2, 3}, {0, 1, 2, 3}, KeyFrames::Interpolation::smooth};
  EXPECT_NEAR(line.value(1.3), 1.3, 1e-12);
}

TEST(KeyFrames, linear_ones_are_straight_and_hold_their_ends) {
  const KeyFrames keys{{1, 3}, {10, 20}};
  EXPECT_EQ(keys.value(0), 10);
  EXPECT_DOUBLE_EQ(keys.value(1.5), 12.5);
  EXPECT_EQ(keys.value(99), 20);
}

TEST(Animation, numbers_and_elements_of_lists_move) {
  const Animation moving = animation(R"(
[[animate]]
key = "camera.altitude"
frames = [0, 10]
values = [300, 800]
[[animate]]
key = "camera.position[1]"
times = [0, 0.5]
values = [-5000, -4000]
[[animate]]
key = "picture.exposure"
frames = [0]
values = [-13]
)");
  const Animation::Frame frame = moving.frame(3);
  EXPECT_DOUBLE_EQ(*frame.scene.camera.altitude, 450);
  EXPECT_DOUBLE_EQ((std::get<std::array<double, 2>>(frame.scene.camera.spot)[1]), -4750);  // 3 of 12 frames
  EXPECT_EQ(frame.scene.picture.exposure_ev, -13);
  EXPECT_EQ(moving.frame(12).text, moving.frame(24).text);
  EXPECT_NE(moving.frame(3).text, moving.frame(4).text);
  EXPECT_FALSE(moving.changes_land());
}

TEST(Animation, the_sun_goes_by_its_own_key_frames_or_by_a_time_of_day) {
  const auto minutes = [](const Time& a, const char* b) {
    const Time end = parse_time(b);
    return 1440 * ((a.day - end.day) + (a.fraction - end.fraction));
  };
  const Animation keys = animation(R"(
[[animate]]
key = "sun.time"
frames = [0, 10]
values = ["2026-06-21T23:00Z", "2026-06-22T01:00+00:00"]
)");
  EXPECT_NEAR(minutes(*keys.frame(5).scene.sun.time, "2026-06-22T00:00Z"), 0, 1e-4);
  Animation day = animation("");
  day.set_time_of_day("04:30", "2026-06-21T12:30+02:00", 13);
  EXPECT_NEAR(minutes(*day.frame(0).scene.sun.time, "2026-06-21T04:30Z"), 0, 1e-4);
  EXPECT_NEAR(minutes(*day.frame(12).scene.sun.time, "2026-06-21T10:30Z"), 0, 1e-4);
  EXPECT_NEAR(minutes(*day.frame(3).scene.sun.time, "2026-06-21T06:00Z"), 0, 1e-4);
}

TEST(Animation, mistakes_are_named_with_line_and_key) {
  const struct {
    const char* keys;
    const char* says;
  } cases[] = {
      {"[[animate]]\nkey = \"camera.altitud\"\nframes = [0]\nvalues = [1]\n", "did you mean altitude"},
      {"[[animate]]\nkey = \"camera.field_of_view\"\nframes = [0, 9]\nvalues = [30, 200]\n", "(frame 9)"},
      {"[[animate]]\nkey = \"camera.position[2]\"\nframes = [0]\nvalues = [1]\n", "scene.toml:8: animate[0].key"},
      {"[[animate]]\nkey = \"camera.position\"\nframes = [0]\nvalues = [1]\n", "holds a number"},
      {"[[animate]]\nkey = \"camera.altitude\"\nframes = [0, 0]\nvalues = [1, 2]\n", "frames[1]"},
      {"[[animate]]\nkey = \"camera.altitude\"\nframes = [0, 5]\nvalues = [1]\n", "expected 2"},
      {"[[animate]]\nkey = \"camera.altitude\"\nvalues = [1]\n", "times"},
      {"[[animate]]\nkey = \"camera.altitude\"\nframes = [0]\nvalues = [1]\ninterpolation = \"smoth\"\n",
       "did you mean smooth"},
      {"[[animate]]\nkey = \"sun.time\"\nframes = [0]\nvalues = [4]\n", "ISO 8601"},
      {"[[animate]]\nkey = \"camera.altitude\"\nframe = [0]\nvalues = [1]\n", "frames"},
      {"[[animate]]\nkey = \"camera.altitude\"\nframes = [0]\nvalues = [400]\n[[animate]]\nkey = "
       "\"camera.altitude\"\nframes = [0]\nvalues = [400]\n",
       "twice"},
  };
  for (const auto& c : cases) {
    try {
      animation(c.keys);
      ADD_FAILURE() << c.keys;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(c.says), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace airlight
