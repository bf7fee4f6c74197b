#include "optics/response.h"

#include <gtest/gtest.h>

#include "airlight/error.h"

namespace airlight {
namespace {

TEST(Response, is_linear_between_its_lines) {
  const Response response = parse_response_csv("nm,a,b,c\n500,0,1,2\n504,4,1,0\n505,0,0,0\n", "camera.csv");
  ASSERT_EQ(response.wavelengths.size(), 6u);
  EXPECT_EQ(response.wavelengths[3], 503);
  EXPECT_EQ(response.curves[3], (Xyz{3, 1, 0.5}));
  EXPECT_EQ(response.curves[5], (Xyz{0, 0, 0}));
  EXPECT_EQ(parse_response_csv("500,0,1,2\n504,4,1,0\n", "camera.csv").wavelengths.size(), 5u) << "no heading";
  EXPECT_EQ(response.scaled(2).curves[3], (Xyz{6, 2, 1}));
}

TEST(Response, a_bad_line_is_named) {
  const auto refused = [](const char* text, const char* why) {
    try {
      parse_response_csv(text, "camera.csv");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused("nm,a,b,c\n500,0,1,2\n504,4,1\n", "camera.csv:3");
  refused("nm,a,b,c\n500,0,1,2\n500,4,1,0\n", "increasing");
  refused("nm,a,b,c\n500,0,nan,2\n510,4,1,0\n", "finite");
  refused("nm,a,b,c\n1,0,1,2\n510,4,1,0\n", "100 .. 10000");
  refused("nm,a,b,c\n500.5,0,1,2\n510,4,1,0\n", "without a fraction");
  refused("nm,a,b,c\n500,0,1,2,3\n510,4,1,0\n", "camera.csv:2");
  refused("", "camera.csv: holds no rows; expected lines of 4 numbers, \"wavelength [nm],first,second,third\"");
  refused("nm,a,b,c\n", "holds no rows");
  refused("nm,a,b,c\n500,0,1,2\n", "camera.csv:2: expected two rows");
}

}  // namespace
}  // namespace airlight
