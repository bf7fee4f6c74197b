#include "image/picture_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "../scratch_folder.h"
#include "airlight/error.h"

namespace airlight {
namespace {

using Pixels = std::vector<float>;

/// A sky-like picture, smooth and bright, RGBA.
Pixels sky(int width, int height) {
  Pixels rgba;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float glow = 4000 * std::exp(-0.01f * float((x - width / 2) * (x - width / 2) + y * y));
      rgba.insert(rgba.end(), {500 + glow + float(y), 800 + 0.7f * glow, 1500.5f + 0.2f * glow - float(x), 1});
    }
  return rgba;
}

/// Writes in strips of so many rows.
std::vector<std::string> write(const std::string& path, int width, int height, const Pixels& rgba,
                               const PictureFormat& format = {}, const Metadata& metadata = {}, int strip = 7) {
  PictureFile file(path, width, height, format, metadata);
  for (int y = 0; y < height; y += strip) {
    const int end = std::min(height, y + strip);
    const std::size_t row = 4 * std::size_t(width);
    file.write_rows(y, end, std::span(rgba).subspan(std::size_t(y) * row, std::size_t(end - y) * row));
  }
  file.finish();
  return file.notes();
}

struct Picture {
  OIIO::ImageSpec spec;
  Pixels rgb;
  std::string text(const char* name) const { return spec.get_string_attribute(name); }
};
Picture read(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in) throw std::runtime_error(OIIO::geterror());
  Picture picture{in->spec(), {}};
  picture.rgb.resize(std::size_t(picture.spec.width) * std::size_t(picture.spec.height) * 3);
  if (picture.spec.nchannels != 3 || !in->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, picture.rgb.data()))
    throw std::runtime_error(in->geterror());
  return picture;
}

constexpr int width = 75, height = 53;  // neither is a multiple of anything

TEST(PictureFile, float_exr_is_exact) {
  const Folder folder;
  const Pixels rgba = sky(width, height);
  EXPECT_TRUE(write(folder / "a.exr", width, height, rgba, {.half = false}).empty());
  const Picture picture = read(folder / "a.exr");
  EXPECT_EQ(picture.spec.width, width);
  EXPECT_EQ(picture.spec.height, height);
  EXPECT_EQ(picture.spec.format, OIIO::TypeDesc::FLOAT);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) ASSERT_EQ(picture.rgb[i], rgba[i / 3 * 4 + i % 3]) << i;
}

TEST(PictureFile, half_exr_is_as_good_as_half_floats) {
  const Folder folder;
  Pixels rgba = sky(width, height);
  rgba[0] = -3;  // outside the gamut: kept
  EXPECT_TRUE(write(folder / "a.exr", width, height, rgba).empty());
  const Picture picture = read(folder / "a.exr");
  EXPECT_EQ(picture.spec.format, OIIO::TypeDesc::HALF);
  EXPECT_EQ(picture.text("compression"), "zip");
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    const float v = rgba[i / 3 * 4 + i % 3];
    ASSERT_NEAR(picture.rgb[i], v, std::abs(v) * 0x1p-11) << i;  // 11 significant bits, rounded
  }
}

TEST(PictureFile, noise_that_zip_cannot_pack_survives) {
  const Folder folder;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-60, 60);
  Pixels rgba(4 * width * height);
  for (float& v : rgba) v = std::exp2(exponent(random));
  write(folder / "a.exr", width, height, rgba, {.half = false});
  const Picture picture = read(folder / "a.exr");
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) ASSERT_EQ(picture.rgb[i], rgba[i / 3 * 4 + i % 3]) << i;
}

TEST(PictureFile, file_does_not_depend_on_strips_or_threads) {
  const Folder folder;
  const int tall = 700;  // more than one batch of blocks
  const Pixels rgba = sky(width, tall);
  write(folder / "a.exr", width, tall, rgba, {}, {}, tall);
  write(folder / "b.exr", width, tall, rgba, {.compression_threads = 1}, {}, 1);
  write(folder / "c.exr", width, tall, rgba, {.compression_threads = 2}, {}, 33);
  EXPECT_TRUE(read_file(folder / "a.exr") == read_file(folder / "b.exr"));
  EXPECT_TRUE(read_file(folder / "a.exr") == read_file(folder / "c.exr"));
}

TEST(PictureFile, half_clamps_and_says_so) {
  const Folder folder;
  Pixels rgba = sky(width, height);
  rgba[4] = rgba[5] = 1.6e9f;
  rgba[9] = 70000;
  const auto notes = write(folder / "a.exr", width, height, rgba);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("2 pixels above half float's range"), std::string::npos) << notes[0];
  const Picture picture = read(folder / "a.exr");
  EXPECT_EQ(picture.rgb[3], 65504);
  EXPECT_EQ(picture.rgb[7], 65504);
  EXPECT_NE(picture.text("HalfClamp").find("65504"), std::string::npos);
  EXPECT_TRUE(write(folder / "b.exr", width, height, rgba, {.half = false}).empty());
  EXPECT_EQ(read(folder / "b.exr").text("HalfClamp"), "");
}

TEST(PictureFile, no_file_carries_nan_or_infinity) {
  const Folder folder;
  Pixels rgba = sky(width, height);
  rgba[0] = std::numeric_limits<float>::quiet_NaN();
  rgba[1] = std::numeric_limits<float>::infinity();
  rgba[6] = -std::numeric_limits<float>::infinity();
  for (const char* name : {"half.exr", "float.exr", "a.hdr", "a.png"}) {
    const auto notes = write(folder / name, width, height, rgba, {.half = name[0] == 'h'});
    ASSERT_FALSE(notes.empty()) << name;
    EXPECT_NE(notes.back().find("2 pixels with NaN or infinity"), std::string::npos) << notes.back();
    const Picture picture = read(folder / name);
    for (const std::size_t i : {0, 1, 5}) EXPECT_EQ(picture.rgb[i], 0) << name << " " << i;
    for (const float v : picture.rgb) ASSERT_TRUE(std::isfinite(v)) << name;
  }
}

TEST(PictureFile, hdr_holds_the_sun_to_eight_bits) {
  const Folder folder;
  Pixels rgba = sky(width, height);
  rgba[0] = rgba[1] = rgba[2] = 1.6e9f;
  rgba[4] = -5;
  const auto notes = write(folder / "a.hdr", width, height, rgba);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("1 pixel outside the gamut"), std::string::npos) << notes[0];
  const Picture picture = read(folder / "a.hdr");
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    const std::size_t p = i / 3 * 4;
    const float largest = std::max({rgba[p], rgba[p + 1], rgba[p + 2]});
    // 8 bits of fraction, truncated, common to the pixel: 1/128 of the largest component at worst.
    ASSERT_NEAR(picture.rgb[i], std::max(rgba[p + i % 3], 0.0f), largest / 128) << i;
  }
}

TEST(PictureFile, metadata_survive) {
  const Folder folder;
  const Metadata metadata = {{"Atmosphere", "earth"},
                             {"SunElevation", 12.5},
                             {"Wavelengths", std::string(300, '5')},
                             {"A name of more than thirty-one characters", "yes"},
                             {"Place",
                              "K\xc3\xb8"
                              "benhavn, two\nlines"}};
  const Pixels rgba = sky(width, height);
  write(folder / "a.exr", width, height, rgba, {}, metadata);
  const Picture exr = read(folder / "a.exr");
  EXPECT_EQ(exr.spec.get_float_attribute("SunElevation"), 12.5f);
  write(folder / "a.png", width, height, rgba, {}, metadata);
  const Picture png = read(folder / "a.png");
  EXPECT_EQ(png.text("SunElevation"), "12.5");
  EXPECT_EQ(png.text("ToneCurve"), "filmic");
  EXPECT_NE(png.text("ExposureEV").find("automatic"), std::string::npos);
  for (const auto& [name, value] : metadata) {
    const auto* text = std::get_if<std::string>(&value);
    if (!text) continue;
    EXPECT_EQ(exr.text(name.c_str()), *text) << name;
    EXPECT_EQ(png.text(name.c_str()), *text) << name;
  }
  write(folder / "a.hdr", width, height, rgba, {}, metadata);
  const std::string hdr = read_file(folder / "a.hdr");
  EXPECT_NE(hdr.find("\n# Atmosphere: earth\n# SunElevation: 12.5\n"), std::string::npos);
  EXPECT_EQ(read(folder / "a.hdr").spec.width, width) << "the header is still one";
}

TEST(PictureFile, colour_is_said) {
  const Folder folder;
  const Pixels rgba = sky(width, height);
  write(folder / "a.exr", width, height, rgba);
  const Picture picture = read(folder / "a.exr");
  EXPECT_EQ(picture.text("oiio:ColorSpace"), "Linear");
  EXPECT_EQ(picture.spec.get_float_attribute("whiteLuminance"), 1.0f) << "(1, 1, 1) is 1 cd/m2";
  float primaries[8] = {};
  ASSERT_TRUE(picture.spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries));
  const float srgb[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(primaries[i], srgb[i]) << i;
  write(folder / "a.png", width, height, rgba);
  EXPECT_EQ(read(folder / "a.png").text("oiio:ColorSpace"), "sRGB");
}

TEST(PictureFile, png_obeys_the_exposure_given) {
  const Folder folder;
  const Pixels rgba(4 * width * height, 1000.0f);
  const auto level = [&](double ev) {
    const auto notes =
        write(folder / "a.png", width, height, rgba, {.exposure_ev = ev, .tone_curve = ToneCurve::reinhard});
    EXPECT_EQ(notes.size(), 1u);
    return read(folder / "a.png").rgb[0] * 255;
  };
  // 1000 cd/m2 at EV -10 is 0.9766: Reinhard's 0.4942, sRGB 0.732.
  EXPECT_NEAR(level(-10), 186.7, 1);  // a dithered step
  EXPECT_EQ(level(-30), 0);
  EXPECT_EQ(level(10), 255);
}

TEST(PictureFile, full_disk_is_an_error_and_the_old_file_stays) {
  const Folder folder;
  const Pixels rgba = sky(512, 512);
  for (const char* name : {"a.exr", "a.hdr", "a.png"}) {
    std::ofstream(folder / name) << "old";
    rlimit before;
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{4000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
      write(folder / name, 512, 512, rgba);
    } catch (const WorkError& error) {
      message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
    EXPECT_NE(message.find("File too large"), std::string::npos) << message;
    EXPECT_EQ(read_file(folder / name), "old");
  }
  EXPECT_EQ(folder.names().size(), 3u);
}

TEST(PictureFile, a_device_that_is_full_is_an_error) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_THROW(write("/dev/full", width, height, sky(width, height)), WorkError);
}

TEST(PictureFile, unfinished_leaves_nothing) {
  const Folder folder;
  const Pixels rgba = sky(width, 40);
  for (const char* name : {"a.exr", "a.hdr", "a.png"}) {
    PictureFile file(folder / name, width, height, {}, {});
    file.write_rows(0, 40, rgba);
  }
  EXPECT_EQ(folder.names().size(), 0u);
}

TEST(PictureFile, bad_names_and_sizes_are_refused) {
  const Folder folder;
  for (const char* name : {"a.jpg", "a", "a.exr.txt"}) {
    try {
      PictureFile file(folder / name, width, height, {}, {});
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(".exr, .hdr, .png"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(PictureFile(folder / "missing/a.exr", width, height, {}, {}), InputError);
  EXPECT_THROW(PictureFile(folder / "a.exr", 0, height, {}, {}), InputError);
  EXPECT_NO_THROW(PictureFile(folder / "a.EXR", width, height, {}, {}));
  EXPECT_EQ(folder.names().size(), 0u);
}

}  // namespace
}  // namespace airlight
