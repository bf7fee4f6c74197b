// Slabs of air as linear operators on light, for one term of the Fourier series in azimuth: how one scatters, and how two
// scatter when one lies on the other.
#pragma once
#include <span>
#include <vector>

#include "reference/adding_doubling_matrix.h"

namespace airlight::reference {

/// Cosines of zenith angles, all positive, upwards or downwards alike. Integrals go over the Gauss nodes, which are the
/// first of the rows and columns; the further ones have no weight, they only listen (rows: the views) or only send
/// (the last column: the sun).
struct Streams {
  std::vector<double> rows;     ///< Gauss nodes, then views
  std::vector<double> columns;  ///< Gauss nodes, then the sun
  std::vector<double> weights;  ///< of the Gauss nodes, for integrals over mu from 0 to 1
  int gauss() const { return int(weights.size()); }
};

/// What becomes of light that enters a slab at one side: radiance sent in direction mu for unit radiance arriving from
/// direction mu' is 2 mu' w' times the kernel (Hansen & Travis 1974, section 3); light that passes unscattered is not in it.
struct Response {
  Matrix reflection, transmission;
};

/// A slab between its two sides.
struct Slab {
  double optical_depth;
  Response above, below;  ///< to light that enters from above, from below
};

/// Legendre's functions of one Fourier term at the streams: moments x directions.
struct Harmonics {
  int term;  ///< m
  Matrix rows, columns;
};

/// Light that a homogeneous slab scatters once, back and on, for 4 times the kernel of a phase function 1 / (4 pi) and no
/// absorption (Hansen & Travis 1974).
double reflected_once(double optical_depth, double mu, double sun_cosine);
double transmitted_once(double optical_depth, double mu, double sun_cosine);

/// A homogeneous slab, by doubling one so thin that light scattered three times counts nothing.
/// @param moments   of the phase function
/// @param thinnest  bound for the optical depth to begin with; the relative error is about its square
Slab homogeneous_slab(double optical_depth, double single_scattering_albedo, std::span<const double> moments,
                      const Harmonics& harmonics, const Streams& streams, double thinnest);

/// `upper` on `lower`.
Slab add(const Slab& upper, const Slab& lower, const Streams& streams);

/// A slab of nothing.
Slab empty_slab(const Streams& streams);

}  // namespace airlight::reference
