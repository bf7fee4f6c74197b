#include "reference/adding_doubling_slab.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace airlight::reference {
namespace {

/// a * b: what a does to the light that b sends; the sum goes over Gauss nodes only.
/// @param rows  of the result to compute; the rest stays zero
Matrix times(const Matrix& a, const Matrix& b, const Streams& streams, int rows) {
  Matrix product(a.rows, b.columns);
  const int gauss = streams.gauss();
  for (int i = 0; i < rows; ++i) {
    double* const target = product.row(i);
    const auto factor = [&](int k) { return a(i, k) * 2 * streams.rows[k] * streams.weights[k]; };
    int k = 0;
    for (; k + 4 <= gauss; k += 4) {  // four at once: fewer stores, nearly all of the solver's time is spent here
      const double f0 = factor(k), f1 = factor(k + 1), f2 = factor(k + 2), f3 = factor(k + 3);
      const double *const b0 = b.row(k), *const b1 = b.row(k + 1), *const b2 = b.row(k + 2), *const b3 = b.row(k + 3);
      for (int j = 0; j < b.columns; ++j) target[j] += f0 * b0[j] + f1 * b1[j] + f2 * b2[j] + f3 * b3[j];
    }
    for (; k < gauss; ++k)
      for (int j = 0; j < b.columns; ++j) target[j] += factor(k) * b(k, j);
  }
  return product;
}
Matrix times(const Matrix& a, const Matrix& b, const Streams& streams) { return times(a, b, streams, a.rows); }

/// sum += what goes through a further slab of this depth unscattered, after (rows) or before (columns).
void add_after(Matrix& sum, const Matrix& m, double optical_depth, const Streams& streams) {
  for (int i = 0; i < sum.rows; ++i) {
    const double direct = std::exp(-optical_depth / streams.rows[i]);
    for (int j = 0; j < sum.columns; ++j) sum(i, j) += direct * m(i, j);
  }
}
void add_before(Matrix& sum, const Matrix& m, double optical_depth, const Streams& streams) {
  for (int j = 0; j < sum.columns; ++j) {
    const double direct = std::exp(-optical_depth / streams.columns[j]);
    for (int i = 0; i < sum.rows; ++i) sum(i, j) += direct * m(i, j);
  }
}
void add_to(Matrix& sum, const Matrix& m) {
  for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += m.values[i];
}

/// Two slabs lit from the side of the near one.
/// @param back  the near slab's answer to light that enters at its far side
/// @param far   the far slab's answer to light that comes from the near one
Response combine(const Response& near, const Response& back, double near_depth, const Response& far, double far_depth,
                 const Streams& streams) {
  const int gauss = streams.gauss();
  // Light between the slabs. Away from the near one: D = T + R* U; towards it: U = R (e + D). Put together,
  // (1 - R* R) D = T + R* R e, solved for the Gauss nodes; the others only listen.
  const Matrix bounce = times(back.reflection, far.reflection, streams, gauss);
  Matrix system(gauss, gauss), start = near.transmission;
  for (int i = 0; i < gauss; ++i)
    for (int j = 0; j < gauss; ++j)
      system(i, j) = (i == j ? 1 : 0) - bounce(i, j) * 2 * streams.rows[j] * streams.weights[j];
  add_before(start, bounce, near_depth, streams);
  Matrix down = solve(std::move(system), std::move(start));
  Matrix up = times(far.reflection, down, streams);
  add_before(up, far.reflection, near_depth, streams);
  down = times(back.reflection, up, streams);
  add_to(down, near.transmission);

  Response both{times(back.transmission, up, streams), times(far.transmission, down, streams)};
  add_to(both.reflection, near.reflection);
  add_after(both.reflection, up, near_depth, streams);
  add_before(both.transmission, far.transmission, near_depth, streams);
  add_after(both.transmission, down, far_depth, streams);
  return both;
}

/// Light scattered once, exact, and twice, to the lowest order in the depth.
Response thin_slab(double depth, const Matrix& forward, const Matrix& backward, const Streams& streams) {
  Response slab{Matrix(forward.rows, forward.columns), Matrix(forward.rows, forward.columns)};
  for (int i = 0; i < forward.rows; ++i)
    for (int j = 0; j < forward.columns; ++j) {
      const double a = streams.rows[i], b = streams.columns[j];
      slab.reflection(i, j) = 0.25 * backward(i, j) * reflected_once(depth, a, b);
      slab.transmission(i, j) = 0.25 * forward(i, j) * transmitted_once(depth, a, b);
    }
  // Per unit depth a slab scatters phase / (4 mu mu'). Of two scatterings in half of the cases the first is the nearer
  // one. The depth over mu saturates where a view lies in the slab's own plane.
  const auto taken = [&](double mu) { return -std::expm1(-depth / mu); };
  for (int i = 0; i < forward.rows; ++i)
    for (int k = 0; k < streams.gauss(); ++k) {
      const double factor = 0.0625 * taken(streams.rows[i]) * streams.weights[k] / streams.rows[k];
      for (int j = 0; j < forward.columns; ++j) {
        const double both = factor * taken(streams.columns[j]);
        slab.reflection(i, j) += both * (forward(i, k) * backward(k, j) + backward(i, k) * forward(k, j));
        slab.transmission(i, j) += both * (forward(i, k) * forward(k, j) + backward(i, k) * backward(k, j));
      }
    }
  return slab;
}

/// A Fourier term of 4 pi times the phase function, times the single-scattering albedo.
/// @param flip  1: both directions up or both down; -1: one up and one down
Matrix phase_matrix(double single_scattering_albedo, std::span<const double> moments, const Harmonics& harmonics,
                    int flip) {
  Matrix phase(harmonics.rows.columns, harmonics.columns.columns);
  double sign = 1;  // f_l^m(-mu) = (-1)^(l + m) f_l^m(mu)
  for (int l = harmonics.term; l < int(moments.size()); ++l, sign *= flip) {
    const double moment = sign * single_scattering_albedo * (2 * l + 1) * moments[l];
    if (moment == 0) continue;
    for (int i = 0; i < phase.rows; ++i)
      for (int j = 0; j < phase.columns; ++j) phase(i, j) += moment * harmonics.rows(l, i) * harmonics.columns(l, j);
  }
  return phase;
}

}  // namespace

double reflected_once(double depth, double mu, double sun_cosine) {
  return -std::expm1(-depth / mu - depth / sun_cosine) / (mu + sun_cosine);
}

double transmitted_once(double depth, double mu, double sun_cosine) {
  // (exp(-depth / a) - exp(-depth / b)) / (a - b), without cancellation where a and b are close.
  const double a = std::max(mu, sun_cosine), b = std::min(mu, sun_cosine), x = depth / b - depth / a;
  return x < 1e-12 ? depth / (a * b) * std::exp(-depth / a) : std::exp(-depth / a) * -std::expm1(-x) / (a - b);
}

Slab homogeneous_slab(double optical_depth, double single_scattering_albedo, std::span<const double> moments,
                      const Harmonics& harmonics, const Streams& streams, double thinnest) {
  // Rayleigh's function ends with the second moment: what it does not scatter in higher terms needs no doubling.
  const auto higher = moments.subspan(std::min(std::size_t(harmonics.term), moments.size()));
  if (single_scattering_albedo == 0 || std::ranges::all_of(higher, [](double moment) { return moment == 0; })) {
    Slab nothing = empty_slab(streams);
    nothing.optical_depth = optical_depth;
    return nothing;
  }
  const int doublings = optical_depth > thinnest ? int(std::ceil(std::log2(optical_depth / thinnest))) : 0;
  double depth = std::ldexp(optical_depth, -doublings);
  Response slab = thin_slab(depth, phase_matrix(single_scattering_albedo, moments, harmonics, 1),
                            phase_matrix(single_scattering_albedo, moments, harmonics, -1), streams);
  for (int i = 0; i < doublings; ++i, depth *= 2) slab = combine(slab, slab, depth, slab, depth, streams);
  return {optical_depth, slab, slab};
}

Slab add(const Slab& upper, const Slab& lower, const Streams& streams) {
  return {upper.optical_depth + lower.optical_depth,
          combine(upper.above, upper.below, upper.optical_depth, lower.above, lower.optical_depth, streams),
          combine(lower.below, lower.above, lower.optical_depth, upper.below, upper.optical_depth, streams)};
}

Slab empty_slab(const Streams& streams) {
  const Matrix zero(int(streams.rows.size()), int(streams.columns.size()));
  return {0, {zero, zero}, {zero, zero}};
}

}  // namespace airlight::reference
