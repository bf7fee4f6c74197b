#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "optics/colour.h"
#include "scenes.h"

namespace airlight::test {
namespace {

Camera panorama(int width, double altitude = 0) {
  Camera c;
  c.width = width;
  c.height = width / 2;
  c.altitude = altitude;
  return c;
}

double solid_angle(const Camera& c, int x, int y) {
  // By differences of the viewing directions: no formula of any projection.
  const auto at = [&](double dx, double dy) {
    return view_direction(c, (x + 0.5 + dx) / c.width, (y + 0.5 + dy) / c.height);
  };
  const Direction a = at(-0.5, 0), b = at(0.5, 0), e = at(0, -0.5), f = at(0, 0.5);
  const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {f[0] - e[0], f[1] - e[1], f[2] - e[2]};
  return std::sqrt(std::pow(u[1] * v[2] - u[2] * v[1], 2) + std::pow(u[2] * v[0] - u[0] * v[2], 2) +
                   std::pow(u[0] * v[1] - u[1] * v[0], 2));
}

struct Case {
  const char* name;
  Camera camera;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Disc : public testing::TestWithParam<Case> {};

TEST_P(Disc, integral_over_the_picture_is_the_direct_irradiance) {
  const Sky sky(built_in_atmosphere("earth"));
  const Direction sun = toward(20, 40);
  const auto with = draw(sky, GetParam().camera, sun),
             without = draw(sky, GetParam().camera, sun, {.sun_disc = false, .wavelengths = {}});
  double sum = 0;
  for (int y = 0; y < GetParam().camera.height; ++y) {
    for (int x = 0; x < GetParam().camera.width; ++x) {
      const std::size_t i = 4 * (std::size_t(y) * std::size_t(GetParam().camera.width) + std::size_t(x));
      const double more = luminance(&with[i]) - luminance(&without[i]);
      if (more > 0) sum += more * solid_angle(GetParam().camera, x, y);
    }
  }
  const auto quad = sky.realtime_wavelengths();
  std::vector<double> irradiance(4);
  sky.evaluate(Quantity::sun_irradiance, std::vector<Ray>{{0, sun, sun}}, quad, irradiance);
  const auto weights = colour_weights(sky.atmosphere(), quad);
  double expected = 0;
  for (std::size_t k = 0; k < 4; ++k) expected += weights[k][1] * irradiance[k];
  // 1 % is the promise; what is left is the transmittance at the disc's centre in place of its mean, and differences in float.
  EXPECT_NEAR(sum / expected, 1, 0.01);
}

Camera flat(int width, int height, double field_deg, double azimuth_deg) {
  Camera c = panorama(width);
  c.height = height;
  c.projection = Projection::perspective;
  c.field_of_view = field_deg * degree;
  c.azimuth = azimuth_deg * degree;
  c.elevation = 30 * degree;
  return c;
}
Camera fisheye(int width) {
  Camera c = flat(width, width, 180, 0);
  c.projection = Projection::fisheye;
  c.elevation = 90 * degree;
  return c;
}
Camera cube(int width) {
  Camera c = flat(width, width, 90, 0);
  c.projection = Projection::cube;
  c.face = 2;
  return c;
}
INSTANTIATE_TEST_SUITE_P(Pictures, Disc,
                         testing::Values(Case{"panorama of 64", panorama(64)}, Case{"panorama of 500", panorama(500)},
                                         Case{"panorama of 2048", panorama(2048)},
                                         Case{"perspective of 40", flat(40, 40, 60, 15)},
                                         Case{"telephoto", flat(400, 300, 30, 20)}, Case{"fisheye of 33", fisheye(33)},
                                         Case{"fisheye of 512", fisheye(512)}, Case{"cube face of 16", cube(16)},
                                         Case{"cube face of 256", cube(256)}));

TEST(Picture, agrees_with_rays_asked_one_by_one) {
  // skyview's pictures interpolate a table of what its rays are marched for.
  const Sky sky(built_in_atmosphere("earth"));
  const auto quad = sky.realtime_wavelengths();
  const auto weights = colour_weights(sky.atmosphere(), quad);
  for (double elevation : {50.0, 5.0, -3.0}) {
    const Camera camera = panorama(96, 300);
    const Direction sun = toward(77, elevation);
    const auto pixels = draw(sky, camera, sun, {.sun_disc = false, .wavelengths = {}});
    std::vector<Ray> rays;
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x)
        rays.push_back({300, view_direction(camera, (x + 0.5) / camera.width, (y + 0.5) / camera.height), sun});
    }
    std::vector<double> radiance(rays.size() * 4), errors;
    sky.evaluate(Quantity::radiance, rays, quad, radiance);
    double brightest = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      double y = 0;
      for (std::size_t k = 0; k < 4; ++k) y += weights[k][1] * radiance[4 * i + k];
      brightest = std::max(brightest, y);
      errors.push_back(std::abs(luminance(&pixels[4 * i]) - y) / std::max(y, 1e-3 * brightest));
    }
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.003) << "sun at " << elevation;  // bilinear interpolation over 128 x 160
    EXPECT_LT(errors[errors.size() * 99 / 100], 0.03) << "sun at " << elevation;  // the rows next to the horizon
  }
}

TEST(Picture, of_any_wavelengths_is_the_sum_of_its_spectral_channels) {
  const Sky sky(built_in_atmosphere("earth"));
  const Direction sun = toward(77, 5);
  for (const std::size_t count : {3u, 4u, 6u, 48u}) {
    PictureOptions options;
    for (std::size_t w = 0; w < count; ++w) options.wavelengths.push_back(360 + 470.0 * double(w) / double(count - 1));
    const auto weights = colour_weights(sky.atmosphere(), options.wavelengths);
    const Camera camera = panorama(40, 300);
    const auto pixels = draw(sky, camera, sun, options);
    std::vector<float> spectra;
    sky.render_spectral(camera, sun, options, [&](int, int, std::span<const float> values) {
      spectra.insert(spectra.end(), values.begin(), values.end());
      return true;
    });
    ASSERT_EQ(spectra.size(), pixels.size() / 4 * count);
    for (std::size_t i = 0; i < pixels.size() / 4; ++i) {
      std::array<double, 3> rgb{};
      double size = 0;  // of what is added and taken away
      for (std::size_t w = 0; w < count; ++w) {
        const auto one = xyz_to_srgb(weights[w]);
        for (std::size_t c = 0; c < 3; ++c) {
          rgb[c] += one[c] * double(spectra[i * count + w]);
          size += std::abs(one[c] * double(spectra[i * count + w]));
        }
      }
      // Sums of floats.
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(double(pixels[4 * i + c]), rgb[c], 3e-6 * size) << count;
    }
  }
}

TEST(Picture, keeps_each_wavelength_in_its_place) {
  // Blue is scattered most: by day the zenith's radiance relative to the sun's falls steadily.
  const Sky sky(built_in_atmosphere("earth"));
  PictureOptions options{.sun_disc = false, .wavelengths = {}};
  for (int w = 420; w <= 700; w += 40) options.wavelengths.push_back(w);
  Camera camera = fisheye(3);
  std::vector<float> middle;
  sky.render_spectral(camera, toward(0, 30), options, [&](int, int, std::span<const float> values) {
    middle.assign(values.begin() + 4 * 8, values.begin() + 5 * 8);
    return true;
  });
  for (std::size_t w = 1; w < 8; ++w) {
    const Spectrum& sun = sky.atmosphere().sun.irradiance;
    EXPECT_LT(double(middle[w]) / sun.at(options.wavelengths[w]),
              double(middle[w - 1]) / sun.at(options.wavelengths[w - 1]));
  }
}

TEST(Picture, does_not_switch_visibly_where_tables_give_way_to_marching) {
  const Sky sky(built_in_atmosphere("earth"));
  const double limit = 0.3 * sky.atmosphere().planet.top_altitude;
  for (double elevation : {40.0, -4.0}) {
    const auto below =
        draw(sky, panorama(128, limit - 1), toward(0, elevation), {.sun_disc = false, .wavelengths = {}});
    const auto above =
        draw(sky, panorama(128, limit + 1), toward(0, elevation), {.sun_disc = false, .wavelengths = {}});
    double brightest = 0;
    for (std::size_t i = 0; i < above.size(); i += 4) brightest = std::max(brightest, luminance(&above[i]));
    std::vector<double> errors;
    for (std::size_t i = 0; i < above.size(); i += 4) {
      errors.push_back(std::abs(luminance(&below[i]) - luminance(&above[i])) /
                       std::max(luminance(&above[i]), 0.01 * brightest));
    }
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.004) << elevation;  // far below the 1 % that an eye sees between two frames
    EXPECT_LT(errors[errors.size() * 98 / 100], 0.04) << elevation;  // pixels across the limb
  }
}

TEST(Picture, has_no_seam_at_the_suns_azimuth_or_opposite) {
  const Sky sky(built_in_atmosphere("earth"));
  Camera camera = panorama(720);
  const auto pixels = draw(sky, camera, toward(0, 15), {.sun_disc = false, .wavelengths = {}});
  const auto y_at = [&](int x, int y) {
    return luminance(&pixels[4 * (std::size_t(y) * 720 + std::size_t((x + 720) % 720))]);
  };
  for (int y = 4; y < 170; y += 5) {
    for (int seam : {360, 0}) {
      // Mirror symmetry across the seam, and no kink: the step over it is no larger than its neighbours' plus 0.2 %.
      EXPECT_NEAR(y_at(seam, y) / y_at(seam - 1, y), 1, 2e-3) << "row " << y;
      EXPECT_NEAR(y_at(seam + 7, y) / y_at(seam - 8, y), 1, 2e-3) << "row " << y;
    }
  }
}

TEST(Picture, is_the_same_for_any_number_of_threads) {
  std::vector<std::vector<float>> pictures;
  for (std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Sky sky(built_in_atmosphere("earth-hazy"));
    pictures.push_back(draw(sky, panorama(200, 10), toward(10, 5)));
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

TEST(Picture, reruns_only_the_passes_that_something_changed_for) {
  const auto engine = make_engine("simd");
  const Sky sky(built_in_atmosphere("earth"), "skyview", engine);
  const auto runs = [&](const char* pass) { return engine->passes_run(pass); };
  draw(sky, panorama(32), toward(0, 30));
  draw(sky, panorama(48), toward(0, 30));  // another picture of the same sky
  EXPECT_EQ(runs("skyview.sky_view"), 1);
  draw(sky, panorama(32), toward(0, 31));  // the sun moved
  EXPECT_EQ(runs("skyview.sky_view"), 2);
  draw(sky, panorama(32, 100), toward(0, 31));  // the observer moved
  EXPECT_EQ(runs("skyview.sky_view"), 3);
  EXPECT_EQ(runs("core.optical_depth"), 1);
  EXPECT_EQ(runs("skyview.multiple"), 1);
  const Sky hazy(built_in_atmosphere("earth-hazy"), "skyview", engine);
  draw(hazy, panorama(32), toward(0, 31));
  EXPECT_EQ(runs("core.optical_depth"), 2);
  draw(sky, panorama(32), toward(0, 30));  // still kept
  EXPECT_EQ(runs("skyview.sky_view"), 4);
}

TEST(Picture, stops_when_told_to) {
  const Sky sky(built_in_atmosphere("earth"));
  int strips = 0;
  EXPECT_FALSE(
      sky.render(panorama(4096), toward(0, 30), {}, [&](int, int, std::span<const float>) { return ++strips < 2; }));
  EXPECT_EQ(strips, 2);
}

}  // namespace
}  // namespace airlight::test
