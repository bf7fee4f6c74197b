// How much more air a slanting ray crosses than a vertical one, against published formulae.
#pragma once
#include <vector>

namespace airlight::validation {

/// Kasten & Young 1989, Applied Optics 28, 4735, equation 3: for light bent by refraction. @param elevation  as seen [degrees]
double air_mass_kasten_young(double elevation);
/// Young 1994, Applied Optics 33, 1108, equation 5: for light bent by refraction. @param elevation  of the unbent ray [degrees]
double air_mass_young(double elevation);

struct AirMass {
  double elevation;                  ///< [degrees]
  double here, kasten_young, young;  ///< here: molecules of `earth`, straight rays
};
/// From the zenith to the horizon.
std::vector<AirMass> air_masses();

}  // namespace airlight::validation
