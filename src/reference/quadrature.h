// Quadrature rules on the unit interval.
#pragma once
#include <array>
#include <vector>

namespace airlight::reference {

/// Gauss-Legendre rule for the integral from 0 to 1; exact for polynomials up to degree 2n - 1.
struct GaussRule {
  explicit GaussRule(int n);
  std::vector<double> nodes, weights;
};

/// The pair of 7-point Gauss and 15-point Kronrod rules on -1..1; their difference tells where to refine.
/// Nodes and weights: Piessens et al. 1983, QUADPACK, routine QK15.
namespace kronrod {
inline constexpr std::array<double, 8> nodes{// from the outermost to the centre; every second one is a Gauss node
                                             0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                             0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                             0.586087235467691130294144691258718, 0.405845151377397166906606412076961,
                                             0.207784955007898467600689403773245, 0.0};
inline constexpr std::array<double, 8> weights{
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
    0.140653259715525918745189590510238, 0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
inline constexpr std::array<double, 4> gauss_weights{
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780, 0.381830050505118944950369775488975,
    0.417959183673469387755102040816327};
inline constexpr int points = 15;

/// Node i of 0..14 in increasing order, its weight, and its weight in the Gauss rule (0: not a node of it).
struct Point {
  double node, weight, gauss_weight;
};
constexpr Point point(int i) {
  const int k = i < 8 ? i : 14 - i;
  return {i < 8 ? -nodes[k] : nodes[k], weights[k], k % 2 == 1 ? gauss_weights[k / 2] : 0.0};
}
}  // namespace kronrod

}  // namespace airlight::reference
