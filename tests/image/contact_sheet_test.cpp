// Words below small pictures: whole, and none over another's.
#include "image/contact_sheet.h"

#include <gtest/gtest.h>

namespace airlight {
namespace {

BytePicture gray(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * std::size_t(height), 128)};
}

/// Whether anything but the background lies in a column of pixels below `from`.
bool written(const BytePicture& sheet, int x, int from) {
  for (int y = from; y < sheet.height; ++y)
    if (sheet.rgb[3 * (std::size_t(y) * std::size_t(sheet.width) + std::size_t(x))] != sheet.rgb[0]) return true;
  return false;
}

TEST(ContactSheet, long_lines_are_wrapped_inside_their_cells) {
  const std::string words = "against single: median 12.5 %, 95 % within 34.5 %, and so on until no cell is as wide";
  const std::vector<LabelledPicture> pictures{{gray(32, 18), {words, "below"}}, {gray(32, 18), {words, "below"}}};
  const BytePicture sheet = contact_sheet(pictures, 2), one = contact_sheet({pictures.data(), 1}, 1);
  // One cell is a margin and a column; so where the second one's margin begins is known.
  const int margin = 2 * one.width - sheet.width, second = one.width;
  ASSERT_GT(margin, 0);
  for (int x = second - margin; x < second; ++x) EXPECT_FALSE(written(sheet, x, margin + 18)) << x;
  for (int x = sheet.width - margin; x < sheet.width; ++x) EXPECT_FALSE(written(sheet, x, margin + 18)) << x;
  int columns = 0;
  for (int x = 0; x < one.width; ++x) columns += written(one, x, margin + 18);
  EXPECT_GT(columns, one.width / 2) << "words use the cell's width";
  // Three lines at least: the text is more than twice as long as a cell.
  const std::vector<LabelledPicture> brief{{gray(32, 18), {"a", "b"}}};
  EXPECT_GT(one.height, contact_sheet(brief, 1).height);
}

TEST(ContactSheet, a_wide_picture_has_room_for_a_line) {
  const std::vector<LabelledPicture> brief{{gray(900, 18), {"a"}}},
      line{{gray(900, 18), {"against single: median 12.5 %, 95 % within 34.5 %"}}};
  EXPECT_EQ(contact_sheet(brief, 1).height, contact_sheet(line, 1).height);
}

}  // namespace
}  // namespace airlight
