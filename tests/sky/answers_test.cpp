#include <gtest/gtest.h>

#include "airlight/error.h"
#include "scenes.h"

namespace airlight::test {
namespace {

double photometric(const Sky& sky, Quantity quantity, const Ray& ray) {
  const auto wavelengths = photometric_wavelengths();
  std::vector<double> spectrum(wavelengths.size());
  sky.evaluate(quantity, std::vector<Ray>{ray}, wavelengths, spectrum);
  return spectrum_to_xyz(wavelengths, spectrum)[1];
}

TEST(Answers, illuminances_and_zenith_luminance_are_those_of_a_clear_day) {
  // Sun at the zenith: 105 to 130 klx in all, 8 to 20 klx of it from the sky; sun 60 degrees up: 2500 to 6000 cd/m2 overhead
  // (CIE 110-1994; IES Lighting Handbook; docs/units.md says more).
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const Ray overhead{0, {0, 0, 1}, {0, 0, 1}};
  const double from_sun = photometric(sky, Quantity::sun_irradiance, overhead),
               from_sky = photometric(sky, Quantity::sky_irradiance, overhead);
  EXPECT_GT(from_sky, 8e3);
  EXPECT_LT(from_sky, 20e3);
  EXPECT_GT(from_sun + from_sky, 105e3);
  EXPECT_LT(from_sun + from_sky, 130e3);
  const double zenith = photometric(sky, Quantity::radiance, {0, {0, 0, 1}, toward(0, 60)});
  EXPECT_GT(zenith, 2500);
  EXPECT_LT(zenith, 6000);
}

TEST(Answers, higher_orders_only_add_light) {
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const double w[] = {450, 550, 650, 700};
  std::vector<Ray> rays;
  for (double e : {2.0, 20.0, 70.0}) rays.push_back({0, toward(60, e), toward(0, 25)});
  std::vector<double> all(12), first(12);
  sky.evaluate(Quantity::path_radiance, rays, w, all);
  sky.evaluate(Quantity::path_radiance, rays, w, first, 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_GT(all[i], first[i]);
    EXPECT_LT(all[i], 3 * first[i]);
  }
}

TEST(Answers, radiance_is_the_air_plus_the_ground_seen_through_it) {
  Atmosphere a = built_in_atmosphere("earth");
  a.planet.albedo = 0.0;
  const Ray down{5000, toward(0, -30), toward(0, 40)};
  const double w[] = {550};
  for (const char* model : {"single", "skyview"}) {
    double dark[2], lit[2];
    const Sky black(a, model);
    black.evaluate(Quantity::radiance, std::vector<Ray>{down}, w, std::span(&dark[0], 1));
    black.evaluate(Quantity::path_radiance, std::vector<Ray>{down}, w, std::span(&dark[1], 1));
    EXPECT_EQ(dark[0], dark[1]) << model;
    const Sky earth(built_in_atmosphere("earth"), model);
    earth.evaluate(Quantity::radiance, std::vector<Ray>{down}, w, std::span(&lit[0], 1));
    earth.evaluate(Quantity::path_radiance, std::vector<Ray>{down}, w, std::span(&lit[1], 1));
    EXPECT_GT(lit[0], lit[1]) << model;
  }
}

TEST(Answers, below_the_datum_the_air_of_altitude_0_continues) {
  // The Dead Sea's shore: the sky differs from that at the sea by 430 m of the densest air (a fifth of the aerosol and a twentieth of the molecules), and is not black.
  const Sky sky(built_in_atmosphere("earth"), "skyview");
  const double w[] = {550};
  std::vector<Ray> rays{{0, toward(0, 45), toward(90, 50)},
                        {-430, toward(0, 45), toward(90, 50)},
                        {-430, toward(0, -45), toward(90, 50)}};
  std::vector<double> out(3);
  sky.evaluate(Quantity::radiance, rays, w, out);
  EXPECT_GT(out[1], out[0]);
  EXPECT_LT(out[1], 1.2 * out[0]);
  EXPECT_GT(out[2], 0.5 * out[0] * 0.1);
}

TEST(Answers, nothing_happens_at_special_angles) {
  // Where cosines are exactly 0 or 1: a view along the horizontal, straight up, at, against and square to the Sun. What a view turned
  // by 8e-5 degrees brings: in the planet's shadow light over 500 km falls by a thousandth over that much.
  const std::vector<double> wavelengths{390, 440, 560, 670};
  const std::vector<Direction> views{{0, 1, 0},     {1, 0, 0},       {-1, 0, 0},    {0, 0, 1},
                                     toward(0, 40), toward(180, 50), toward(90, 40)},
      suns{{0, 0, 1}, {1, 0, 0}, toward(0, 40), toward(0, -2), toward(0, -6)};
  for (const auto& [model, parameters] : std::vector<std::pair<std::string, Parameters>>{
           {"single", {}}, {"skyview", {}}, {"precomputed", {{"detail", "draft"}}}}) {
    const Sky sky(built_in_atmosphere("earth"), model, make_engine("simd"), parameters);
    std::vector<Ray> exact, turned;
    for (const double altitude : {0.0, 2.0, 10e3, 60e3})
      for (const Direction& sun : suns)
        for (const Direction& v : views) {
          exact.push_back({altitude, v, sun});
          const double length = std::hypot(v[0] + 1e-6, v[1] + 1e-6, v[2] + 1e-6);
          turned.push_back({altitude, {(v[0] + 1e-6) / length, (v[1] + 1e-6) / length, (v[2] + 1e-6) / length}, sun});
        }
    std::vector<double> there(exact.size() * wavelengths.size()), near(there);
    sky.evaluate(Quantity::path_radiance, exact, wavelengths, there);
    sky.evaluate(Quantity::path_radiance, turned, wavelengths, near);
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Ray& ray = exact[i / wavelengths.size()];
      EXPECT_NEAR(there[i], near[i], 2e-3 * near[i] + 1e-12)
          << model << ", altitude " << ray.altitude << ", view " << ray.view[0] << ' ' << ray.view[1] << ' '
          << ray.view[2] << ", sun " << ray.sun[0] << ' ' << ray.sun[2] << ", " << wavelengths[i % 4] << " nm";
    }
  }
}

TEST(Answers, transmittance_is_multiplicative_along_a_ray) {
  const Sky sky(built_in_atmosphere("earth"), "single", make_engine("double"));
  const double w[] = {440, 550, 680, 760}, R = sky.atmosphere().planet.ground_radius;
  const double zenith = 80 * degree, first = 20e3, second = 45e3;
  // The second part starts where the first ends, in the frame there.
  const double r = std::sqrt(R * R + first * first + 2 * R * first * std::cos(zenith)),
               mu = (R * std::cos(zenith) + first) / r;
  std::vector<Ray> rays{{0, direction(0, std::numbers::pi / 2 - zenith), {0, 0, 1}, first},
                        {r - R, direction(0, std::asin(mu)), {0, 0, 1}, second},
                        {0, direction(0, std::numbers::pi / 2 - zenith), {0, 0, 1}, first + second}};
  std::vector<double> t(12);
  sky.evaluate(Quantity::transmittance, rays, w, t);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(t[k] * t[4 + k], t[8 + k], 1e-6);  // quadrature; rounding is far below
}

TEST(Answers, light_is_linear_in_the_suns_irradiance) {
  Atmosphere a = built_in_atmosphere("mars-clear");
  const Ray ray{100, toward(30, 10), toward(0, 20)};
  const double w[] = {500, 600};
  double once[2], twice[2];
  Sky(a).evaluate(Quantity::radiance, std::vector<Ray>{ray}, w, once);
  a.sun.irradiance = a.sun.irradiance.scaled(2);
  Sky(a).evaluate(Quantity::radiance, std::vector<Ray>{ray}, w, twice);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(twice[k] / once[k], 2, 1e-6);  // float
}

TEST(Answers, outside_the_air_the_sun_is_unattenuated_and_the_sky_black) {
  const Sky sky(built_in_atmosphere("earth"));
  const double w[] = {550};
  std::vector<Ray> rays{{4e5, {0, 0, 1}, {0, 0, 1}}, {3.8e8, toward(0, 10), toward(0, 45)}};
  std::vector<double> sun(2), radiance(2);
  sky.evaluate(Quantity::sun_irradiance, rays, w, sun);
  sky.evaluate(Quantity::radiance, rays, w, radiance);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(sun[std::size_t(i)], sky.atmosphere().sun.irradiance.at(550), 1e-6);
    EXPECT_EQ(radiance[std::size_t(i)], 0);
  }
}

TEST(Answers, bad_questions_are_refused_with_name_value_and_range) {
  const Sky sky(built_in_atmosphere("earth"));
  const double good[] = {550}, bad[] = {300};
  std::vector<double> out{-1};
  const auto message = [&](const Ray& ray, std::span<const double> w) -> std::string {
    try {
      sky.evaluate(Quantity::radiance, std::vector<Ray>{ray}, w, out);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  EXPECT_NE(message({nan, {0, 0, 1}, {0, 0, 1}}, good).find("altitude = nan"), std::string::npos);
  EXPECT_NE(message({inf, {0, 0, 1}, {0, 0, 1}}, good).find("altitude = inf"), std::string::npos);
  EXPECT_NE(message({-7e6, {0, 0, 1}, {0, 0, 1}}, good).find("altitude"), std::string::npos);
  EXPECT_NE(message({0, {0, 0, 2}, {0, 0, 1}}, good).find("view"), std::string::npos);
  EXPECT_NE(message({0, {0, 0, 1}, {nan, 0, 1}}, good).find("sun"), std::string::npos);
  EXPECT_NE(message({0, {0, 0, 1}, {0, 0, 1}, -5}, good).find("distance = -5"), std::string::npos);
  EXPECT_NE(message({0, {0, 0, 1}, {0, 0, 1}, nan}, good).find("distance"), std::string::npos);
  EXPECT_NE(message({0, {0, 0, 1}, {0, 0, 1}}, bad).find("300"), std::string::npos);
  EXPECT_EQ(out[0], -1) << "out is untouched";
  EXPECT_THROW(Sky(built_in_atmosphere("earth"), "skyveiw"), InputError);
}

}  // namespace
}  // namespace airlight::test
