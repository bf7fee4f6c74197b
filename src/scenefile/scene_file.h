// Scenes as TOML: air, sun, land, camera and picture. docs/scene_file.md lists every key.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/parameters.h"
#include "scene/land.h"
#include "scene/scene_camera.h"
#include "scene/scene_light.h"
#include "scene/scene_sun.h"
#include "scene/surface_colour.h"

namespace airlight {

/// How the picture is made and written.
struct ScenePicture {
  int samples = 1;                  ///< rays a pixel
  bool soft_shadows = true;         ///< by the sun's size
  std::optional<bool> air_shadows;  ///< mountains cut the light out of the haze; none: where the model can
  std::string model = "skyview";
  std::optional<double> exposure_ev;  ///< of a .png [EV]; none: automatic
  std::string tone;  ///< filmic, reinhard, clip or codeflow; empty: filmic, or a published system's own
};

struct Scene {
  std::string name;  ///< the file's, without folder and ending
  Atmosphere air;
  SceneCamera camera;
  SceneSun sun;
  std::vector<SceneLight> lights;  ///< beside the sun
  LandSettings
      land;  ///< files with their paths as this process finds them; the planet's radius is that of the air's planet
  bool has_land = false;  ///< false: neither files nor relief, a bare sphere
  double detail = 2;      ///< wanted side of a triangle [pixels]
  SurfaceSettings surface;
  ScenePicture picture;
  std::map<std::string, Parameters, std::less<>> parameters;  ///< of published systems, by model
};

/// @param file  for messages; files named inside are looked for beside it
/// @throws InputError: "scene.toml:12: camera.field_of_view = 200: expected 0.1 .. 170 degrees"; unknown keys get "did you mean".
Scene parse_scene(std::string_view text, const std::string& file);

/// @throws InputError.
Scene load_scene(const std::string& path);

/// A light beside the sun from the keys of `[[light]]` in one line: `body = "moon", elevation = 30`.
/// @param name  for messages
/// @param sun   whose place and time a moon shares that says not where it stands
/// @throws InputError.
SceneLight parse_light(const std::string& keys, const std::string& name, const SceneSun& sun);

/// Whether a name is that of a scene file, not of an atmosphere: only scenes have a camera.
/// @throws InputError for a file that is no TOML.
bool is_scene_file(const std::string& name);

}  // namespace airlight
