// The rays on which models are judged against the reference.
#pragma once
#include <string>
#include <vector>

#include "airlight/sky.h"

namespace airlight::accuracy {

inline constexpr unsigned seed = 20260621;

/// Rays of one atmosphere with one height of the sun: what is dim among them is judged by the brightest.
struct RayGroup {
  std::string atmosphere;
  double sun_elevation_deg;
  std::vector<Ray> rays;
};

/// 300 rays: 3 atmospheres (earth, earth-hazy, mars-clear), 10 sun heights from the zenith to 8 degrees below the
/// horizon, 10 rays each: observers at 0 to 400 km; views up, along the horizon, down, past the limb; half of them
/// whole rays, half segments of 100 m to 100 km. The same on every machine.
std::vector<RayGroup> draw_rays();

/// Wavelengths [nm] they are evaluated at: across the visible, in and out of ozone's absorption.
inline const std::vector<double> wavelengths{420, 500, 600, 680};

/// A ray's inputs on one line of JSON, angles in degrees.
std::string describe(const RayGroup& group, const Ray& ray);

}  // namespace airlight::accuracy
