#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "airlight/spectrum.h"

namespace airlight {

// ---- density profiles: relative density (1 where the coefficients are stated) over altitude [m] above the ground sphere ----

/// exp(-altitude / scale_height)
struct ExponentialProfile {
  double scale_height = 8000;  ///< [m]
  bool operator==(const ExponentialProfile&) const = default;
};
/// 1 at `altitude`, falling linearly to 0 at `half_width` on both sides.
struct TentProfile {
  double altitude = 25000, half_width = 15000;  ///< [m]
  bool operator==(const TentProfile&) const = default;
};
/// Slabs of constant density, bottom to top, zero elsewhere. Edges are sharp.
struct LayersProfile {
  struct Layer {
    double bottom, top;  ///< [m]
    double density;
    bool operator==(const Layer&) const = default;
  };
  std::vector<Layer> layers;
  bool operator==(const LayersProfile&) const = default;
};
/// Density at altitudes; linear or (where both ends are positive) logarithmic between; first value below; zero above.
struct TableProfile {
  std::vector<double> altitudes;  ///< [m], strictly increasing
  std::vector<double> densities;
  bool logarithmic = false;
  bool operator==(const TableProfile&) const = default;
};
/// Number density of the US Standard Atmosphere 1976 to 120 km relative to that at sea level.
struct StandardAtmosphereProfile {
  bool operator==(const StandardAtmosphereProfile&) const = default;
};
using Profile = std::variant<ExponentialProfile, TentProfile, LayersProfile, TableProfile, StandardAtmosphereProfile>;

/// Relative density at an altitude [m]; below 0 the value at 0 continues.
double density(const Profile& profile, double altitude);
/// Mean density between two altitudes [m], exact to rounding (between kinks a closed form, or a Gauss rule that is as good).
double mean_density(const Profile& profile, double from, double to);
/// Altitudes [m], increasing, inside (0, top) where the density or its slope jumps.
std::vector<double> kinks(const Profile& profile, double top);

// ---- phase functions [1/sr], normalised to 1 over the sphere; argument 1 - cos(scattering angle), 0 = forward ----

struct RayleighPhase {
  double depolarisation = 0;  ///< depolarisation factor; 0: 3/(16 pi) (1 + cos^2)
  bool operator==(const RayleighPhase&) const = default;
};
struct IsotropicPhase {
  bool operator==(const IsotropicPhase&) const = default;
};
struct HenyeyGreensteinPhase {
  double g = 0;
  bool operator==(const HenyeyGreensteinPhase&) const = default;
};
struct CornetteShanksPhase {
  double g = 0;
  bool operator==(const CornetteShanksPhase&) const = default;
};
/// weight * HG(g1) + (1 - weight) * HG(g2)
struct DoubleHenyeyGreensteinPhase {
  double g1 = 0.8, g2 = -0.3, weight = 0.9;
  bool operator==(const DoubleHenyeyGreensteinPhase&) const = default;
};
/// Linear between scattering angles; normalised when read. The same at all wavelengths.
struct TablePhase {
  std::vector<double> angles;  ///< [rad], strictly increasing from 0 to pi
  std::vector<double> values;  ///< [1/sr]
  bool operator==(const TablePhase&) const = default;
};
using Phase = std::variant<RayleighPhase, IsotropicPhase, HenyeyGreensteinPhase, CornetteShanksPhase,
                           DoubleHenyeyGreensteinPhase, TablePhase>;

/// Phase function [1/sr] at one_minus_cos = 1 - cos(scattering angle), in [0, 2].
double phase_function(const Phase& phase, double one_minus_cos);

// ---- an atmosphere ----

struct Constituent {
  std::string name;
  Profile profile;
  Spectrum scattering;  ///< [1/m] where the relative density is 1
  Spectrum absorption;  ///< [1/m] where the relative density is 1
  Phase phase;
  bool operator==(const Constituent&) const = default;
};
struct Planet {
  double ground_radius = 6'371'000;  ///< [m]
  double top_altitude = 120'000;     ///< [m] above the ground sphere; vacuum beyond
  Spectrum albedo = 0.1;             ///< Lambertian, in [0, 1]
  bool operator==(const Planet&) const = default;
};
struct Sun {
  Spectrum irradiance;               ///< [W m^-2 nm^-1] outside the atmosphere, normal to the beam
  double angular_radius = 0.004675;  ///< [rad]
  Spectrum limb_darkening =
      0.0;  ///< exponent a of radiance(mu) = mu^a, mu = cos of the angle at the sun's surface; 0: uniform disc
  bool operator==(const Sun&) const = default;
};
struct Atmosphere {
  std::string name;
  Planet planet;
  Sun sun;
  std::vector<Constituent> constituents;
  bool operator==(const Atmosphere&) const = default;
};

/// Changes that every command accepts. Each applies to the constituent of that name and is an error where there is none.
struct AirOverrides {
  std::optional<double> aerosol_optical_depth{};  ///< vertical, extinction, at 550 nm
  std::optional<double> angstrom{};               ///< Ångström exponent of the aerosol
  std::optional<double> ozone{};                  ///< [Dobson units]
};

/// Names of the atmospheres built in: "earth", "earth-hazy", "earth-bruneton", "mars-clear".
std::vector<std::string_view> built_in_atmospheres();
/// One line on a built-in atmosphere.
std::string_view describe_atmosphere(std::string_view name);
/// A built-in atmosphere. @throws InputError with "did you mean" for an unknown name.
Atmosphere built_in_atmosphere(std::string_view name);
/// The atmosphere with the overrides applied. @throws InputError.
Atmosphere with_overrides(Atmosphere atmosphere, const AirOverrides& overrides);
/// Checks every value's range. @throws InputError naming key, value and legal range.
void validate(const Atmosphere& atmosphere);
/// Wavelengths [nm] for which every spectrum has data; 200 to 4000 nm where all are laws that hold everywhere.
Spectrum::Range wavelength_range(const Atmosphere& atmosphere);

/// 1 Dobson unit in molecules per square metre.
inline constexpr double dobson_unit = 2.687e20;

}  // namespace airlight
