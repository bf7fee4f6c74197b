#include "scene/sun_position.h"

#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "airlight/error.h"
#include "scene/topocentric.h"

namespace airlight {
namespace {

constexpr double degree = ERFA_DD2R;

/// Reads text from its front.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}
  bool done() const { return rest_.empty(); }
  bool take(char c) { return !rest_.empty() && rest_.front() == c && (rest_.remove_prefix(1), true); }
  /// A whole number of exactly so many digits; -1: there is none.
  int digits(std::size_t count) {
    int value = 0;
    if (rest_.size() < count) return -1;
    for (const char c : rest_.substr(0, count)) {
      if (c < '0' || c > '9') return -1;
      value = 10 * value + (c - '0');
    }
    rest_.remove_prefix(count);
    return value;
  }
  /// ".5" after whole seconds; 0 where there is none. False: a point without digits.
  bool fraction(double& value) {
    value = 0;
    if (!take('.')) return true;
    double unit = 0.1;
    const std::size_t before = rest_.size();
    for (int digit = digits(1); digit >= 0; digit = digits(1), unit *= 0.1) value += unit * digit;
    return rest_.size() < before;
  }
  /// A decimal number.
  bool number(double& value) {
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (read.ec != std::errc() || !std::isfinite(value)) return false;
    rest_.remove_prefix(std::size_t(read.ptr - rest_.data()));
    return true;
  }
  void spaces() {
    while (take(' ')) {
    }
  }

 private:
  std::string_view rest_;
};

}  // namespace

Place parse_place(const std::string& text) {
  const auto fail = [&](const std::string& why) { throw InputError("place '" + text + "': " + why); };
  double latitude = 0, longitude = 0;
  Reader reader(text);
  reader.spaces();
  const bool first = reader.number(latitude);
  reader.spaces();
  const bool comma = first && reader.take(',');
  reader.spaces();
  const bool second = comma && reader.number(longitude);
  reader.spaces();
  if (!second || !reader.done())
    fail("expected LATITUDE,LONGITUDE in degrees, north and east positive, such as 46.6,7.9");
  if (std::abs(latitude) > 90) fail("the latitude is outside -90..90 degrees");
  if (std::abs(longitude) > 180) fail("the longitude is outside -180..180 degrees");
  return {latitude * degree, longitude * degree};
}

Time parse_time(const std::string& text) {
  const auto fail = [&](const std::string& why) { throw InputError("time '" + text + "': " + why); };
  const auto malformed = [&] {
    fail(
        "expected a date, a time and its zone (Z, or an offset from UTC), such as 2026-06-21T18:40Z or "
        "2026-06-21T20:40:30.5+02:00");
  };
  const auto within = [&](const char* what, int value, int low, int high) {
    if (value < low || value > high)
      fail(std::string("the ") + what + " " + std::to_string(value) + " is outside " + std::to_string(low) + ".." +
           std::to_string(high));
  };
  Reader reader(text);
  const int year = reader.digits(4);
  if (year < 0 || !reader.take('-')) malformed();
  const int month = reader.digits(2);
  if (month < 0 || !reader.take('-')) malformed();
  const int day = reader.digits(2);
  if (day < 0 || !reader.take('T')) malformed();
  const int hour = reader.digits(2);
  if (hour < 0 || !reader.take(':')) malformed();
  const int minute = reader.digits(2);
  if (minute < 0) malformed();
  int second = 0;
  double fraction = 0;
  if (reader.take(':') && ((second = reader.digits(2)) < 0 || !reader.fraction(fraction))) malformed();
  int offset = 0;  // minutes
  if (!reader.take('Z')) {
    const int sign = reader.take('+') ? 1 : reader.take('-') ? -1 : 0;
    if (sign == 0) malformed();
    const int hours = reader.digits(2);
    const bool colon = reader.take(':');
    const int minutes = colon || !reader.done() ? reader.digits(2) : 0;
    if (hours < 0 || minutes < 0) malformed();
    within("offset's minute", minutes, 0, 59);
    offset = sign * (60 * hours + minutes);
    if (std::abs(offset) > 14 * 60) fail("the offset is outside -14:00..+14:00");
  }
  if (!reader.done()) malformed();

  // ERFA's series for the Earth's orbit holds in these years; it would answer for others, but wrongly.
  within("year", year, 1900, 2100);
  within("month", month, 1, 12);
  namespace ch = std::chrono;
  const ch::year_month_day date{ch::year(year), ch::month(unsigned(month)), ch::day(unsigned(day))};
  within("day", day, 1, int(unsigned(ch::year_month_day_last{date.year(), ch::month_day_last{date.month()}}.day())));
  within("hour", hour, 0, 23);
  within("minute", minute, 0, 59);
  within("second", second, 0, 60);

  // The offset moves whole minutes; seconds stay, so that a leap second, which is one of UTC, is found in any zone.
  const ch::sys_time<ch::minutes> utc = ch::sys_days(date) + ch::minutes(60 * hour + minute - offset);
  const ch::sys_days midnight = ch::floor<ch::days>(utc);
  const ch::year_month_day utc_date(midnight);
  const int minutes = int((utc - midnight).count());
  Time time;
  const int status =
      eraDtf2d("UTC", int(utc_date.year()), int(unsigned(utc_date.month())), int(unsigned(utc_date.day())),
               minutes / 60, minutes % 60, second + fraction, &time.day, &time.fraction);
  if (status < 0 || (second == 60 && status >= 2)) fail("UTC has no such second");
  return time;
}

std::string format_time(const Time& time) {
  int year = 0, month = 0, day = 0, clock[4] = {};
  eraD2dtf("UTC", 3, time.day, time.fraction, &year, &month, &day, clock);
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d", year, month, day, clock[0], clock[1], clock[2]);
  std::string result = text;
  if (clock[3] != 0) {
    std::snprintf(text, sizeof text, ".%03d", clock[3]);
    result += text;
  }
  return result + "Z";
}

// Polar motion (0.0001 degrees) and the observer's own speed (0.0001 degrees of aberration) are left out.
SunPosition sun_position(const Place& place, const Time& time) {
  const EphemerisTime at = ephemeris_time(time);

  // Light reaches us from where the Sun was 8 minutes ago, barycentric. (TT serves as TDB: 2 ms.)
  double earth_of_sun[2][3], earth[2][3], then_of_sun[2][3], then[2][3];
  eraEpv00(at.tt1, at.tt2, earth_of_sun, earth);
  const double travel = eraPm(earth_of_sun[0]) * ERFA_AULT / ERFA_DAYSEC;  // days
  eraEpv00(at.tt1, at.tt2 - travel, then_of_sun, then);
  double sun[3], direction[3], distance = 0;
  for (int i = 0; i < 3; ++i) sun[i] = then[0][i] - then_of_sun[0][i] - earth[0][i];
  eraPn(sun, &distance, direction);

  // Aberration by the Earth's motion, in units of the speed of light.
  constexpr double light_speed = ERFA_DAYSEC / ERFA_AULT;  // au per day
  double velocity[3], apparent[3];
  eraSxp(1.0 / light_speed, earth[1], velocity);
  eraAb(direction, velocity, eraPm(earth_of_sun[0]), std::sqrt(1.0 - eraPdp(velocity, velocity)), apparent);
  return topocentric(place, at, {apparent[0] * distance, apparent[1] * distance, apparent[2] * distance});
}

double refraction(double elevation) {
  // Saemundsson 1986 (Sky and Telescope 72, 70), in Meeus, Astronomical Algorithms, 16.4: 1010 hPa and 10 degrees C. It
  // ends by itself: at -5 degrees, far below what anyone sees from the ground, it has fallen to 0.0004 degrees, and is
  // 0 from there on.
  const double h = elevation / degree;
  if (!(h > -5)) return 0;
  return std::max(1.02 / 60 / std::tan((h + 10.3 / (h + 5.11)) * degree), 0.0) * degree;
}

}  // namespace airlight
