#include "reference/adding_doubling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "airlight/error.h"
#include "optics/number_text.h"
#include "reference/adding_doubling_legendre.h"
#include "reference/phase.h"
#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

constexpr int fewest_streams = 32, most_streams = 64;

// A view or a sun in the horizon is a little off it: 1 / mu then stays finite, and all that e^(-depth / mu) hides is hidden
// still.
constexpr double lowest_cosine = 1e-9;

double scattering(const Layer& layer) {
  double sum = 0;
  for (const Scatterer& scatterer : layer.scatterers) sum += scatterer.optical_depth;
  return sum;
}

/// Moments of the mixture.
std::vector<double> mixed_moments(const Layer& layer, int count) {
  std::vector<double> mixed(count, 0.0);
  const double all = scattering(layer);
  for (const Scatterer& scatterer : layer.scatterers) {
    if (scatterer.optical_depth == 0) continue;
    const std::vector<double> moments = legendre_moments(scatterer.phase, count);
    for (int l = 0; l < count; ++l) mixed[l] += scatterer.optical_depth / all * moments[l];
  }
  return mixed;
}

Harmonics harmonics(int term, int moments, const Streams& streams) {
  Harmonics h{term, Matrix(moments, int(streams.rows.size())), Matrix(moments, int(streams.columns.size()))};
  const auto fill = [&](Matrix& m, const std::vector<double>& cosines) {
    for (int i = 0; i < m.columns; ++i) {
      const std::vector<double> f = legendre_functions(term, moments, cosines[i]);
      for (int l = 0; l < moments; ++l) m(l, i) = f[l];
    }
  };
  fill(h.rows, streams.rows);
  fill(h.columns, streams.columns);
  return h;
}

double checked_sun(double sun_cosine) {
  if (!(sun_cosine > 0 && sun_cosine <= 1 + 1e-9))
    throw InputError("cosine of the sun's zenith angle = " + number_text(sun_cosine) +
                     ": expected more than 0, up to 1 (flat air has no light when the sun is down)");
  return std::clamp(sun_cosine, lowest_cosine, 1.0);
}

}  // namespace

AddingDoubling::AddingDoubling(PlaneParallelAir air, AddingDoublingSettings settings)
    : air_(std::move(air)), settings_(settings) {
  validate(air_);
  const int given = 2 * (settings.streams > 0 ? settings.streams : most_streams);
  std::vector<std::vector<double>> moments;
  for (const Layer& layer : air_.layers) moments.push_back(mixed_moments(layer, given + 1));
  if (settings.streams == 0) {
    // Enough for what a phase function holds to be below 1e-7 beyond them.
    int needed = 2 * fewest_streams;
    for (const auto& mixed : moments)
      while (needed < given && std::abs(mixed[needed]) > 1e-7) needed += 2;
    settings_.streams = needed / 2;
  }
  for (std::size_t i = 0; i < moments.size(); ++i) {
    // Delta-M: the share `truncated` of the scattered light goes straight on, as if it had not been scattered.
    const double scattered = scattering(air_.layers[i]);
    const double f = moments[i][2 * settings_.streams];
    Optics optics{scattered * (1 - f) + air_.layers[i].absorption_optical_depth, 0, {}, f};
    if (optics.optical_depth > 0) optics.single_scattering_albedo = scattered * (1 - f) / optics.optical_depth;
    for (int l = 0; l < 2 * settings_.streams; ++l) optics.moments.push_back((moments[i][l] - f) / (1 - f));
    layers_.push_back(std::move(optics));
  }
}

double AddingDoubling::truncated() const {
  double largest = 0;
  for (const Optics& layer : layers_) largest = std::max(largest, std::abs(layer.truncated));
  return largest;
}

Streams AddingDoubling::streams_for(std::span<const double> views, double sun_cosine) const {
  GaussRule rule(settings_.streams);
  Streams streams{rule.nodes, rule.nodes, rule.weights};
  streams.rows.insert(streams.rows.end(), views.begin(), views.end());
  streams.columns.push_back(sun_cosine);
  return streams;
}

Slab AddingDoubling::whole_air(int term, const Streams& streams) const {
  const Harmonics functions = harmonics(term, 2 * settings_.streams, streams);
  Slab whole = empty_slab(streams);
  for (const Optics& layer : layers_) {
    Slab slab = homogeneous_slab(layer.optical_depth, layer.single_scattering_albedo, layer.moments, functions, streams,
                                 settings_.thinnest);
    whole = whole.optical_depth > 0 ? add(whole, slab, streams) : std::move(slab);
  }
  return whole;
}

/// Kernels for each row of the streams, the sun being their source; fluxes per unit irradiance normal to the beam. One term
/// of the Fourier series: the ground's reflection is in the first.
struct AddingDoubling::Solution {
  std::vector<double> at_ground, at_space;
  PlaneParallelFluxes fluxes{};
  double ground_radiance = 0;  ///< [1/sr]
};

AddingDoubling::Solution AddingDoubling::solve(int term, const Streams& streams) const {
  const Slab slab = whole_air(term, streams);
  const int gauss = streams.gauss(), rows = int(streams.rows.size()), sun = gauss;
  const double sun_cosine = streams.columns[sun];
  Solution solution;
  for (int i = 0; i < rows; ++i) {
    solution.at_ground.push_back(slab.above.transmission(i, sun));
    solution.at_space.push_back(slab.above.reflection(i, sun));
  }
  if (term > 0) return solution;

  // Irradiance on a plane for isotropic radiance 1 / pi, or for the sun: the kernel's mean over the hemisphere.
  const auto hemisphere = [&](const auto& kernel) {
    double sum = 0;
    for (int k = 0; k < gauss; ++k) sum += 2 * streams.rows[k] * streams.weights[k] * kernel(k);
    return sum;
  };
  const auto lit_from_below = [&](const Matrix& kernel, int row) {
    return hemisphere([&](int j) { return kernel(row, j); });
  };
  const double direct = sun_cosine * std::exp(-slab.optical_depth / sun_cosine);
  const double diffuse = sun_cosine * hemisphere([&](int i) { return slab.above.transmission(i, sun); });
  const double back = hemisphere([&](int i) { return lit_from_below(slab.below.reflection, i); });
  const double through = hemisphere([&](int i) {
    return std::exp(-slab.optical_depth / streams.rows[i]) + lit_from_below(slab.below.transmission, i);
  });
  const double arriving = (direct + diffuse) / (1 - air_.surface_albedo * back);
  const double reflected = air_.surface_albedo * arriving;
  solution.ground_radiance = reflected / std::numbers::pi;
  for (int i = 0; i < rows; ++i) {
    solution.at_ground[i] += reflected / sun_cosine * lit_from_below(slab.below.reflection, i);
    solution.at_space[i] +=
        reflected / sun_cosine *
        (std::exp(-slab.optical_depth / streams.rows[i]) + lit_from_below(slab.below.transmission, i));
  }
  // What delta-M takes as unscattered is skylight.
  double depth = 0;
  for (const Layer& layer : air_.layers) depth += scattering(layer) + layer.absorption_optical_depth;
  solution.fluxes.direct = sun_cosine * std::exp(-depth / sun_cosine);
  solution.fluxes.diffuse = arriving - solution.fluxes.direct;
  solution.fluxes.upward =
      sun_cosine * hemisphere([&](int i) { return slab.above.reflection(i, sun); }) + reflected * through;
  return solution;
}

/// Kernel of light scattered once.
/// @param phases  for each layer, 4 pi times the phase function times the single-scattering albedo
template <typename Phases>
double AddingDoubling::scattered_once(Level level, double mu, double sun_cosine, const Phases& phases) const {
  double sum = 0, above = 0, below = 0;
  for (const Optics& layer : layers_) below += layer.optical_depth;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const double depth = layers_[i].optical_depth;
    below -= depth;
    if (level == Level::space)
      sum += phases(i) / 4 * std::exp(-above / mu - above / sun_cosine) * reflected_once(depth, mu, sun_cosine);
    else
      sum += phases(i) / 4 * std::exp(-above / sun_cosine - below / mu) * transmitted_once(depth, mu, sun_cosine);
    above += depth;
  }
  return sum;
}

double AddingDoubling::exact_phase(std::size_t layer, double one_minus_cos) const {
  if (layers_[layer].optical_depth == 0) return 0;
  double sum = 0;
  for (const Scatterer& scatterer : air_.layers[layer].scatterers)
    sum += scatterer.optical_depth * phase(scatterer.phase, one_minus_cos);
  return 4 * std::numbers::pi * sum / layers_[layer].optical_depth;
}

std::vector<double> AddingDoubling::radiance(Level level, std::span<const Direction> views,
                                             const Direction& sun) const {
  const double sun_cosine = checked_sun(sun[2]);
  // Each cosine is solved for once, however many views share it.
  std::vector<double> cosines;
  for (const Direction& view : views) cosines.push_back(std::clamp(std::abs(view[2]), lowest_cosine, 1.0));
  std::ranges::sort(cosines);
  cosines.erase(std::unique(cosines.begin(), cosines.end()), cosines.end());
  const Streams streams = streams_for(cosines, sun_cosine);
  const auto through_air = [&](const Direction& view) { return level == Level::ground ? view[2] >= 0 : view[2] < 0; };

  std::vector<double> radiance(views.size(), 0.0), multiple(cosines.size());
  double first = 0;
  for (int term = 0, quiet = 0; term < 2 * settings_.streams && quiet < 2; ++term) {
    const Solution solution = solve(term, streams);
    double largest = 0;
    for (std::size_t c = 0; c < cosines.size(); ++c) {
      const auto once = [&](std::size_t layer) {
        const auto& [depth, albedo, moments, truncated] = layers_[layer];
        const std::vector<double> a = legendre_functions(term, int(moments.size()), cosines[c]);
        const std::vector<double> b = legendre_functions(term, int(moments.size()), sun_cosine);
        double sum = 0;
        // At the ground both go down; in space one goes up.
        for (int l = term; l < int(moments.size()); ++l)
          sum += (level == Level::space && (l + term) % 2 ? -1 : 1) * (2 * l + 1) * moments[l] * a[l] * b[l];
        return albedo * sum;
      };
      const auto& kernel = level == Level::ground ? solution.at_ground : solution.at_space;
      multiple[c] = kernel[streams.gauss() + c] - scattered_once(level, cosines[c], sun_cosine, once);
      largest = std::max(largest, std::abs(multiple[c]));
    }
    if (term == 0) first = largest;
    quiet = largest <= settings_.tolerance * first ? quiet + 1 : 0;

    for (std::size_t v = 0; v < views.size(); ++v) {
      const Direction& view = views[v];
      if (!through_air(view)) {
        if (term == 0 && level == Level::ground) radiance[v] = solution.ground_radiance;
        continue;
      }
      const double mu = std::clamp(std::abs(view[2]), lowest_cosine, 1.0);
      const auto c = std::ranges::lower_bound(cosines, mu) - cosines.begin();
      const double azimuth = std::atan2(view[0], view[1]) - std::atan2(sun[0], sun[1]);
      radiance[v] += (term == 0 ? 1 : 2) * multiple[c] * std::cos(term * azimuth) * sun_cosine / std::numbers::pi;
    }
  }

  for (std::size_t v = 0; v < views.size(); ++v) {
    const Direction& view = views[v];
    if (!through_air(view)) continue;
    const double dx = view[0] - sun[0], dy = view[1] - sun[1], dz = view[2] - sun[2];
    const double one_minus_cos = std::min(0.5 * (dx * dx + dy * dy + dz * dz), 2.0);
    const auto exact = [&](std::size_t layer) { return exact_phase(layer, one_minus_cos); };
    radiance[v] += scattered_once(level, std::clamp(std::abs(view[2]), lowest_cosine, 1.0), sun_cosine, exact) *
                   sun_cosine / std::numbers::pi;
  }
  return radiance;
}

PlaneParallelFluxes AddingDoubling::fluxes(double sun_cosine) const {
  return solve(0, streams_for({}, checked_sun(sun_cosine))).fluxes;
}

}  // namespace airlight::reference
