// Adding-doubling against another way to the same light: successive orders of scattering, on a grid of depths and of
// directions in both angles, with the phase function itself in place of its Legendre series.
#include <gtest/gtest.h>

#include <numbers>

#include "adding_doubling.h"
#include "reference/phase.h"
#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

class SuccessiveOrders {
 public:
  SuccessiveOrders(const PlaneParallelAir& air, double sun_cosine, int steps_a_layer)
      : air_(air), sun_(at(sun_cosine)), steps_(steps_a_layer) {
    const GaussRule rule(half);
    for (int side = 0; side < 2; ++side)  // light that goes down, light that goes up
      for (int i = 0; i < half; ++i)
        for (int k = 0; k < azimuths; ++k) {
          // Where light comes from, as a view; the node half a step off the sun's azimuth.
          directions_.push_back(at((side ? -1 : 1) * rule.nodes[i], 2 * pi * (k + 0.5) / azimuths));
          weights_.push_back(rule.weights[i] * 2 * pi / azimuths);
        }
    for (const Layer& layer : air.layers) {
      double depth = layer.absorption_optical_depth;
      for (const Scatterer& s : layer.scatterers) depth += s.optical_depth;
      const double above = depths_.empty() ? 0 : depths_.back();
      for (int i = 0; i <= steps_; ++i)
        depths_.push_back(above + depth * i / steps_);  // an edge counts for both layers
    }
    solve();
  }

  const std::vector<Direction>& views() const { return directions_; }
  /// Radiance for views up from the ground (the first half) and down from space (the second).
  double radiance(std::size_t view) const {
    return total_[(view < directions_.size() / 2 ? depths_.size() - 1 : 0) * directions_.size() + view];
  }
  double sky_irradiance() const {
    double sum = 0;
    for (std::size_t d = 0; d < directions_.size() / 2; ++d) sum += weights_[d] * directions_[d][2] * radiance(d);
    return sum;
  }

 private:
  using Field = std::vector<double>;  // depths x directions

  double phase_of(std::size_t layer, const Direction& a, const Direction& b) const {
    const double m = 1 - (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    double sum = 0;
    for (const Scatterer& s : air_.layers[layer].scatterers) sum += s.optical_depth * phase(s.phase, m);
    return sum / (depths_[(layer + 1) * (steps_ + 1) - 1] - depths_[layer * (steps_ + 1)]);
  }

  /// Light along all directions for the light that scattering sends into them, linear in depth between the grid's points.
  Field transported(const Field& source, double ground) const {
    const std::size_t n = directions_.size(), last = depths_.size() - 1;
    Field light(source.size(), 0.0);
    for (std::size_t d = 0; d < n; ++d) {
      const bool down = d < n / 2;
      const double mu = std::abs(directions_[d][2]);
      light[(down ? 0 : last) * n + d] = down ? 0 : ground;
      for (std::size_t step = 0; step < last; ++step) {
        const std::size_t from = down ? step : last - step, to = down ? from + 1 : from - 1;
        const double x = std::abs(depths_[to] - depths_[from]) / mu, passed = std::exp(-x);
        // Weights of the source's two ends, in closed form.
        const double near = x < 1e-3 ? x / 2 - x * x / 6 : 1 - (1 - passed) / x;
        light[to * n + d] =
            light[from * n + d] * passed + source[to * n + d] * near + source[from * n + d] * (1 - passed - near);
      }
    }
    return light;
  }

  void solve() {
    const std::size_t n = directions_.size(), last = depths_.size() - 1;
    const double sun = sun_[2];
    std::vector<Field> phases;
    Field source(depths_.size() * n);
    for (std::size_t layer = 0; layer < air_.layers.size(); ++layer) {
      phases.emplace_back(n * n);
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b)
          phases[layer][a * n + b] = weights_[b] * phase_of(layer, directions_[a], directions_[b]);
        for (int k = 0; k <= steps_; ++k) {
          const std::size_t at_depth = layer * (steps_ + 1) + k;
          source[at_depth * n + a] = phase_of(layer, directions_[a], sun_) * std::exp(-depths_[at_depth] / sun);
        }
      }
    }
    double arriving = sun * std::exp(-depths_[last] / sun);
    total_.assign(source.size(), 0.0);
    for (int order = 1; order <= 60; ++order) {
      const Field light = transported(source, air_.surface_albedo / pi * arriving);
      arriving = 0;
      for (std::size_t d = 0; d < n / 2; ++d) arriving += weights_[d] * directions_[d][2] * light[last * n + d];
      for (std::size_t i = 0; i < total_.size(); ++i) total_[i] += light[i];
      for (std::size_t k = 0; k < depths_.size(); ++k)
        for (std::size_t a = 0; a < n; ++a) {
          const double* const p = &phases[k / (steps_ + 1)][a * n];
          double sum = 0;
          for (std::size_t b = 0; b < n; ++b) sum += p[b] * light[k * n + b];
          source[k * n + a] = sum;
        }
      if (*std::max_element(light.begin(), light.end()) < 1e-8) break;
    }
  }

  static constexpr int half = 8, azimuths = 12;
  const PlaneParallelAir& air_;
  Direction sun_;
  int steps_;
  std::vector<Direction> directions_;
  std::vector<double> weights_, depths_;
  Field total_;
};

// Two layers of different mixtures over bright ground, sun at 60 degrees.
TEST(AddingDoublingOrders, radiance_is_the_sum_of_its_orders) {
  const PlaneParallelAir air{{{{{0.2, RayleighPhase{0.03}}, {0.05, HenyeyGreensteinPhase{-0.2}}}, 0.1},
                              {{{0.1, RayleighPhase{}}, {0.3, CornetteShanksPhase{0.3}}}, 0.02}},
                             0.4};
  const AddingDoubling solver(air, {.streams = 8});  // the grid's own nodes, so that directions add no difference
  const SuccessiveOrders coarse(air, 0.5, 16), fine(air, 0.5, 32);
  const auto& views = fine.views();
  const std::size_t half = views.size() / 2;
  const auto sky = solver.radiance(Level::ground, std::span(views).first(half), at(0.5));
  const auto space = solver.radiance(Level::space, std::span(views).last(half), at(0.5));
  double worst = 0;
  for (std::size_t v = 0; v < views.size(); ++v) {
    // The grid of depths is of second order: two of them give the limit, to a few 1e-5 at the horizon.
    const double limit = fine.radiance(v) + (fine.radiance(v) - coarse.radiance(v)) / 3;
    worst = std::max(worst, std::abs((v < half ? sky[v] : space[v - half]) / limit - 1));
  }
  EXPECT_LT(worst, 2e-4);
  const double limit = fine.sky_irradiance() + (fine.sky_irradiance() - coarse.sky_irradiance()) / 3;
  EXPECT_NEAR(solver.fluxes(0.5).diffuse / limit, 1, 2e-5);
}

}  // namespace
}  // namespace airlight::reference
