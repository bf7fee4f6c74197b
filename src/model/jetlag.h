// The Jetlag intro's sky: its constants as the kernels take them.
#pragma once
#include <vector>

#include "model/model.h"

namespace airlight {

struct JetlagSettings {
  bool clouds = true, exact_phase = false, corrected_top_length = false, midpoint = false;
  double jitter_view = 0, jitter_light = 0;
  bool random_jitter = false;                       ///< in pictures
  bool molecules_shine = true, haze_shines = true;  ///< in pictures one of them may be shown alone
  double sun_intensity = 10, albedo = 0.3;
  double near = 10000, ground_reach = 10000;             ///< [m]
  double east = 0, south = 0;                            ///< [m] of the eye
  int short_steps = 16, near_steps = 32, far_steps = 8;  ///< along the view
  int cloud_light_steps = 16, top_light_steps = 4, clear_light_steps = 4;
};

inline constexpr double jetlag_ground_radius = 6360e3, jetlag_top = 20e3;  ///< [m]

/// The kernels' struct Jetlag.
Fields jetlag_fields(const JetlagSettings& settings);

/// The kernels' struct JetlagDrift at a time [s].
Fields jetlag_drift(double time);

}  // namespace airlight
