#include "batch_plane_parallel.h"

#include <fmt/core.h>

#include <array>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "json_phase.h"

namespace airlight::cli {
namespace {

constexpr std::size_t most_layers = 1000;
constexpr Interval depth_range{0, reference::deepest_layer, ""};

/// Adds what an object with "scattering_optical_depth", "absorption_optical_depth" and "phase" says.
void read_part(Fields& part, reference::Layer& layer) {
  const double scattering = part.number("scattering_optical_depth", depth_range, 0);
  layer.absorption_optical_depth += part.number("absorption_optical_depth", depth_range, 0);
  if (scattering > 0 || part.find("phase")) layer.scatterers.push_back({scattering, read_phase(part)});
  part.expect_no_more();
}

reference::Layer read_layer(Fields& fields) {
  reference::Layer layer;
  if (!fields.find("parts")) {
    read_part(fields, layer);
    return layer;
  }
  for (Fields& part : fields.objects("parts", most_layers)) read_part(part, layer);
  fields.expect_no_more();
  return layer;
}

}  // namespace

PlaneParallelScene read_plane_parallel(Fields& fields) {
  PlaneParallelScene scene;
  for (Fields& layer : fields.objects("layers", most_layers)) scene.air.layers.push_back(read_layer(layer));
  scene.air.surface_albedo = fields.number("surface_albedo", {0, 1, ""}, 0);
  const std::string observer = fields.text("observer", "ground");
  constexpr std::array<std::string_view, 2> observers{"ground", "space"};
  if (observer != "ground" && observer != "space")
    throw InputError(fmt::format("{} = {}: unknown{}", fields.path("observer"), observer.substr(0, 40),
                                 did_you_mean(observer, observers)));
  scene.from_space = observer == "space";
  return scene;
}

std::string plane_parallel_text(Fields& fields) {
  read_plane_parallel(fields);
  nlohmann::json own;
  for (const char* key : {"layers", "surface_albedo", "observer"})
    if (const auto* const value = fields.find(key)) own[key] = *value;
  return own.dump();
}

PlaneParallelScene parse_plane_parallel(const std::string& text) {
  const nlohmann::json own = nlohmann::json::parse(text);
  Fields fields(own, "");
  return read_plane_parallel(fields);
}

}  // namespace airlight::cli
