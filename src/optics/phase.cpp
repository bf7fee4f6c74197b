// Phase functions on the host: the kernels' own formulas, in double.
#define AIRLIGHT_TARGET optics
#define AIRLIGHT_REP double
#include "prelude/prelude.hpp"
namespace airlight::optics {
#include "core/phase.glsl"
}  // namespace airlight::optics

#include <algorithm>
#include <cmath>

#include "airlight/atmosphere.h"

namespace airlight {
namespace {

struct Evaluate {
  double x;  // 1 - cos of the scattering angle
  double operator()(const RayleighPhase& p) const { return optics::phase_rayleigh_depolarised(p.depolarisation, x).v; }
  double operator()(const IsotropicPhase&) const { return optics::phase_isotropic(x).v; }
  double operator()(const HenyeyGreensteinPhase& p) const { return optics::phase_henyey_greenstein(p.g, x).v; }
  double operator()(const CornetteShanksPhase& p) const { return optics::phase_cornette_shanks(p.g, x).v; }
  double operator()(const DoubleHenyeyGreensteinPhase& p) const {
    return p.weight * optics::phase_henyey_greenstein(p.g1, x).v +
           (1 - p.weight) * optics::phase_henyey_greenstein(p.g2, x).v;
  }
  double operator()(const TablePhase& p) const {
    const double angle = 2 * std::asin(std::sqrt(std::clamp(x / 2, 0.0, 1.0)));
    const auto upper = std::ranges::upper_bound(p.angles, angle);
    if (upper == p.angles.begin()) return p.values.front();
    if (upper == p.angles.end()) return p.values.back();
    const auto i = std::size_t(upper - p.angles.begin());
    const double t = (angle - p.angles[i - 1]) / (p.angles[i] - p.angles[i - 1]);
    return p.values[i - 1] + t * (p.values[i] - p.values[i - 1]);
  }
};

}  // namespace

double phase_function(const Phase& phase, double one_minus_cos) { return std::visit(Evaluate{one_minus_cos}, phase); }

}  // namespace airlight
