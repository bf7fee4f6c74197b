// How much a scalar solver misses: light as (I, Q, U), scattered in successive orders by Rayleigh's matrix, against the same
// grid with the scalar phase function, which adding-doubling confirms.
#include <gtest/gtest.h>

#include <numbers>

#include "adding_doubling.h"
#include "atmospheres.h"
#include "reference/phase.h"
#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

using std::numbers::pi;

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Two axes normal to a direction of propagation: in the vertical plane, and horizontal.
struct Axes {
  explicit Axes(const Direction& d) {
    const double across = std::hypot(d[0], d[1]);
    horizontal = {d[1] / across, -d[0] / across, 0};
    vertical = cross(d, horizontal);
  }
  Direction vertical, horizontal;
};

/// A dipole answers with the part of the incoming field that is normal to the new direction, so amplitudes go through the
/// 2 x 2 projections of one pair of axes on the other; intensities follow from their squares. No angle of rotation is needed.
/// @returns  3 x 3, rows and columns (I, Q, U), Q along the vertical axis; mean over the sphere of the first element 1 / (4 pi)
std::array<double, 9> rayleigh(const Direction& from, const Direction& to) {
  const Axes a(from), b(to);
  const double vv = dot(b.vertical, a.vertical), vh = dot(b.vertical, a.horizontal);
  const double hv = dot(b.horizontal, a.vertical), hh = dot(b.horizontal, a.horizontal);
  const double f = 3 / (8 * pi);
  return {f / 2 * (vv * vv + vh * vh + hv * hv + hh * hh),
          f / 2 * (vv * vv - vh * vh + hv * hv - hh * hh),
          f * (vv * vh + hv * hh),  //
          f / 2 * (vv * vv + vh * vh - hv * hv - hh * hh),
          f / 2 * (vv * vv - vh * vh - hv * hv + hh * hh),
          f * (vv * vh - hv * hh),  //
          f * (vv * hv + vh * hh),
          f * (vv * hv - vh * hh),
          f * (vv * hh + vh * hv)};
}

/// Light on the ground (views up) and above the air (views down) from one conservative layer over black ground, for a sun of
/// irradiance 1.
struct Orders {
  /// @param more  further views, which come last
  Orders(double depth, double sun_cosine, bool polarised, const std::vector<Direction>& more = {}) {
    constexpr int half = 8, azimuths = 12, steps = 24;
    const GaussRule rule(half);
    std::vector<double> weights;
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < half; ++i)
        for (int k = 0; k < azimuths; ++k) {
          views.push_back(at((side ? -1 : 1) * rule.nodes[i], 2 * pi * (k + 0.5) / azimuths));
          weights.push_back(rule.weights[i] * 2 * pi / azimuths);
        }
    views.insert(views.end(), more.begin(), more.end());
    weights.resize(views.size(), 0.0);
    const std::size_t n = views.size();
    const auto reversed = [](const Direction& d) { return Direction{-d[0], -d[1], -d[2]}; };
    const Direction sun = reversed(at(sun_cosine));
    std::vector<std::array<double, 9>> matrices(n * n);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) matrices[a * n + b] = rayleigh(reversed(views[b]), reversed(views[a]));

    // Indices: depth, direction, component.
    std::vector<double> source((steps + 1) * n * 3, 0.0), light(source.size()), total(source.size(), 0.0);
    for (int k = 0; k <= steps; ++k)
      for (std::size_t d = 0; d < n; ++d) {
        const auto m = rayleigh(sun, reversed(views[d]));
        for (int c = 0; c < (polarised ? 3 : 1); ++c)
          source[(k * n + d) * 3 + c] = m[3 * c] * std::exp(-depth * k / steps / sun_cosine);
      }
    for (int order = 1; order < 60; ++order) {
      for (std::size_t d = 0; d < n; ++d)
        for (int c = 0; c < 3; ++c) {
          const bool down = views[d][2] > 0;
          const double x = depth / steps / std::abs(views[d][2]), passed = std::exp(-x);
          const double near = 1 - (1 - passed) / x;  // weights of a source that is linear between depths
          double value = 0;
          for (int step = 0; step <= steps; ++step) {
            const int to = down ? step : steps - step, from = down ? to - 1 : to + 1;
            if (step > 0)
              value = value * passed + source[(to * n + d) * 3 + c] * near +
                      source[(from * n + d) * 3 + c] * (1 - passed - near);
            light[(to * n + d) * 3 + c] = value;
          }
        }
      double largest = 0;
      for (std::size_t i = 0; i < light.size(); ++i) {
        total[i] += light[i];
        largest = std::max(largest, std::abs(light[i]));
      }
      if (largest < 1e-7) break;
      for (int k = 0; k <= steps; ++k)
        for (std::size_t a = 0; a < n; ++a)
          for (int r = 0; r < (polarised ? 3 : 1); ++r) {
            double sum = 0;
            for (std::size_t b = 0; b < n; ++b)
              for (int c = 0; c < 3; ++c)
                sum += weights[b] * matrices[a * n + b][3 * r + c] * light[(k * n + b) * 3 + c];
            source[(k * n + a) * 3 + r] = sum;
          }
    }
    for (std::size_t d = 0; d < n; ++d) {
      const bool down = views[d][2] > 0;
      const std::size_t k = down ? steps : 0;
      radiance.push_back(total[(k * n + d) * 3]);
      polarisation.push_back(std::hypot(total[(k * n + d) * 3 + 1], total[(k * n + d) * 3 + 2]) / radiance.back());
      (down ? downward : upward) += weights[d] * std::abs(views[d][2]) * radiance.back();
    }
  }
  std::vector<Direction> views;
  std::vector<double> radiance, polarisation;
  double upward = 0, downward = 0;
};

// Tables of Coulson, Dave & Sekera 1960 as recomputed by Natraj, Li & Yung 2009 (Astrophysical Journal 691, 1909): light that
// leaves the top of air of depth 0.5 over black ground, cosine of the sun 0.2, irradiance pi.
TEST(PlaneParallelPolarisation, vector_light_is_that_of_the_tables) {
  struct Entry {
    double mu, azimuth, i, q, u;
  };
  const std::vector<Entry> entries{{0.4, 0, 0.16889020, 0.01119511, 0},
                                   {0.999999, 0, 0.05300496, 0.03755859, 0},
                                   {0.4, 60, 0.12752450, -0.06066038, 0.05293867},
                                   {0.999999, 60, 0.05300496, -0.01877930, 0.03252669}};
  std::vector<Direction> views;
  for (const Entry& e : entries) views.push_back(at(-e.mu, e.azimuth * degree));
  const Orders vector(0.5, 0.2, true, views);
  const AddingDoubling scalar({{layer(0.5, 1, RayleighPhase{})}, 0});
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Entry& e = entries[k];
    const std::size_t d = vector.views.size() - entries.size() + k;
    // 8 nodes and 24 depths. Polarisation has more signs than the tables' own axes agree on; its degree has none.
    EXPECT_NEAR(pi * vector.radiance[d] / e.i, 1, 2e-3) << k;
    EXPECT_NEAR(vector.polarisation[d], std::hypot(e.q, e.u) / e.i, 2e-3) << k;
    const double without = pi * scalar.radiance(Level::space, {&views[k], 1}, at(0.2))[0];
    std::printf("mu %.1f, azimuth %2.0f: scalar radiance %+5.1f %%\n", e.mu, e.azimuth, 100 * (without / e.i - 1));
    if (e.mu > 0.9) {
      EXPECT_GT(without / e.i, 1.09) << "what tells the tables from scalar light";
    }
  }
}

TEST(PlaneParallelPolarisation, scalar_radiance_is_wrong_by_tenths_and_fluxes_are_little) {
  double worst = 0;
  for (const double depth : {0.1, 0.36, 1.0})
    for (const double sun : {0.2, 0.8}) {
      const Orders scalar(depth, sun, false), vector(depth, sun, true);
      const AddingDoubling solver({{layer(depth, 1, RayleighPhase{})}, 0}, {.streams = 8});
      const std::size_t half = scalar.views.size() / 2;
      const auto sky = solver.radiance(Level::ground, std::span(scalar.views).first(half), at(sun));
      double low = 0, high = 0;
      for (std::size_t d = 0; d < scalar.views.size(); ++d) {
        if (d < half) {
          EXPECT_NEAR(scalar.radiance[d] / sky[d], 1, 1e-2);  // 24 depths are few near the horizon
        }
        EXPECT_LE(vector.polarisation[d], 1);
        low = std::min(low, scalar.radiance[d] / vector.radiance[d] - 1);
        high = std::max(high, scalar.radiance[d] / vector.radiance[d] - 1);
      }
      std::printf("depth %4.2f, sun %3.1f: scalar radiance %+5.1f .. %+4.1f %%, flux up %+5.2f %%, down %+5.2f %%\n",
                  depth, sun, 100 * low, 100 * high, 100 * (scalar.upward / vector.upward - 1),
                  100 * (scalar.downward / vector.downward - 1));
      worst = std::max({worst, -low, high});
      EXPECT_LT(std::abs(scalar.upward / vector.upward - 1), 0.01);
      EXPECT_LT(std::abs(scalar.downward / vector.downward - 1), 0.01);
    }
  // As docs/references.md states.
  EXPECT_GT(worst, 0.1);
  EXPECT_LT(worst, 0.2);
}

}  // namespace
}  // namespace airlight::reference
