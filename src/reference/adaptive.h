// Adaptive quadrature of several functions at once.
#pragma once
#include <functional>
#include <span>
#include <vector>

namespace airlight::reference {

/// Writes the values of all functions at t.
using Integrand = std::function<void(double t, std::span<double> values)>;

/// Integrals of several non-negative functions from the first break to the last.
///
/// Functions shall be smooth between breaks; at a break they may start like a power (t - break)^(1/2 or more), since
/// each interval is stretched by u^2 (3 - 2u), which makes square roots smooth. A part is halved until its 7-point
/// Gauss and 15-point Kronrod sums differ by at most `tolerance` times the larger of the whole integral and its floor,
/// for every function. The Kronrod sums are returned: where functions are smooth they are far better than that.
///
/// @param breaks  increasing
/// @param floors  one for each function: precision below `tolerance` times this is of no use to the caller
/// @param parts   equal parts to begin with in each interval
std::vector<double> integrate(std::span<const double> breaks, std::span<const double> floors, double tolerance,
                              int parts, const Integrand& integrand);

}  // namespace airlight::reference
