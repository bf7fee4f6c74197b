#include "optics/shipped_data.h"

#include <gtest/gtest.h>

#include "airlight/error.h"
#include "airlight/spectrum.h"
#include "optics/csv.h"

namespace airlight {
namespace {

TEST(ShippedData, solar_irradiance_has_its_first_and_last_line) {
  const auto sun = shipped_spectrum("solar_irradiance.csv", Sampling::bins);
  ASSERT_TRUE(sun.has_value());
  ASSERT_EQ(sun->wavelengths.size(), 48u);
  EXPECT_EQ(sun->wavelengths.front(), 360);
  EXPECT_EQ(sun->values.front(), 1.11776);
  EXPECT_EQ(sun->wavelengths.back(), 830);
  EXPECT_EQ(sun->values.back(), 1.04992);
  EXPECT_EQ(sun->file, "solar_irradiance.csv");
}

TEST(ShippedData, unknown_files_are_absent) {
  EXPECT_FALSE(shipped_spectrum("moon.csv", Sampling::point).has_value());
  EXPECT_TRUE(shipped_text("").empty());
}

// Bins tile 360 to 840 nm, so their integral is the plain sum. Planck's law at 5772 K puts 54 % of the solar constant
// there; lines darken the real sun's blue and lift the rest by a few percent.
TEST(ShippedData, the_sun_sends_half_its_power_in_the_visible) {
  const auto sun = shipped_spectrum("solar_irradiance.csv", Sampling::bins);
  double power = 0;
  for (const double value : sun.value().values) power += 10 * value;
  EXPECT_NEAR(power / 1361, 0.54, 0.02);
}

TEST(Csv, reads_headings_comments_blank_lines_and_carriage_returns) {
  const TableSpectrum table =
      parse_spectrum_csv("nm,value\r\n# why\n\n 400 , 1e-3 \r\n500,2", "a.csv", Sampling::point);
  EXPECT_EQ(table.wavelengths, (std::vector<double>{400, 500}));
  EXPECT_EQ(table.values, (std::vector<double>{1e-3, 2}));
}

TEST(Csv, a_first_line_of_numbers_is_no_heading) {
  const auto first = [](const char* text) {
    return parse_spectrum_csv(text, "a.csv", Sampling::point).wavelengths.front();
  };
  EXPECT_EQ(first("400,1\n500,2\n"), 400);
  EXPECT_EQ(first("\xEF\xBB\xBF"
                  "400,1\n500,2\n"),
            400)
      << "after a byte order mark";
  EXPECT_EQ(first("# by hand\nnm,value\n400,1\n"), 400) << "a heading after a comment";
}

TEST(Csv, without_rows_is_refused) {
  for (const char* text : {"", "nm,value\n", "# nothing\n\n"}) {
    try {
      parse_spectrum_csv(text, "a.csv", Sampling::point);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "a.csv: holds no rows; expected lines of 2 numbers, \"wavelength [nm],value\"");
    }
  }
}

TEST(Csv, names_file_and_line_of_what_is_no_number) {
  for (const char* line : {"500", "500,", "500,x", "500,1,2", ",1", "nm,value"}) {
    try {
      parse_spectrum_csv("nm,value\n400,1\n" + std::string(line) + "\n", "a.csv", Sampling::point);
      ADD_FAILURE() << line;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("a.csv:3: "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace airlight
