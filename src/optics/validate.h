// The one place that knows which values an atmosphere may have. Keys are those of the TOML, so that a reader of a file
// can find the line that a problem stands on.
#pragma once
#include <optional>
#include <string>

#include "airlight/atmosphere.h"

namespace airlight {

/// A value that may not be.
struct Problem {
  std::string key;   ///< "constituent[1].profile.scale_height"
  std::string what;  ///< " = -3: expected 1 .. 1e8 m"
  std::string message() const { return key + what; }
};

/// A legal interval, ends included.
struct Limits {
  double low, high;
  const char* unit = "";
};
inline constexpr Limits albedo_limits{0, 1};
inline constexpr Limits coefficient_limits{0, 1000, "1/m"};
inline constexpr Limits irradiance_limits{0, 1e9, "W/m^2/nm"};
inline constexpr Limits cross_section_limits{0, 1, "m^2"};
inline constexpr Limits limb_darkening_limits{0, 10};

/// Checks a spectrum's shape, and its values where its data are (laws that hold everywhere: 360 to 830 nm).
std::optional<Problem> find_problem(const Spectrum& spectrum, const std::string& key, Limits limits);
std::optional<Problem> find_problem(const Planet& planet);
std::optional<Problem> find_problem(const Sun& sun);
std::optional<Problem> find_problem(const Profile& profile, const std::string& key);
std::optional<Problem> find_problem(const Phase& phase, const std::string& key);
std::optional<Problem> find_problem(const Constituent& constituent, const std::string& key);
/// All of these, and what its parts must have in common.
std::optional<Problem> find_problem(const Atmosphere& atmosphere);

/// Integral of a phase function table over the sphere, the table being linear in the scattering angle.
double sphere_integral(const TablePhase& table);

}  // namespace airlight
