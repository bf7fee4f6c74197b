#include "scene/geography.h"

#include <ogr_spatialref.h>

#include <cmath>
#include <mutex>
#include <numbers>
#include <vector>

#include "airlight/error.h"
#include "scene/gdal_quiet.h"

namespace airlight {
namespace {

constexpr double degree = std::numbers::pi / 180;

OGRSpatialReference read_system(const std::string& wkt, const std::string& name) {
  OGRSpatialReference system;
  if (system.importFromWkt(wkt.c_str()) != OGRERR_NONE) {
    throw InputError(name + ": its coordinate system is not understood: " + wkt.substr(0, 200));
  }
  if (system.IsLocal()) throw InputError(name + ": its coordinate system is a local one, of no known place");
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

/// Latitude and longitude on the planet of a system.
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

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

/// Points without an image become NaN.
void transform(const OGRSpatialReference& from, const OGRSpatialReference& to, const std::string& name,
               std::span<std::array<double, 2>> points) {
  const GdalQuiet quiet;
  const Transformation transformation(OGRCreateCoordinateTransformation(&from, &to));
  if (!transformation) throw InputError(name + ": no way leads from its coordinate system to the scene's");
  std::vector<double> x, y;
  for (const auto& p : points) x.push_back(p[0]), y.push_back(p[1]);
  std::vector<int> done(points.size());
  transformation->Transform(int(points.size()), x.data(), y.data(), nullptr, done.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool has_image = done[i] && std::isfinite(x[i]) && std::isfinite(y[i]);
    points[i] = has_image ? std::array{x[i], y[i]} : std::array{std::nan(""), std::nan("")};
  }
}

void require_images(const std::string& name, std::span<const std::array<double, 2>> points) {
  for (const auto& p : points) {
    if (std::isnan(p[0])) {
      throw InputError(name + ": its coordinate system does not reach all of the scene's surroundings");
    }
  }
}

}  // namespace

struct Geography::Impl {
  OGRSpatialReference planet, plane;
  Transformation to_plane;
  mutable std::mutex mutex;  // a transformation is not thread-safe
};

Geography::Geography(const Place& origin, const std::string& coordinate_system) : impl_(std::make_unique<Impl>()) {
  const GdalQuiet quiet;
  if (coordinate_system.empty()) {
    impl_->planet = geographic(nullptr);
  } else {
    const OGRSpatialReference system = read_system(coordinate_system, "scene");
    impl_->planet = geographic(&system);
  }
  const std::unique_ptr<OGRSpatialReference> copy(impl_->planet.Clone());
  impl_->plane = *copy;
  impl_->plane.SetProjCS("scene");
  impl_->plane.SetAE(origin.latitude / degree, origin.longitude / degree, 0, 0);
  impl_->plane.SetLinearUnits("metre", 1);
  impl_->plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  impl_->to_plane.reset(OGRCreateCoordinateTransformation(&impl_->planet, &impl_->plane));
  if (!impl_->to_plane) throw WorkError(std::string("PROJ cannot make the scene's plane: ") + CPLGetLastErrorMsg());
}
Geography::~Geography() = default;
Geography::Geography(Geography&&) noexcept = default;
Geography& Geography::operator=(Geography&&) noexcept = default;

std::array<double, 2> Geography::plane(const Place& place) const {
  const std::lock_guard lock(impl_->mutex);
  const GdalQuiet quiet;
  double x = place.longitude / degree, y = place.latitude / degree;
  if (!impl_->to_plane->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y)) {
    throw InputError("a place on the far side of the planet has no distance east and north of the scene's origin");
  }
  return {x, y};
}

void Geography::to_system(const std::string& coordinate_system, const std::string& name,
                          std::span<std::array<double, 2>> points) const {
  transform(impl_->plane, read_system(coordinate_system, name), name, points);
  require_images(name, points);
}

void Geography::from_system(const std::string& coordinate_system, const std::string& name,
                            std::span<std::array<double, 2>> points) const {
  transform(read_system(coordinate_system, name), impl_->plane, name, points);
}

bool is_geographic(const std::string& coordinate_system, const std::string& name) {
  return read_system(coordinate_system, name).IsGeographic() != 0;
}

Place place_in(const std::string& coordinate_system, const std::string& name, const std::array<double, 2>& point) {
  const OGRSpatialReference system = read_system(coordinate_system, name);
  std::array<double, 2> p[] = {point};
  transform(system, geographic(&system), name, p);
  require_images(name, p);
  return {p[0][1] * degree, p[0][0] * degree};
}

}  // namespace airlight
