// What questions may ask: errors name the place, the value and the legal range.
#pragma once
#include <cmath>
#include <string>

#include "airlight/camera.h"
#include "airlight/error.h"
#include "optics/number_text.h"

namespace airlight {

/// The i-th of what was given, in an error; no text is made for the many that are good.
struct Nth {
  const char *kind = nullptr, *what;
  std::size_t i = 0;
  std::string text() const { return kind ? std::string(kind) + ' ' + std::to_string(i) + ": " + what : what; }
};
inline void check(bool good, const Nth& what, double value, const char* range) {
  if (!good) throw InputError(what.text() + " = " + number_text(value) + ": expected " + range);
}
inline void check(bool good, const char* what, double value, const char* range) {
  check(good, Nth{nullptr, what}, value, range);
}
inline void check_altitude(double altitude, double ground_radius, const Nth& what) {
  check(altitude > -0.9 * ground_radius && altitude <= 1e12, what, altitude, "-0.9 ground radii .. 1e12 m");
}
inline double squared_length(const Direction& d) { return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; }
inline void check_unit(const Direction& d, const Nth& what) {
  const double n2 = squared_length(d);
  if (!(std::abs(n2 - 1) < 2e-3)) check(false, what, std::sqrt(n2), "a unit vector: length 1 within 0.001");
}
/// The vector at length 1.
inline Direction unit(const Direction& d) {
  const double scale = 1 / std::sqrt(squared_length(d));
  return {d[0] * scale, d[1] * scale, d[2] * scale};
}
inline Direction checked_unit(const Direction& d, const Nth& what) {
  check_unit(d, what);
  return unit(d);
}

}  // namespace airlight
