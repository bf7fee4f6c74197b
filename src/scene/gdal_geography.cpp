// Geography by PROJ, through GDAL.
#include <ogr_spatialref.h>

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <vector>

#include "airlight/error.h"
#include "scene/gdal_functions.h"
#include "scene/gdal_quiet.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;
using Points = std::span<std::array<double, 2>>;

/// Points without an image become NaN.
void convert(OGRCoordinateTransformation& transformation, Points points) {
  std::vector<double> x, y;
  for (const auto& p : points) x.push_back(p[0]), y.push_back(p[1]);
  std::vector<int> done(points.size());
  transformation.Transform(int(points.size()), x.data(), y.data(), nullptr, done.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool has_image = done[i] && std::isfinite(x[i]) && std::isfinite(y[i]);
    points[i] = has_image ? std::array{x[i], y[i]} : std::array{std::nan(""), std::nan("")};
  }
}

void require_images(const std::string& name, Points points) {
  for (const auto& p : points) {
    if (std::isnan(p[0])) {
      throw InputError(name + ": its coordinate system does not reach all of the scene's surroundings");
    }
  }
}

/// Longitude and latitude on the planet of a system; all of Earth's are WGS 84.
OGRSpatialReference geographic(const OGRSpatialReference* system) {
  OGRSpatialReference result;
  const double earth = 6'378'137;
  if (!system || std::abs(system->GetSemiMajor() / earth - 1) < 0.01) {
    result.SetWellKnownGeogCS("WGS84");
  } else {
    const std::unique_ptr<OGRSpatialReference> own(system->CloneGeogCS());
    if (own) result = *own;
  }
  result.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return result;
}

/// A file's coordinate system, and the way to longitude and latitude [degrees].
struct System {
  OGRSpatialReference system, planet;
  Transformation to_planet, from_planet;
};
std::mutex systems_mutex;
std::map<std::string, System> systems;  // by WKT

System understood(const std::string& wkt, const std::string& name) {
  System s;
  if (s.system.importFromWkt(wkt.c_str()) != OGRERR_NONE) {
    throw InputError(name + ": its coordinate system is not understood: " + wkt.substr(0, 200));
  }
  if (s.system.IsLocal()) throw InputError(name + ": its coordinate system is a local one, of no known place");
  s.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  s.planet = geographic(&s.system);
  s.to_planet.reset(OGRCreateCoordinateTransformation(&s.system, &s.planet));
  if (s.to_planet) s.from_planet.reset(s.to_planet->GetInverse());
  if (!s.from_planet) throw InputError(name + ": no way leads from its coordinate system to longitude and latitude");
  return s;
}

/// PROJ takes long to find the best way between two datums: it is asked once for each system.
/// @param work  gets the System, alone: a transformation is not thread-safe
auto with_system(const std::string& wkt, const std::string& name, const auto& work) {
  const std::lock_guard lock(systems_mutex);
  const GdalQuiet quiet;
  auto found = systems.find(wkt);
  if (found == systems.end()) found = systems.emplace(wkt, understood(wkt, name)).first;
  return work(found->second);
}

class GdalGeography : public Geography {
 public:
  GdalGeography(const Place& origin, const std::string& coordinate_system) {
    if (!coordinate_system.empty()) {
      planet_ = with_system(coordinate_system, "scene", [](const System& s) { return s.planet; });
    }
    const GdalQuiet quiet;
    if (coordinate_system.empty()) planet_ = geographic(nullptr);
    OGRSpatialReference plane = planet_;
    plane.SetProjCS("scene");
    plane.SetAE(origin.latitude / degree, origin.longitude / degree, 0, 0);
    plane.SetLinearUnits("metre", 1);
    plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to_plane_.reset(OGRCreateCoordinateTransformation(&planet_, &plane));
    if (to_plane_) from_plane_.reset(to_plane_->GetInverse());
    if (!from_plane_) throw WorkError(std::string("PROJ cannot make the scene's plane: ") + CPLGetLastErrorMsg());
  }

  std::array<double, 2> plane(const Place& place) const override {
    std::array<double, 2> point[] = {{place.longitude / degree, place.latitude / degree}};
    through(*to_plane_, point);
    if (std::isnan(point[0][0])) {
      throw InputError("a place on the far side of the planet has no distance east and north of the scene's origin");
    }
    return point[0];
  }

  void to_system(const std::string& coordinate_system, const std::string& name, Points points) const override {
    through(*from_plane_, points);
    with_system(coordinate_system, name, [&](const System& s) { convert(*s.from_planet, points); });
    require_images(name, points);
  }

  void from_system(const std::string& coordinate_system, const std::string& name, Points points) const override {
    with_system(coordinate_system, name, [&](const System& s) { convert(*s.to_planet, points); });
    through(*to_plane_, points);
  }

 private:
  void through(OGRCoordinateTransformation& transformation, Points points) const {
    const std::lock_guard lock(mutex_);
    const GdalQuiet quiet;
    convert(transformation, points);
  }

  OGRSpatialReference planet_;
  Transformation to_plane_, from_plane_;
  mutable std::mutex mutex_;  // a transformation is not thread-safe
};

}  // namespace

namespace gdal_module {

std::unique_ptr<Geography> make_geography(const Place& origin, const std::string& coordinate_system) {
  return std::make_unique<GdalGeography>(origin, coordinate_system);
}

bool is_geographic(const std::string& coordinate_system, const std::string& name) {
  return with_system(coordinate_system, name, [](const System& s) { return s.system.IsGeographic() != 0; });
}

Place place_in(const std::string& coordinate_system, const std::string& name, const std::array<double, 2>& point) {
  std::array<double, 2> points[] = {point};
  with_system(coordinate_system, name, [&](const System& s) { convert(*s.to_planet, points); });
  require_images(name, points);
  return {points[0][1] * degree, points[0][0] * degree};
}

}  // namespace gdal_module
}  // namespace airlight
