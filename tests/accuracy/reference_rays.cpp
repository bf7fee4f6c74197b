// Writes the rays and the reference's answers, one JSON object a line, in the form that `airlight probe --batch` reads:
// a model's answers can be compared without this program or its build.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "rays.h"
#include "reference/single_scattering.h"

int main() {
  using namespace airlight;
  int id = 0;
  for (const accuracy::RayGroup& group : accuracy::draw_rays()) {
    const reference::SingleScattering solver(built_in_atmosphere(group.atmosphere));
    for (const Ray& ray : group.rays) {
      const reference::RayLight light = solver.along(ray, accuracy::wavelengths);
      auto line = nlohmann::ordered_json::parse(accuracy::describe(group, ray));
      line["id"] = std::to_string(id++);
      line["quantity"] = "path_radiance";
      line["max_order"] = 1;
      line["wavelengths"] = accuracy::wavelengths;
      line["reference"] = {{"transmittance", light.transmittance},
                           {"path_radiance", light.path_radiance},
                           {"ground_radiance", light.ground_radiance},
                           {"sun_irradiance", solver.sun_irradiance(ray, accuracy::wavelengths)}};
      std::printf("%s\n", line.dump().c_str());
    }
  }
}
