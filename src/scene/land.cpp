#include "scene/land.h"

#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "optics/number_text.h"
#include "scene/geography.h"
#include "scene/map_grid.h"
#include "scene/raster_pyramid.h"

namespace airlight {
namespace {

// From below the deepest trench to above Olympus Mons: what lies beyond is no height (voids written as -32768, 1e38 ...).
constexpr float lowest_height = -12'000, highest_height = 40'000;

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// One elevation file where it lies.
struct Layer {
  ElevationFile settings;
  std::shared_ptr<const RasterFile> file;
  RasterPyramid pyramid;
  MapGrid map;
  double pixel;        ///< [m]
  double inner_blend;  ///< [m]; no more than a quarter of the file, of which something is to be left

  Layer(const ElevationFile& s, std::shared_ptr<const RasterFile> f, const Geography& geography, double extent)
      : settings(s),
        file(f),
        pyramid(f, s.band, lowest_height, highest_height),
        map(*f, geography, s.cell_size, extent),
        pixel(std::sqrt(map.pixel_width() * map.pixel_height())),
        inner_blend(
            std::min(s.blend, 0.25 * std::min(map.pixel_width() * f->width(), map.pixel_height() * f->height()))) {}

  double metres(double value) const { return value * settings.height_scale + settings.height_offset; }
  /// Distance [m] from the box around the file, about: 0 inside.
  double away(double east, double north) const {
    const double x = std::max({map.west() - east, east - map.east(), 0.0});
    const double y = std::max({map.south() - north, north - map.north(), 0.0});
    return std::max(x, y);
  }
  /// Distance [m] to the outline, positive inside.
  double inside(const std::array<double, 2>& p) const { return pyramid.inside(p[0], p[1]) * pixel; }
};

void check(const ElevationFile& file, const RasterFile& raster) {
  if (file.band < 1 || file.band > raster.bands()) {
    throw InputError(file.file + ": band = " + std::to_string(file.band) + ": expected 1 .. " +
                     std::to_string(raster.bands()));
  }
}

}  // namespace

struct Land::Impl {
  LandSettings settings;
  Place origin;
  LocalFrame frame;
  double extent = 0, plain = 0;
  std::unique_ptr<Geography> geography;  // none: no file, and so no need for PROJ
  std::vector<Layer> layers;

  Impl(LandSettings s, double radius) : settings(std::move(s)), frame(radius) {}

  /// Width [m] over which relief rises beyond a file's outline.
  double relief_rises() const { return settings.relief ? 0.5 * settings.relief->wavelength : 0; }

  /// How a place gets its altitude: (height of files) + relief * share of relief, then towards the plain.
  struct Mixture {
    double height, relief_share, land_share;
  };
  Mixture mix(double east, double north, double cell) const {
    // Towards the edge of the square all relief ends, so that the plain can go on from there.
    const double from_edge = extent - std::max(std::abs(east), std::abs(north));
    if (from_edge <= 0) return {plain, 0, 0};
    double height = plain, cover = 0, outside = 1e9;
    for (const Layer& layer : layers) {
      // Farther off than it has a say; a tenth more, since its pixels are not quite as long everywhere as in its middle.
      if (layer.away(east, north) > 1.1 * std::max(layer.settings.blend, relief_rises())) continue;
      const auto p = layer.map.pixel(east, north);
      const double inside = layer.inside(p);
      outside = std::min(outside, -inside);
      if (inside <= -layer.settings.blend) continue;
      // Inside the border where another file lies below; beyond it where there is none, and so no datum is lost.
      const double over_file = smooth_step(inside / layer.inner_blend);
      const double over_plain = inside >= 0 ? 1 : smooth_step(1 + inside / layer.settings.blend);
      const double weight = cover * over_file + (1 - cover) * over_plain;
      const double value = layer.metres(layer.pyramid.at(p[0], p[1], cell / layer.pixel));
      height += (value - height) * weight;
      cover = std::max(cover, over_plain);
    }
    const bool relieved = settings.relief && cover < 1;
    return {height, relieved ? smooth_step(outside / relief_rises()) : 0, smooth_step(from_edge / (0.1 * extent))};
  }

  void altitudes(std::span<const std::array<double, 2>> places, double cell, std::span<double> out) const {
    constexpr std::size_t most = 64;
    for (; places.size() > most; places = places.subspan(most), out = out.subspan(most)) {
      altitudes(places.first(most), cell, out);
    }
    Mixture mixtures[most];
    bool relieved = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
      mixtures[i] = mix(places[i][0], places[i][1], cell);
      relieved = relieved || mixtures[i].relief_share > 0;
    }
    float heights[most] = {};
    if (relieved) relief(*settings.relief, places, cell, heights);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Mixture& m = mixtures[i];
      out[i] = plain + (m.height + m.relief_share * double(heights[i]) - plain) * m.land_share;
    }
  }
};

Land::Land(LandSettings settings) {
  const double radius = settings.planet_radius;
  if (!(radius >= 1000 && radius <= 1e9)) {
    throw InputError("planet radius = " + number_text(radius) + ": expected 1000 .. 1e9 m");
  }
  if (!(settings.extent >= 1)) throw InputError("extent = " + number_text(settings.extent) + ": expected at least 1 m");
  impl_ = std::make_unique<Impl>(std::move(settings), radius);
  Impl& m = *impl_;
  // Beyond one radian the plane of east and north is too far from the sphere.
  m.extent = std::min(m.settings.extent, radius);
  std::vector<std::shared_ptr<const RasterFile>> files;
  for (const ElevationFile& file : m.settings.files) {
    files.push_back(open_raster(file.file));
    check(file, *files.back());
  }
  std::string system;
  std::optional<Place> middle;
  for (std::size_t i = 0; i < files.size() && system.empty(); ++i) {
    if (m.settings.files[i].cell_size > 0) continue;
    system = files[i]->coordinate_system();
    middle = middle_of(*files[i]);
  }
  m.origin = m.settings.origin.value_or(middle.value_or(Place{}));
  m.geography = make_geography(m.origin, system);
  for (std::size_t i = 0; i < files.size(); ++i) {
    m.layers.emplace_back(m.settings.files[i], files[i], *m.geography, m.extent);
  }
  if (m.settings.plain_altitude) {
    m.plain = *m.settings.plain_altitude;
  } else if (!m.layers.empty()) {
    m.plain = m.layers[0].metres(m.layers[0].pyramid.border_mean());
  }
}
Land::~Land() = default;
Land::Land(Land&&) noexcept = default;
Land& Land::operator=(Land&&) noexcept = default;

const LandSettings& Land::settings() const { return impl_->settings; }
const LocalFrame& Land::frame() const { return impl_->frame; }
Place Land::origin() const { return impl_->origin; }
double Land::plain_altitude() const { return impl_->plain; }
double Land::extent() const { return impl_->extent; }

double Land::altitude(double east, double north, double cell) const {
  const std::array<double, 2> place[] = {{east, north}};
  double altitude[1];
  impl_->altitudes(place, cell, altitude);
  return altitude[0];
}

void Land::altitudes(std::span<const std::array<double, 2>> places, double cell, std::span<double> altitudes) const {
  impl_->altitudes(places, cell, altitudes);
}

double Land::highest() const {
  const Impl& m = *impl_;
  double highest = m.plain + (m.settings.relief ? m.settings.relief->height : 0);
  // Means of many pixels hide a summit; a cubic through its neighbours overshoots.
  for (const Layer& layer : m.layers) {
    const double peak = layer.metres(layer.pyramid.highest());
    highest = std::max(highest, peak + 0.25 * std::abs(peak - m.plain) + 100);
  }
  return highest;
}

double Land::finest_cell(double east, double north, double half_width) const {
  const Impl& m = *impl_;
  const double away = std::max(std::abs(east), std::abs(north)) - half_width;
  double finest = std::numeric_limits<double>::infinity();
  if (away >= m.extent) return finest;
  for (const Layer& layer : m.layers) {
    const double margin = half_width + layer.settings.blend;
    if (east + margin < layer.map.west() || east - margin > layer.map.east() || north + margin < layer.map.south() ||
        north - margin > layer.map.north()) {
      continue;
    }
    finest = std::min(finest, layer.pixel);
  }
  // Two cells to the smallest of its gullies.
  if (m.settings.relief) finest = std::min(finest, m.settings.relief->wavelength / 1500);
  return finest;
}

GroundPoint Land::ground_at(const Place& place) const {
  const auto p = impl_->geography->plane(place);
  return {p[0], p[1], altitude(p[0], p[1])};
}

std::optional<std::array<double, 2>> Land::file_coordinates(double east, double north) const {
  if (impl_->layers.empty()) return std::nullopt;
  const Layer& layer = impl_->layers[0];
  const auto p = layer.map.pixel(east, north);
  return std::array{p[0] / layer.file->width(), p[1] / layer.file->height()};
}

}  // namespace airlight
