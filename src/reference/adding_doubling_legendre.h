// Phase functions and directions in Legendre's functions.
#pragma once
#include <span>
#include <vector>

#include "airlight/atmosphere.h"

namespace airlight::reference {

/// Moments of a phase function: the mean of P_l(cos of the scattering angle) over scattered light, l = 0 .. count - 1.
/// With them 4 pi times the phase function is the sum of (2 l + 1) moment_l P_l.
std::vector<double> legendre_moments(const Phase& phase, int count);

/// Associated Legendre functions sqrt((l - m)! / (l + m)!) P_l^m(mu) for l = 0 .. count - 1 (zero below l = m), so that
/// P_l(cos of the angle between two directions) = sum over m of (2 - [m = 0]) f_l^m(mu) f_l^m(mu') cos(m azimuth).
std::vector<double> legendre_functions(int m, int count, double mu);

}  // namespace airlight::reference
