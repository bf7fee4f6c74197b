#include "scene/surface_colour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "airlight/error.h"
#include "airlight/spectrum.h"
#include "optics/rgb_lift.h"
#include "optics/srgb.h"
#include "scene/geography.h"
#include "scene/map_grid.h"
#include "scene/noise.h"
#include "scene/raster_pyramid.h"

namespace airlight {
namespace {

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A picture laid over the land, by its own coordinates or stretched over the first elevation file.
class Overlay {
 public:
  Overlay(const SurfaceSettings& settings, const Land& land)
      : land_(land), linear_(settings.image_linear), scale_(settings.image_scale) {
    file_ = open_raster(settings.image);
    const int bands = file_->bands();
    if (bands == 2) throw InputError(settings.image + ": 2 bands: expected 1, or at least 3 (red, green, blue)");
    const double range = file_->integer_range(1);
    unit_ = range > 0 ? 1 / range : 1;
    const float highest = std::numeric_limits<float>::max();
    for (int band = 1; band <= std::min(bands, 3); ++band) pyramids_.emplace_back(file_, band, 0.0f, highest);
    if (!file_->coordinate_system().empty() && file_->geotransform()) {
      const auto geography = make_geography(land.origin(), file_->coordinate_system());
      map_.emplace(*file_, *geography, 0, land.extent());
    } else if (!land.file_coordinates(0, 0)) {
      throw InputError(settings.image + ": says not where it lies, and there is no elevation file to stretch it over");
    }
  }

  /// Linear reflectance, and how much it counts (0 outside the picture).
  double at(const GroundPoint& g, double footprint, std::array<double, 3>& rgb) const {
    std::array<double, 2> p;
    double pixel;
    if (map_) {
      p = map_->pixel(g.east, g.north);
      pixel = std::sqrt(map_->pixel_width() * map_->pixel_height());
    } else {
      p = pixel_of(g.east, g.north);
      const auto q = pixel_of(g.east + 1, g.north);
      pixel = 1 / std::max(std::hypot(q[0] - p[0], q[1] - p[1]), 1e-9);
    }
    constexpr double edge = 8;  // pixels over which the picture ends
    const double weight = smooth_step(pyramids_[0].inside(p[0], p[1]) / edge);
    if (weight == 0) return 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double value =
          unit_ * std::max(pyramids_[std::min(k, pyramids_.size() - 1)].at(p[0], p[1], footprint / pixel), 0.0);
      rgb[k] = std::min(scale_ * (linear_ ? value : decode_srgb(std::min(value, 1.0))), 1.0);
    }
    return weight;
  }

 private:
  std::array<double, 2> pixel_of(double east, double north) const {
    const auto uv = *land_.file_coordinates(east, north);
    return {uv[0] * file_->width(), uv[1] * file_->height()};
  }

  const Land& land_;
  bool linear_;
  double scale_, unit_ = 1;
  std::shared_ptr<const RasterFile> file_;
  std::vector<RasterPyramid> pyramids_;
  std::optional<MapGrid> map_;
};

constexpr int lanes = SurfaceColour::lanes;

/// Patches, in about [-1, 1], of the sizes that the footprint leaves visible.
AIRLIGHT_EVERY_PROCESSOR
void patches(const float* east, const float* north, const float* footprint, float* sum) {
  for (int l = 0; l < lanes; ++l) sum[l] = 0;
  float amplitude = 0.6f;
  for (const float size : {900.0f, 240.0f, 60.0f, 16.0f}) {
    for (int l = 0; l < lanes; ++l) {
      const float kept = std::min(std::max(size / (2 * footprint[l]) - 1, 0.0f), 1.0f);
      sum[l] += kept * amplitude * noise(east[l] / size, north[l] / size, std::uint32_t(size)).height;
    }
    amplitude *= 0.65f;
  }
}

}  // namespace

struct SurfaceColour::Impl {
  SurfaceSettings settings;
  std::shared_ptr<const Land> land;
  std::vector<double> wavelengths;
  std::vector<double> rock, grass, snow, water;  ///< albedos
  std::vector<std::array<double, 3>> lift;
  std::optional<Overlay> overlay;
};

SurfaceColour::SurfaceColour(SurfaceSettings settings, std::shared_ptr<const Land> land,
                             std::span<const double> wavelengths)
    : impl_(std::make_unique<Impl>()) {
  Impl& m = *impl_;
  m.settings = std::move(settings);
  m.land = std::move(land);
  m.wavelengths.assign(wavelengths.begin(), wavelengths.end());
  const auto lifted = [&](const std::array<double, 3>& rgb) {
    std::vector<double> albedo(wavelengths.size());
    lift_rgb(rgb, wavelengths, albedo);
    return albedo;
  };
  m.rock = lifted(m.settings.rock);
  m.snow = lifted(m.settings.snow);
  m.water = lifted(m.settings.water);
  if (m.settings.grass) {
    m.grass = lifted(*m.settings.grass);
  } else {
    const Spectrum measured(*shipped_spectrum("grass_albedo.csv", Sampling::bins));
    for (const double w : wavelengths) m.grass.push_back(measured.at(w));
  }
  for (const double w : wavelengths) m.lift.push_back(lift_weights(w));
  if (!m.settings.image.empty()) m.overlay.emplace(m.settings, *m.land);
}
SurfaceColour::~SurfaceColour() = default;
SurfaceColour::SurfaceColour(SurfaceColour&&) noexcept = default;
SurfaceColour& SurfaceColour::operator=(SurfaceColour&&) noexcept = default;

void SurfaceColour::albedo(std::span<const TerrainHit* const> hits, double pixel_angle,
                           std::span<double> albedo) const {
  const Impl& m = *impl_;
  const SurfaceSettings& s = m.settings;
  const std::size_t wavelengths = m.wavelengths.size();
  float east[lanes], north[lanes], footprint[lanes], patch_of[lanes];
  for (std::size_t l = 0; l < std::size_t(lanes); ++l) {
    const TerrainHit& hit = *hits[std::min(l, hits.size() - 1)];
    east[l] = float(hit.ground.east), north[l] = float(hit.ground.north);
    footprint[l] = std::max(float(pixel_angle * hit.distance), 1e-6f);
  }
  patches(east, north, footprint, patch_of);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const TerrainHit& hit = *hits[i];
    std::array<double, 3> rgb{};
    const double painted = m.overlay ? m.overlay->at(hit.ground, double(footprint[i]), rgb) : 0;
    const double patch = s.variety * double(patch_of[i]);
    const double altitude = hit.ground.altitude;
    double grass = smooth_step((s.grass_line - altitude + 400 * patch) / 300),
           snow = smooth_step((altitude - s.snow_line + 400 * patch) / 250), water = 0;
    if (grass > 0 || snow > 0 || altitude <= s.water_level + 0.5) {
      const double slope = double(std::acos(std::clamp(hit.level, -1.0f, 1.0f)));
      grass *= smooth_step((s.steepest_grass - slope + 0.2 * patch) / 0.2);
      snow *= smooth_step((s.steepest_snow - slope + 0.2 * patch) / 0.2);
      water = altitude <= s.water_level + 0.5 && slope < 0.02 ? 1 : 0;
    }
    const double shade = 1 + 0.35 * patch;
    for (std::size_t k = 0; k < wavelengths; ++k) {
      double value = m.rock[k] * shade;
      value += (m.grass[k] * shade - value) * grass;
      value += (m.snow[k] - value) * snow;
      value += (m.water[k] - value) * water;
      const double image = m.lift[k][0] * rgb[0] + m.lift[k][1] * rgb[1] + m.lift[k][2] * rgb[2];
      value += (image - value) * painted;
      albedo[i * wavelengths + k] = std::clamp(value, 0.0, 1.0);
    }
  }
}

}  // namespace airlight
