#include "scene/sun_position.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "airlight/error.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

Place at(double latitude, double longitude) { return {latitude * degree, longitude * degree}; }

/// Angle [degrees] between a position and a published azimuth and elevation [degrees].
double apart(const SunPosition& sun, double azimuth, double elevation) {
  // Haversine: the cosine has no digits left for such small angles.
  const double de = std::sin(0.5 * (sun.elevation - elevation * degree)),
               da = std::sin(0.5 * (sun.azimuth - azimuth * degree));
  return 2 * std::asin(std::sqrt(de * de + std::cos(sun.elevation) * std::cos(elevation * degree) * da * da)) / degree;
}

/// Declination seen from the Earth's centre [degrees]: elevation at the pole, less the parallax of the polar radius,
/// 6357 km.
double declination(const std::string& time) {
  const SunPosition sun = sun_position(at(90, 0), parse_time(time));
  return (sun.elevation + 6357.0 / 149597870.7 / sun.distance * std::cos(sun.elevation)) / degree;
}

TEST(SunPosition, solar_position_algorithm_example) {
  // Reda & Andreas, Solar Position Algorithm for Solar Radiation Applications, NREL/TP-560-34302 (revised 2008),
  // appendix A.5. Its 67 s between Earth rotation and Terrestrial Time are 64.2 + 2.8 s; UT1 was UTC - 0.4 s: 0.002
  // degrees in all.
  const SunPosition sun = sun_position(at(39.742476, -105.1786), parse_time("2003-10-17T12:30:30-07:00"));
  EXPECT_LT(apart(sun, 194.34024, 39.872046), 0.002);
  EXPECT_NEAR(sun.distance, 0.9965422974, 4.3e-5);  // the Earth's radius: theirs is geocentric
}

TEST(SunPosition, meeus_example) {
  // Meeus, Astronomical Algorithms (2nd edition), examples 25.b and 28.a, 1992 October 13, 0h TD = 12 October
  // 23:59:00.8 UTC: apparent declination -7 47' 01.74", equation of time 3.427351 degrees. UT1 - UTC was -0.5 s: 0.002
  // degrees of hour angle.
  const std::string time = "1992-10-12T23:59:00.816Z";
  EXPECT_NEAR(declination(time), -(7 + 47 / 60.0 + 1.74 / 3600),
              1e-4);  // he is within 0.1", we of 0.2" by the polar radius
  // At the pole on the meridian of Greenwich "north" is the meridian of 180 degrees, so azimuth - 180 is Greenwich's
  // hour angle.
  const SunPosition sun = sun_position(at(90, 0), parse_time(time));
  const double hour_angle = (23 + 59 / 60.0 + 0.816 / 3600) * 15 - 180 + 3.427351;
  EXPECT_NEAR(std::remainder(sun.azimuth / degree - 180 - hour_angle, 360), 0, 0.003);
}

TEST(SunPosition, equinoxes_and_solstices) {
  // Times to the minute from the U.S. Naval Observatory's "Earth's Seasons"; Meeus example 27.a for 1962. At equinoxes
  // the declination changes by 0.00028 degrees a minute, and the Sun may be 0.0003 degrees off the ecliptic.
  for (const char* time :
       {"2000-03-20T07:35Z", "2020-09-22T13:31Z", "2024-03-20T03:06Z", "2024-09-22T12:44Z", "2026-03-20T14:46Z"})
    EXPECT_NEAR(declination(time), 0, 0.0006) << time;
  // Obliquity of date: 23 26' 21.4" - 46.8" a century, nutation up to 9.2" = 0.0026 degrees.
  for (const char* time : {"1962-06-21T21:24Z", "2020-06-20T21:44Z", "2024-06-20T20:51Z", "2026-06-21T08:25Z"})
    EXPECT_NEAR(declination(time), 23.4365, 0.009) << time;
  EXPECT_NEAR(declination("2024-12-21T09:20Z"), -23.4362, 0.003);
}

TEST(SunPosition, another_program_agrees_everywhere) {
  // Astronomy Engine 2.1.19 (npm astronomy-engine; VSOP87, IAU 2000B nutation, shares no code with ERFA):
  //   Horizon(date, observer, ra, dec) of Equator(Body.Sun, date, observer, ofdate = true, aberration = true), no
  //   refraction.
  const struct {
    const char* time;
    double latitude, longitude, elevation, azimuth, distance,
        tolerance = 0.001;  // its truncated series: 1" = 0.0003 degrees
  } rows[] = {
      {"2026-06-21T18:40:00Z", 46.6, 7.9, 5.7456, 298.3834, 1.016217},            // Alps, sunset
      {"2024-12-21T09:20:00Z", -33.8688, 151.2093, -3.4071, 238.6793, 0.983733},  // Sydney, dusk
      {"2024-06-20T20:51:00Z", 78.2232, 15.6267, 13.3363, 329.9574, 1.016188},    // Svalbard, polar day near midnight
      {"2020-12-21T12:00:00Z", 69.6492, 18.9553, -4.1264, 197.7729, 0.983722},    // Tromsø, polar night at noon
      {"2022-02-03T23:59:59Z", -17.7134, 178.065, 84.6477, 75.4433, 0.985709},    // Fiji, both sides
      {"2022-02-03T23:59:59Z", -14.27, -170.7, 84.0156, 249.4606, 0.985709},      // ... of the date line: Samoa
      {"1972-03-20T12:00:00Z", 0, 0, 88.1280, 90.1774, 0.996085},                 // equator, equinox, near the zenith
      {"1900-01-01T12:00:00Z", 51.4779, 0, 15.4920, 179.1238, 0.983256},          // Greenwich, before UTC
      {"2099-09-22T06:00:00Z", -54.8019, -68.3030, -32.0685, 151.9164, 1.004082,
       0.002},                                                         // Ushuaia; it foresees 130 s of Earth rotation
      {"2015-06-30T12:00:00Z", -89.9, 0, -23.0706, 0.9019, 1.016626},  // near the south pole
      {"2016-03-09T01:57:00Z", 0, 128, 64.2699, 100.1310, 0.992902},   // total eclipse, Halmahera
  };
  for (const auto& row : rows) {
    const SunPosition sun = sun_position(at(row.latitude, row.longitude), parse_time(row.time));
    EXPECT_LT(apart(sun, row.azimuth, row.elevation), row.tolerance) << row.time;
    EXPECT_NEAR(sun.distance, row.distance, 2e-5) << row.time;
  }
}

TEST(SunPosition, poles_and_date_line_are_no_special_places) {
  const Time time = parse_time("2026-06-21T18:40Z");
  const SunPosition east = sun_position(at(10, 180), time), west = sun_position(at(10, -180), time);
  EXPECT_NEAR(east.azimuth, west.azimuth, 1e-12);
  EXPECT_NEAR(east.elevation, west.elevation, 1e-12);
  EXPECT_NEAR(sun_position(at(90, 0), time).elevation, sun_position(at(90, 123), time).elevation, 1e-12);
  for (int hour = 0; hour < 24; ++hour) {
    const SunPosition sun = sun_position(at(0, 15.0 * hour - 180), time);
    EXPECT_GE(sun.azimuth, 0);
    EXPECT_LT(sun.azimuth, 2 * std::numbers::pi);
  }
}

TEST(Time, is_read_and_written) {
  const struct {
    const char *given, *utc;
  } rows[] = {
      {"2026-06-21T18:40Z", "2026-06-21T18:40:00Z"},
      {"2026-06-21T18:40:07Z", "2026-06-21T18:40:07Z"},
      {"2026-06-21T18:40:07.250Z", "2026-06-21T18:40:07.250Z"},
      {"2026-06-21T20:40:07+02:00", "2026-06-21T18:40:07Z"},
      {"2026-06-21T20:40:07+0200", "2026-06-21T18:40:07Z"},
      {"2026-01-01T00:30+01", "2025-12-31T23:30:00Z"},
      {"2024-02-28T23:30-02:00", "2024-02-29T01:30:00Z"},
      {"2000-02-29T00:00Z", "2000-02-29T00:00:00Z"},
      {"1900-01-01T00:00Z", "1900-01-01T00:00:00Z"},
      {"2016-12-31T23:59:60Z", "2016-12-31T23:59:60Z"},  // a leap second
      {"2017-01-01T05:29:60.5+05:30", "2016-12-31T23:59:60.500Z"},
  };
  for (const auto& row : rows) EXPECT_EQ(format_time(parse_time(row.given)), row.utc) << row.given;
}

TEST(Time, leap_second_is_a_second) {
  const auto hour_angle = [](const char* time) { return sun_position(at(90, 0), parse_time(time)).azimuth; };
  // 15" of Earth's turn: UT1 runs on through a leap second only if UTC - UT1 is allowed to jump, as here, where they
  // are one; so the position may stand still, but it must not jump by a day.
  EXPECT_NEAR(hour_angle("2016-12-31T23:59:60Z"), hour_angle("2017-01-01T00:00:00Z"), 16.0 / 3600 * degree);
}

TEST(Time, refuses_what_is_no_time_and_says_why) {
  const struct {
    const char *given, *part;
  } rows[] = {
      {"", "expected"},
      {"now", "expected"},
      {"2026-06-21", "expected"},
      {"2026-06-21T18:40", "zone"},
      {"2026-06-21 18:40Z", "expected"},
      {"2026-6-21T18:40Z", "expected"},
      {"21.06.2026T18:40Z", "expected"},
      {"2026-06-21T18:40Z ", "expected"},
      {"2026-06-21T18:40:Z", "expected"},
      {"2026-06-21T18:40:10.Z", "expected"},
      {"2026-06-21T18:40+2", "expected"},
      {"2026-06-21T18:40+02:", "expected"},
      {"2026-13-01T00:00Z", "month 13 is outside 1..12"},
      {"2026-00-01T00:00Z", "month 0 is outside 1..12"},
      {"2026-02-30T00:00Z", "day 30 is outside 1..28"},
      {"2024-02-30T00:00Z", "day 30 is outside 1..29"},
      {"2100-02-29T00:00Z", "day 29 is outside 1..28"},
      {"2026-06-21T24:00Z", "hour 24 is outside 0..23"},
      {"2026-06-21T18:60Z", "minute 60 is outside 0..59"},
      {"2026-06-21T18:40:61Z", "second 61 is outside 0..60"},
      {"2026-06-21T23:59:60Z", "no such second"},
      {"2016-12-31T22:59:60Z", "no such second"},
      {"2026-06-21T18:40+15:00", "outside -14:00..+14:00"},
      {"2026-06-21T18:40+02:60", "minute 60"},
      {"1899-12-31T23:59Z", "year 1899 is outside 1900..2100"},
      {"2101-01-01T00:00Z", "year 2101 is outside 1900..2100"},
  };
  for (const auto& row : rows) {
    try {
      parse_time(row.given);
      ADD_FAILURE() << row.given << " was taken";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(row.part), std::string::npos) << message;
      EXPECT_NE(message.find("'" + std::string(row.given) + "'"), std::string::npos) << message;
    }
  }
}

TEST(Place, is_read_in_degrees) {
  for (const char* text : {"46.6,7.9", " 46.6 , 7.9 ", "4.66e1,7.9"}) {
    const Place place = parse_place(text);
    EXPECT_DOUBLE_EQ(place.latitude, 46.6 * degree) << text;
    EXPECT_DOUBLE_EQ(place.longitude, 7.9 * degree) << text;
  }
  EXPECT_DOUBLE_EQ(parse_place("-90,-180").longitude, -180 * degree);
}

TEST(Place, refuses_what_is_no_place_and_says_why) {
  const struct {
    const char *given, *part;
  } rows[] = {
      {"", "LATITUDE,LONGITUDE"},
      {"46.6", "LATITUDE,LONGITUDE"},
      {"46.6,", "LATITUDE,LONGITUDE"},
      {"46.6 7.9", "LATITUDE,LONGITUDE"},
      {"46.6,7.9,3", "LATITUDE"},
      {"46,6,7,9", "LATITUDE,LONGITUDE"},
      {"46.6N,7.9E", "LATITUDE"},
      {"nan,0", "LATITUDE"},
      {"0,inf", "LATITUDE"},
      {"90.1,0", "latitude is outside -90..90"},
      {"0,180.5", "longitude is outside -180..180"},
  };
  for (const auto& row : rows) {
    try {
      parse_place(row.given);
      ADD_FAILURE() << row.given << " was taken";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(row.part), std::string::npos) << message;
      EXPECT_NE(message.find("'" + std::string(row.given) + "'"), std::string::npos) << message;
    }
  }
}

TEST(Refraction, is_that_of_the_almanacs) {
  // Apparent altitude 0: 34' (the almanacs' value); Bennett 1982 for apparent 10 and 45 degrees: 5.4' and 1.0'.
  EXPECT_NEAR(-0.57 * degree + refraction(-0.57 * degree), 0, 0.01 * degree)
      << "a sun seen on the horizon is 0.57 degrees below";
  EXPECT_NEAR(refraction((10 - 5.4 / 60) * degree) / degree * 60, 5.4, 0.1);
  EXPECT_NEAR(refraction(45 * degree) / degree * 60, 1.0, 0.05);
  EXPECT_NEAR(refraction(90 * degree), 0, 1e-6);
}

TEST(Refraction, lifts_smoothly_and_never_swaps_heights) {
  double before = -90 * degree;
  for (double h = -89.99; h <= 90; h += 0.01) {
    const double lift = refraction(h * degree), lifted = h * degree + lift;
    ASSERT_GE(lift, 0) << h;
    ASSERT_LT(lift, 0.8 * degree) << h;
    ASSERT_GT(lifted, before) << h;
    ASSERT_LT(lifted - before, 0.02 * degree) << h << ": a jump";
    before = lifted;
  }
  EXPECT_EQ(refraction(-30 * degree), 0);
}

}  // namespace
}  // namespace airlight
