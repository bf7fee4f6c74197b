#include "scene/moon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "airlight/sky.h"
#include "scene/scene_sun.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

double separation(const Moon& moon, const SunPosition& sun) {
  const double de = std::sin(0.5 * (moon.elevation - sun.elevation)), da = std::sin(0.5 * (moon.azimuth - sun.azimuth));
  return 2 * std::asin(std::sqrt(de * de + std::cos(moon.elevation) * std::cos(sun.elevation) * da * da)) / degree;
}

/// Illuminance [lx] outside the air, facing the light.
double illuminance(const Sun& light) {
  const std::vector<double> wavelengths = photometric_wavelengths();
  std::vector<double> spectrum;
  for (const double wavelength : wavelengths) spectrum.push_back(light.irradiance.at(wavelength));
  return spectrum_to_xyz(wavelengths, spectrum)[1];
}

TEST(Moon, stands_before_the_sun_where_eclipses_were_greatest) {
  // F. Espenak's (NASA) total eclipses: time, place and magnitude, which in a central eclipse is the ratio of the diameters.
  const struct {
    const char* time;
    double latitude, longitude, magnitude;
  } eclipses[] = {{"1999-08-11T11:03:07Z", 45.1, 24.3, 1.0286},
                  {"2017-08-21T18:25:32Z", 36.97, -87.67, 1.0306},
                  {"2024-04-08T18:17:18Z", 25.29, -104.14, 1.0566}};
  const Sun star = built_in_atmosphere("earth").sun;
  for (const auto& eclipse : eclipses) {
    const Place place{eclipse.latitude * degree, eclipse.longitude * degree};
    const Time time = parse_time(eclipse.time);
    const SunPosition sun = sun_position(place, time);
    const Moon moon = moon_at(place, time);
    // Places to 0.1 or 0.01 degrees: 10 km on the ground are 0.0015 degrees; the series are good for 0.003.
    EXPECT_LT(separation(moon, sun), 0.006) << eclipse.time;
    // Radii of the Moon in use differ by 0.0004.
    EXPECT_NEAR(moonlight(star, moon).angular_radius / sun_at(star, sun.distance).angular_radius, eclipse.magnitude,
                0.001)
        << eclipse.time;
    EXPECT_GT(moon.phase, 179.4 * degree);  // seen from the centre of the Earth, half a degree off
  }
}

TEST(Moon, is_full_in_lunar_eclipses) {
  // Greatest eclipse of 2019-01-21 (Espenak): the Moon's centre 0.3684 Earth's equatorial radii from the shadow's axis.
  const Place below{20.3 * degree,
                    -75.3 * degree};  // where it stood in the zenith: opposite the Sun, that much to the north
  const Time time = parse_time("2019-01-21T05:12:16Z");
  const Moon moon = moon_at(below, time);
  EXPECT_GT(moon.elevation, 89.5 * degree);
  EXPECT_NEAR(moon.phase, std::asin(0.3684 * 6'378'137 / (moon.distance + 6'378'137)), 0.005 * degree);
  EXPECT_NEAR(moon.sun_distance, sun_position(below, time).distance + moon.distance / 149'597'870'700.0, 1e-4);
}

TEST(Moon, gives_the_light_of_its_magnitude) {
  const Sun star = built_in_atmosphere("earth").sun;
  const double full = illuminance(moonlight(star, {}));
  // V = -12.73 at full (Allen, Astrophysical Quantities), and 1 lx is V = -13.98. The solar spectra in use differ by 3 %, and 0.12
  // has two digits.
  EXPECT_NEAR(full / std::pow(10, -0.4 * (-12.73 + 13.98)), 1, 0.08);
  // Allen's phase law, which a polynomial stands for.
  for (const auto& [phase, magnitudes] : {std::pair{30, 0.79}, {60, 1.62}, {90, 2.63}, {120, 3.93}, {150, 5.9}}) {
    const double fainter = -2.5 * std::log10(illuminance(moonlight(star, {.phase = phase * degree})) / full);
    EXPECT_NEAR(fainter, magnitudes, 0.07) << phase;
  }
  // Nearer and so brighter: inverse squares.
  EXPECT_NEAR(illuminance(moonlight(star, {.distance = 192'200'000})) / full, 4, 1e-9);
  EXPECT_NEAR(illuminance(moonlight(star, {.sun_distance = 2})) / full, 0.25, 1e-9);
}

TEST(Moon, is_redder_than_the_sun) {
  const Sun star = built_in_atmosphere("earth").sun, moon = moonlight(star, {});
  const auto albedo = [&](double wavelength) {
    return moon.irradiance.at(wavelength) / star.irradiance.at(wavelength);
  };
  EXPECT_NEAR(2.5 * std::log10(albedo(550) / albedo(440)), 0.92 - 0.65, 1e-9);  // B - V of Moon and Sun (Allen)
}

}  // namespace
}  // namespace airlight
