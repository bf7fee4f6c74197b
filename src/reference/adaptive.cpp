#include "reference/adaptive.h"

#include <algorithm>
#include <cmath>

#include "reference/quadrature.h"

namespace airlight::reference {
namespace {

/// Part [begin, end] of the interval `from`..`to` between two breaks, itself stretched to 0..1.
struct Part {
  double from, to, begin, end;
  std::vector<double> kronrod, difference;
};

void evaluate(Part& part, std::size_t count, const Integrand& integrand) {
  part.kronrod.assign(count, 0.0);
  std::vector<double> gauss(count, 0.0), values(count);
  for (int i = 0; i < kronrod::points; ++i) {
    const auto [node, weight, gauss_weight] = kronrod::point(i);
    const double half = 0.5 * (part.end - part.begin), u = 0.5 * (part.begin + part.end) + half * node;
    const double length = part.to - part.from;
    integrand(part.from + length * u * u * (3 - 2 * u), values);
    const double measure = half * length * 6 * u * (1 - u);
    for (std::size_t k = 0; k < count; ++k) {
      part.kronrod[k] += weight * measure * values[k];
      gauss[k] += gauss_weight * measure * values[k];
    }
  }
  part.difference.resize(count);
  for (std::size_t k = 0; k < count; ++k) part.difference[k] = std::abs(part.kronrod[k] - gauss[k]);
}

}  // namespace

std::vector<double> integrate(std::span<const double> breaks, std::span<const double> floors, double tolerance,
                              int parts, const Integrand& integrand) {
  const std::size_t count = floors.size();
  std::vector<Part> all;
  for (std::size_t i = 1; i < breaks.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      all.push_back({breaks[i - 1], breaks[i], k / double(parts), (k + 1) / double(parts), {}, {}});
      evaluate(all.back(), count, integrand);
    }
  constexpr int deepest = 40;
  constexpr double smallest = 1e-250;  // nearer to zero, the rounding of denormal numbers would look like an error
  std::vector<double> total;
  for (int sweep = 0;; ++sweep) {
    total.assign(count, 0.0);
    for (const Part& part : all)
      for (std::size_t k = 0; k < count; ++k) total[k] += part.kronrod[k];
    const auto converged = [&](const Part& part) {
      for (std::size_t k = 0; k < count; ++k)
        if (part.difference[k] > tolerance * std::max({total[k], floors[k], smallest})) return false;
      return true;
    };
    std::vector<Part> next;
    for (Part& part : all) {
      if (converged(part)) {
        next.push_back(std::move(part));
        continue;
      }
      const double middle = 0.5 * (part.begin + part.end);
      for (const auto& [begin, end] : {std::pair{part.begin, middle}, std::pair{middle, part.end}}) {
        next.push_back({part.from, part.to, begin, end, {}, {}});
        evaluate(next.back(), count, integrand);
      }
    }
    const bool done = next.size() == all.size() || sweep == deepest;
    all = std::move(next);
    if (done) return total;
  }
}

}  // namespace airlight::reference
