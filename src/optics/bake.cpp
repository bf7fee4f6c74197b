#include "optics/bake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/error.h"
#include "optics/number_text.h"

namespace airlight {
namespace {

constexpr int phase_samples = 2048;
constexpr int most_zones = 64;

double largest_coefficient(const Constituent& c, const Quad& wavelengths) {
  double largest = 0;
  for (double w : wavelengths) largest = std::max(largest, c.scattering.at(w) + c.absorption.at(w));
  return largest;
}

// Densities over the altitude above the datum.
struct Densities {
  const Atmosphere& atmosphere;
  double datum;
  double at(const Constituent& c, double h) const { return density(c.profile, h + datum); }
  double mean(const Constituent& c, double from, double to) const {
    return mean_density(c.profile, from + datum, to + datum);
  }
};

// Error of the kernels' two-point Gauss rule over a zone, as optical depth.
double gauss_error(const Densities& d, const Quad& wavelengths, double a, double b) {
  double error = 0;
  for (const Constituent& c : d.atmosphere.constituents) {
    const auto part = [&](double from, double to) {
      const double middle = (from + to) / 2, half = (to - from) / 2 * 0.57735026918962576;
      return std::abs((d.at(c, middle - half) + d.at(c, middle + half)) / 2 - d.mean(c, from, to)) * (to - from);
    };
    // Halves too: a kink may lie where the whole zone's rule happens to be right.
    error += largest_coefficient(c, wavelengths) * std::max(part(a, b), part(a, (a + b) / 2) + part((a + b) / 2, b));
  }
  return error;
}

// The altitudes between which the kernels integrate: all sharp edges, then the worst zone is split, at a kink where it has one,
// until the rule is right to 1e-9 or the zones are used up. So thin layers are zones of their own.
std::vector<double> zone_edges(const Densities& d, const Quad& wavelengths, double top, const BakeOptions& options) {
  std::vector<double> edges{0, top}, bends;
  for (const Constituent& c : d.atmosphere.constituents) {
    if (largest_coefficient(c, wavelengths) == 0) continue;
    for (double k : kinks(c.profile, top + d.datum)) {
      const double h = k - d.datum;
      if (h <= 0 || h >= top) continue;
      const double below = d.at(c, h - 1e-6 * (1 + h)), above = d.at(c, h + 1e-6 * (1 + h));
      (std::abs(above - below) > 1e-3 * std::max(above, below) ? edges : bends).push_back(h);
    }
  }
  if (d.datum < 0) bends.push_back(-d.datum);
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end(), [](double a, double b) { return b - a < 1e-3; }), edges.end());
  if (int(edges.size()) - 1 > most_zones) {
    throw InputError("atmosphere '" + d.atmosphere.name + "' has " + std::to_string(edges.size() - 2) +
                     " sharp edges of layers: expected at most " + std::to_string(most_zones - 1));
  }
  const int wanted = std::max(options.zones, int(edges.size()) - 1);
  while (int(edges.size()) - 1 < wanted) {
    double worst = 1e-9;
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      if (const double e = gauss_error(d, wavelengths, edges[i], edges[i + 1]); e > worst) worst = e, at = i + 1;
    }
    if (at == 0) break;
    const double a = edges[at - 1], b = edges[at];
    double split = (a + b) / 2, best = (b - a) / 2;
    for (double k : bends) {
      if (k > a + 1 && k < b - 1 && std::abs(k - (a + b) / 2) < best) split = k, best = std::abs(k - (a + b) / 2);
    }
    edges.insert(edges.begin() + std::ptrdiff_t(at), split);
  }
  return edges;
}

// Smooth enough for a table of directions without its phase function taken out.
bool smooth(const Phase& phase) {
  return phase_function(phase, 0) < 2 * phase_function(phase, 1) &&
         phase_function(phase, 2) < 4 * phase_function(phase, 1);
}

// Constituents that scatter, by phase function: class 0 is a smooth one (or empty), the others may be peaked.
std::vector<Phase> phase_classes(const Atmosphere& atmosphere, const Quad& wavelengths) {
  std::vector<Phase> classes{IsotropicPhase{}};
  bool smooth_found = false;
  for (const Constituent& c : atmosphere.constituents) {
    double scattering = 0;
    for (double w : wavelengths) scattering += c.scattering.at(w);
    if (scattering == 0) continue;
    if (smooth(c.phase) && !smooth_found)
      classes[0] = c.phase, smooth_found = true;
    else if ((!smooth_found || !(c.phase == classes[0])) &&
             std::find(classes.begin() + 1, classes.end(), c.phase) == classes.end())
      classes.push_back(c.phase);
  }
  if (classes.size() > 4) {
    throw InputError("atmosphere '" + atmosphere.name + "' has " + std::to_string(classes.size()) +
                     " different phase functions: expected at most one smooth (Rayleigh-like) and three others");
  }
  return classes;
}

std::vector<double> at(const Spectrum& s, const Quad& wavelengths) {
  return {s.at(wavelengths[0]), s.at(wavelengths[1]), s.at(wavelengths[2]), s.at(wavelengths[3])};
}

}  // namespace

BakedAir bake(const Atmosphere& atmosphere, const Quad& wavelengths, double datum, const BakeOptions& options) {
  const auto range = wavelength_range(atmosphere);
  for (double w : wavelengths) {
    if (!(w >= range.first && w <= range.last)) {
      throw InputError("wavelength " + number_text(w) + " nm: the data of atmosphere '" + atmosphere.name +
                       "' reach from " + number_text(range.first) + " to " + number_text(range.last) + " nm");
    }
  }
  const Densities densities{atmosphere, datum};
  const double top = atmosphere.planet.top_altitude - datum;
  const std::vector<double> edges = zone_edges(densities, wavelengths, top, options);
  const int zones = int(edges.size()) - 1, cells = (options.cells + zones - 1) / zones;
  const std::vector<Phase> classes = phase_classes(atmosphere, wavelengths);

  BakedAir air;
  air.zones.shape = {zones, 1, 1};
  for (int z = 0; z < zones; ++z) {
    const double bottom = edges[std::size_t(z)], upper = edges[std::size_t(z) + 1];
    air.zones.rgba.insert(air.zones.rgba.end(), {bottom, upper, 1 / (upper - bottom), double(z)});
  }

  const int width = 2 * cells * zones;
  air.profile.shape = {width, 1 + int(classes.size()), 1};
  air.profile.rgba.assign(4 * air.profile.shape.texels(), 0);
  for (const Constituent& c : atmosphere.constituents) {
    double scatters = 0;
    for (double w : wavelengths) scatters += c.scattering.at(w);
    const auto peaked = std::find(classes.begin() + 1, classes.end(), c.phase);
    const int row = scatters == 0 ? 0 : c.phase == classes[0] ? 1 : int(peaked - classes.begin()) + 1;
    for (int z = 0; z < zones; ++z) {
      const double bottom = edges[std::size_t(z)], thickness = edges[std::size_t(z) + 1] - bottom;
      for (int i = 0; i < cells; ++i) {
        const double low = bottom + thickness * i / cells, high = bottom + thickness * (i + 1) / cells;
        // Values just inside the cell, moved together so that the cell's mean is exact: columns are then right to rounding.
        const double inset = 1e-7 * (high - low), mean = densities.mean(c, low, high);
        double ends[2] = {densities.at(c, low + inset), densities.at(c, high - inset)};
        const double shift = mean - (ends[0] + ends[1]) / 2;
        for (double& e : ends) e += shift;
        if (ends[0] < 0) ends[0] = 0, ends[1] = 2 * mean;
        if (ends[1] < 0) ends[1] = 0, ends[0] = 2 * mean;
        for (int end = 0; end < 2; ++end) {
          for (int k = 0; k < 4; ++k) {
            const double w = wavelengths[std::size_t(k)];
            const auto texel = [&](int r) -> double& {
              return air.profile
                  .rgba[4 * (std::size_t(r) * std::size_t(width) + 2 * std::size_t(z * cells + i) + std::size_t(end)) +
                        std::size_t(k)];
            };
            texel(0) += ends[end] * (c.scattering.at(w) + c.absorption.at(w));
            if (row > 0) texel(row) += ends[end] * c.scattering.at(w);
          }
        }
      }
    }
  }

  air.phases.shape = {phase_samples, int(classes.size()), 1};
  for (const Phase& phase : classes) {
    for (int i = 0; i < phase_samples; ++i) {
      const double x = double(i) / (phase_samples - 1);
      air.phases.rgba.insert(air.phases.rgba.end(), 4, phase_function(phase, 2 * x * x));
    }
  }

  const Planet& planet = atmosphere.planet;
  air.numbers["albedo"] = at(planet.albedo, wavelengths);
  air.numbers["solar_irradiance"] = at(atmosphere.sun.irradiance, wavelengths);
  air.numbers["limb_darkening"] = at(atmosphere.sun.limb_darkening, wavelengths);
  for (const double exponent : air.numbers["limb_darkening"]) {
    double mean = 0;
    constexpr int slices = 24;
    for (int i = 0; i < slices; ++i)
      mean += std::pow(std::sin((i + 0.5) / slices * std::numbers::pi), exponent + 2) / slices;
    air.numbers["disc_light"].push_back(mean);
  }
  air.numbers["ground_radius"] = {planet.ground_radius + datum};
  air.numbers["top_altitude"] = {top};
  air.numbers["sun_radius"] = {atmosphere.sun.angular_radius};
  air.numbers["classes"] = {double(classes.size())};
  air.numbers["zones"] = {double(zones)};
  air.numbers["cells"] = {double(cells)};
  air.numbers["substeps"] = {double(options.substeps)};
  return air;
}

Quad vertical_optical_depth(const BakedAir& air) {
  Quad depth{};
  const std::size_t zones = std::size_t(air.zones.shape.width),
                    texels_per_zone = std::size_t(air.profile.shape.width) / zones;
  for (std::size_t i = 0; i < zones * texels_per_zone; ++i) {
    const double* zone = &air.zones.rgba[4 * (i / texels_per_zone)];
    // Two texels a cell: each stands for half of it.
    for (std::size_t k = 0; k < 4; ++k)
      depth[k] += air.profile.rgba[4 * i + k] * (zone[1] - zone[0]) / double(texels_per_zone);
  }
  return depth;
}

}  // namespace airlight
