#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "airlight/error.h"
#include "airlight/sky.h"

namespace airlight {
namespace {

constexpr double degree = 0.017453292519943295;
const std::vector<double> wavelengths{390, 440, 560, 670};

Direction toward(double azimuth, double elevation) { return direction(azimuth * degree, elevation * degree); }

/// Draft tables take a second; AIRLIGHT_LONG_TESTS=1 takes the full ones.
bool full() { return std::getenv("AIRLIGHT_LONG_TESTS") != nullptr; }
Sky sky_over(const Atmosphere& atmosphere, std::shared_ptr<Engine> engine = make_engine("simd")) {
  return Sky(atmosphere, "precomputed", std::move(engine), {{"detail", full() ? "full" : "draft"}});
}
std::vector<double> ask(const Sky& sky, const std::vector<Ray>& rays, Quantity quantity = Quantity::radiance) {
  std::vector<double> values(rays.size() * wavelengths.size());
  sky.evaluate(quantity, rays, wavelengths, values);
  return values;
}

TEST(Precomputed, light_of_all_orders_is_that_of_random_walks) {
  // Rays 0 and 2 of data/yardstick (sun 60 degrees up, from the ground, near the horizontal, where most light is of higher orders), with
  // standard errors of 0.15 %. The steps along the second, through an optical depth of 10 at 390 nm, cost 3 %; the draft's few directions
  // and altitudes some more.
  const double tolerance = full() ? 0.04 : 0.08;
  const std::vector<Ray> rays{{0, toward(45.88, 90 - 77.61), toward(0, 60)},
                              {0, toward(137.63, 90 - 89.47), toward(0, 60)}};
  const std::vector<double> truth{0.106068, 0.148414, 0.0945205, 0.0554643, 0.0702224, 0.105515, 0.0858771, 0.0631131};
  const std::vector<double> got = ask(sky_over(built_in_atmosphere("earth")), rays);
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(got[i] / truth[i], 1, tolerance) << "value " << i;
}

/// What lies behind a ray's end, in that place's own frame.
Ray rest_of(const Ray& ray, double ground_radius) {
  const double x = ray.view[0] * ray.distance, y = ray.view[1] * ray.distance,
               z = ground_radius + ray.altitude + ray.view[2] * ray.distance;
  const double height = std::sqrt(x * x + y * y + z * z);
  const Direction up{x / height, y / height, z / height};
  const auto dot = [](const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Direction& v = ray.view;
  const double along = dot(v, up), across = std::sqrt(1 - along * along);
  const Direction e{(v[0] - along * up[0]) / across, (v[1] - along * up[1]) / across, (v[2] - along * up[2]) / across};
  const Direction n{up[1] * e[2] - up[2] * e[1], up[2] * e[0] - up[0] * e[2], up[0] * e[1] - up[1] * e[0]};
  return {height - ground_radius, {across, 0, along}, {dot(ray.sun, e), dot(ray.sun, n), dot(ray.sun, up)}};
}

/// How far the light of segments plus that of the rests is from the light of the whole rays, value by value; nothing is said of whole rays
/// that are dimmer than `dimmest` of the brightest.
std::vector<double> gaps(const Sky& sky, const std::vector<Ray>& segments, double dimmest = 0) {
  std::vector<Ray> whole = segments, rest;
  for (Ray& ray : whole) ray.distance = std::numeric_limits<double>::infinity();
  for (const Ray& ray : segments) rest.push_back(rest_of(ray, built_in_atmosphere("earth").planet.ground_radius));
  const auto all = ask(sky, whole), begin = ask(sky, segments, Quantity::path_radiance),
             through = ask(sky, segments, Quantity::transmittance), end = ask(sky, rest);
  const double brightest = *std::ranges::max_element(all);
  std::vector<double> found;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!(all[i] < dimmest * brightest))
      found.push_back((begin[i] + through[i] * end[i]) / all[i] - 1);  // NaN stays, and fails
  EXPECT_GT(found.size(), all.size() / 4);
  return found;
}

/// Segments of random rays from some altitudes, as many up as down.
std::vector<Ray> random_segments(const std::vector<double>& altitudes, double sun, std::size_t count) {
  const double radius = built_in_atmosphere("earth").planet.ground_radius;
  std::mt19937 random(1);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::vector<Ray> segments;
  while (segments.size() < count) {
    const double altitude = altitudes[segments.size() / 2 % altitudes.size()], side = segments.size() % 2 ? 1 : -1;
    const Direction view = toward(between(0, 180), side * std::exp(between(-4, 4.4)));
    const double down = (radius + altitude) * -view[2], gap = altitude * (2 * radius + altitude);
    const double ground = down > 0 && down * down > gap ? down - std::sqrt(down * down - gap) : 1e9;
    segments.push_back({altitude, view, toward(0, sun),
                        std::min(std::exp(between(std::log(100), std::log(1e5))), between(0, 1) * ground)});
  }
  return segments;
}

TEST(Precomputed, a_segment_and_the_rest_of_its_ray_are_the_whole) {
  const Sky sky = sky_over(built_in_atmosphere("earth"));
  std::vector<Ray> segments;
  for (const double sun : {40.0, 3.0, -5.0})
    for (const double elevation : {30.0, 1.0}) segments.push_back({0, toward(70, elevation), toward(0, sun), 20e3});
  // Whole and rest are looked up, each between cells of tables of its own, where draft tables are far apart.
  for (const double gap : gaps(sky, segments)) EXPECT_NEAR(gap, 0, full() ? 5e-3 : 0.03);
  if (!full()) return;

  for (const char* name : {"earth", "earth-hazy"}) {
    const Sky exact = sky_over(built_in_atmosphere(name));
    for (const double sun : {40.0, 10.0, 3.0, 0.0, -2.0, -4.0, -6.0, -9.0, -12.0}) {
      SCOPED_TRACE(name + std::string(", sun ") + std::to_string(sun));
      // The project's bound.
      for (const double gap : gaps(exact, random_segments({2, 10e3}, sun, 4000))) EXPECT_NEAR(gap, 0, 0.005);
      // High up one value in a hundred thousand misses it, in dusk, where tables know a whole ray and a rest that is nearly all of it to a percent.
      std::vector<double> sizes =
          gaps(exact, random_segments({2, 100, 1000, 3000, 10e3, 20e3, 35e3, 60e3}, sun, 4000), 1e-5);
      for (double& gap : sizes) gap = std::abs(gap);
      std::ranges::sort(sizes);
      EXPECT_LT(sizes[sizes.size() * 999 / 1000], 0.005);
      EXPECT_LT(sizes.back(), sun > -3 ? 0.005 : 0.012);
    }
  }
}

TEST(Precomputed, a_ray_to_the_ground_gathers_what_the_air_along_it_sends) {
  // Whole rays are looked up. What air sends is a short segment's light over its length, which the look-up hardly changes.
  for (const char* name : {"earth", "earth-hazy"}) {
    const Atmosphere air = built_in_atmosphere(name);
    const double radius = air.planet.ground_radius;
    const Sky sky = sky_over(air);
    for (const double sun : {40.0, 3.0, -4.0})
      for (const double altitude : {2.0, 30.0, 300.0, 3000.0})
        for (const double below : {0.02, 0.3, 3.0, 30.0}) {
          const double horizon = -std::acos(1 / (1 + altitude / radius)) / degree;
          const Ray whole{altitude, toward(60, horizon - below), toward(0, sun)};
          const double down = (radius + altitude) * -whole.view[2], gap = altitude * (2 * radius + altitude);
          const double path = gap / (down + std::sqrt(down * down - gap));
          const int pieces = 200;
          std::vector<Ray> before, there;
          for (int i = 0; i < pieces; ++i) {
            before.push_back(whole);
            before.back().distance = path * (i + 0.5) / pieces;
            there.push_back(rest_of(before.back(), radius));
            there.back().distance = path * 0.01 / pieces;
          }
          const auto through = ask(sky, before, Quantity::transmittance),
                     sent = ask(sky, there, Quantity::path_radiance),
                     light = ask(sky, {whole}, Quantity::path_radiance);
          for (std::size_t k = 0; k < light.size(); ++k) {
            double sum = 0;
            for (int i = 0; i < pieces; ++i) sum += through[i * light.size() + k] * sent[i * light.size() + k] * 100;
            // Cells between the tables' directions and altitudes cost up to 4 %; a draft's are wider.
            EXPECT_NEAR(light[k] / sum, 1, full() ? 0.05 : 0.15)
                << name << ", sun " << sun << ", " << altitude << " m, " << below << " below the horizon, value " << k;
          }
        }
  }
}

TEST(Precomputed, a_ray_is_the_same_among_others) {
  // Engines ask rays in packets. Segments have twice a whole ray's panels, which pass over the ends of the whole ones beside them.
  const Sky sky = sky_over(built_in_atmosphere("earth"));
  std::vector<Ray> whole, mixed;
  for (const double sun : {30.0, -2.0, -5.0})
    for (const double azimuth : {60.0, 150.0})  // to ground in light, and behind the planet's shadow's edge
      for (double view = -3.3; view > -11; view -= 0.4) whole.push_back({10e3, toward(azimuth, view), toward(0, sun)});
  for (const Ray& ray : whole) {
    mixed.push_back(ray);
    mixed.push_back(ray);
    mixed.back().distance = 1000;
  }
  const auto alone = ask(sky, whole, Quantity::path_radiance), among = ask(sky, mixed, Quantity::path_radiance);
  const std::size_t width = wavelengths.size();
  // Nothing but the order of sums in float may differ.
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(among[2 * (i / width) * width + i % width] / alone[i], 1, 1e-4) << "ray " << i / width;
}

TEST(Precomputed, the_horizontal_is_no_edge) {
  // Directions up and down are rows of their own, which meet there: at the altitudes of the tables, and between them.
  for (const char* name : {"earth", "earth-hazy"}) {
    const Sky sky = sky_over(built_in_atmosphere(name));
    for (const double sun : {40.0, 3.0, -4.0})
      for (const double altitude : {0.5, 2.0, 20.0, 79.6, 200.0, 1e3, 5e3, 30e3}) {
        const auto light =
            ask(sky, {{altitude, toward(60, -1e-4), toward(0, sun)}, {altitude, toward(60, 1e-4), toward(0, sun)}},
                Quantity::path_radiance);
        // Over two ten-thousandths of a degree light itself changes by some millionths; panels are laid anew, which costs 0.02 %.
        for (std::size_t k = 0; k < wavelengths.size(); ++k)
          EXPECT_NEAR(light[k] / light[wavelengths.size() + k], 1, 1e-3)
              << name << ", sun " << sun << ", " << altitude << " m, value " << k;
      }
  }
}

/// The light of rays by as many panels as are usual, and by the most.
std::pair<std::vector<double>, std::vector<double>> by_usual_and_most_panels(const Atmosphere& air,
                                                                             const std::vector<Ray>& rays) {
  const auto engine = make_engine("simd");
  return {ask(Sky(air, "precomputed", engine, {{"detail", "draft"}}), rays),
          ask(Sky(air, "precomputed", engine, {{"detail", "draft"}, {"panels", std::vector<double>{64}}}), rays)};
}

TEST(Precomputed, few_panels_of_a_ray_tell_nearly_what_many_do) {
  const Atmosphere hazy = built_in_atmosphere("earth-hazy");
  std::vector<Ray> rays;
  for (const double sun : {60.0, 10.0, -3.0}) {
    for (const double view : {90.0, 20.0, 1.0, 0.0}) rays.push_back({2, toward(100, view), toward(0, sun)});
    for (const double view : {-1.0, -10.0, -90.0}) rays.push_back({10e3, toward(100, view), toward(0, sun)});
    rays.push_back({2, toward(100, 0.5), toward(0, sun), 100});
    // Down into haze and out of it again, past the ground: next to nothing is seen of the densest air, where panels would crowd.
    for (const double altitude : {60.0, 300.0, 2000.0})
      rays.push_back({altitude, toward(100, -0.8 * std::acos(1 / (1 + altitude / hazy.planet.ground_radius)) / degree),
                      toward(0, sun)});
  }
  const auto [few, many] = by_usual_and_most_panels(hazy, rays);
  // docs/models/precomputed.md: few panels cost some tenths of a percent, and more where a ray passes into dusk.
  double sum = 0;
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_NEAR(few[i] / many[i], 1, 0.04) << "ray " << i / wavelengths.size() << ", value " << i % wavelengths.size();
    sum += std::abs(few[i] / many[i] - 1);
  }
  EXPECT_LT(sum / double(few.size()), 0.008);
}

TEST(Precomputed, light_along_the_edge_of_the_planets_shadow_is_found) {
  // Views along the sunlight past the limb leave the shadow so slowly that the Sun never rises far above the ground for what they see.
  const Atmosphere air = built_in_atmosphere("earth");
  std::vector<Ray> rays;
  for (const auto& [sun, lowest, highest] : {std::array{-6.0, 25e3, 32e3}, {-9.0, 60e3, 85e3}})
    for (double altitude = lowest; altitude < highest; altitude *= 1.01)
      for (const double part : {0.9, 0.95, 0.97, 0.98, 0.99, 0.995}) {
        const double dip = std::acos(air.planet.ground_radius / (air.planet.ground_radius + altitude)) / degree;
        rays.push_back({altitude, toward(0, -part * dip), toward(0, sun)});
      }
  const auto [few, many] = by_usual_and_most_panels(air, rays);
  const double brightest = *std::ranges::max_element(many);
  std::size_t judged = 0;
  for (std::size_t i = 0; i < few.size(); ++i)
    if (many[i] > 1e-3 * brightest) {
      ++judged;
      // Up to 3 %; 20 % where panels crowd where the Sun would be high, far behind the air that is seen.
      EXPECT_NEAR(few[i] / many[i], 1, 0.05) << "ray " << i / wavelengths.size();
    }
  EXPECT_GT(judged, rays.size());
}

TEST(Precomputed, first_order_from_tables_is_nearly_what_marching_gives) {
  const auto engine = make_engine("simd");
  const Sky marched = sky_over(built_in_atmosphere("earth-hazy"), engine);
  const Sky tables(built_in_atmosphere("earth-hazy"), "precomputed", engine,
                   {{"detail", full() ? "full" : "draft"}, {"first_order", "tables"}});
  std::vector<Ray> rays;
  for (const double sun : {60.0, 20.0, 3.0})
    for (const double altitude : {0.0, 0.1, 2.0, 300.0, 10e3, 35e3, 400e3}) {
      const double horizon =
          -std::acos(1 / (1 + altitude / built_in_atmosphere("earth").planet.ground_radius)) / degree;
      // Both sides of the horizon, and down: the way to the ground from 0.1 m is as short as that.
      for (const double off : {-60.0, -10.0, -1.0, -0.1, 0.1, 1.0, 30.0})
        if (altitude < 12e3 || (off > -30 && off < 1))
          rays.push_back({altitude, toward(75, horizon + off), toward(0, sun)});
    }
  const auto path = ask(marched, rays, Quantity::path_radiance), read = ask(tables, rays, Quantity::path_radiance);
  std::vector<double> error;
  for (std::size_t i = 0; i < path.size(); ++i) {
    error.push_back(std::abs(read[i] - path[i]) / std::max(path[i], 1e-9));
    EXPECT_LT(error.back(), full() ? 0.12 : 0.5)
        << rays[i / 4].altitude << " m, view z " << rays[i / 4].view[2] << ", value " << i % 4;
  }
  std::ranges::sort(error);
  // Cells of the draft are three times as wide as those of the full tables, whose median is below 1 %.
  EXPECT_LT(error[error.size() / 2], full() ? 0.01 : 0.05);
}

TEST(Precomputed, both_sides_of_the_suns_plane_are_alike) {
  const Sky sky = sky_over(built_in_atmosphere("earth"));
  std::vector<Ray> left, right;
  for (const double azimuth : {5.0, 60.0, 150.0}) {
    left.push_back({1000, toward(azimuth, 10), toward(0, -2)});
    right.push_back({1000, toward(-azimuth, 10), toward(0, -2)});
  }
  const auto a = ask(sky, left), b = ask(sky, right);
  // Rounding of directions in float, which the Sun's edge behind the horizon enlarges.
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i] / b[i], 1, 1e-4);
}

TEST(Precomputed, no_light_leaks_into_the_night) {
  // The sun 25 degrees down: the planet's shadow reaches 600 km up. What is left has been scattered many times, from far around.
  const Sky sky = sky_over(built_in_atmosphere("earth"));
  const auto day = ask(sky, {{0, {0, 0, 1}, toward(0, 40)}}),
             night = ask(sky, {{0, {0, 0, 1}, toward(0, -25)}, {35e3, toward(0, 2), toward(0, -35)}});
  for (std::size_t i = 0; i < night.size(); ++i) EXPECT_LT(night[i], 1e-9 * day[i % wavelengths.size()]);
}

TEST(Precomputed, air_too_dense_for_it_is_refused_with_a_hint) {
  Atmosphere fog = built_in_atmosphere("earth-hazy");
  fog.constituents[1].scattering = fog.constituents[1].scattering.scaled(10);
  try {
    ask(sky_over(fog), {{0, {0, 0, 1}, {0, 0, 1}}});
    FAIL() << "answered";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("vertical optical depth"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("at most 2"), std::string::npos) << error.what();
  }
}

TEST(Precomputed, air_that_scatters_nothing_is_black) {
  Atmosphere empty = built_in_atmosphere("earth");
  empty.constituents.clear();
  for (const double v : ask(sky_over(empty), {{0, toward(0, 20), toward(0, 30)}})) EXPECT_EQ(v, 0);
}

}  // namespace
}  // namespace airlight
