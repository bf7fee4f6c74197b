#include "optics/colour.h"

#include <algorithm>
#include <cmath>

#include "airlight/sky.h"
#include "optics/shipped_data.h"
#include "optics/solve_four.h"

namespace airlight {
namespace {

constexpr double luminous_efficacy = 683;  // lm/W, by definition

const Response& observer() {
  static const Response standard =
      parse_response_csv(shipped_text("cie_1931_2deg.csv"), "cie_1931_2deg.csv").scaled(luminous_efficacy);
  return standard;
}

void add(Xyz& sum, const Xyz& v, double f) {
  for (int k = 0; k < 3; ++k) sum[std::size_t(k)] += v[std::size_t(k)] * f;
}

// Weights of samples between which shape-relative radiance is linear (constant beyond the ends).
template <class Shape>
std::vector<Xyz> hat_weights(std::span<const double> wavelengths, const Shape& shape,
                             const Response& eye = observer()) {
  std::vector<Xyz> weights(wavelengths.size(), Xyz{});
  for (std::size_t i = 0; i < eye.wavelengths.size(); ++i) {
    const double w = eye.wavelengths[i], trapezoid = i == 0 || i + 1 == eye.wavelengths.size() ? 0.5 : 1;
    const auto upper = std::ranges::upper_bound(wavelengths, w);
    const auto share = [&](std::size_t k, double part) {
      const double there = shape(wavelengths[k]);
      if (there > 0) add(weights[k], eye.curves[i], trapezoid * part * shape(w) / there);
    };
    if (upper == wavelengths.begin())
      share(0, 1);
    else if (upper == wavelengths.end())
      share(wavelengths.size() - 1, 1);
    else {
      const auto k = std::size_t(upper - wavelengths.begin());
      const double t = (w - wavelengths[k - 1]) / (wavelengths[k] - wavelengths[k - 1]);
      share(k - 1, 1 - t);
      share(k, t);
    }
  }
  return weights;
}

// Spectra (1 nm, over the observer's range) that sunlight takes on its ways through the air.
std::vector<std::vector<double>> family(const Atmosphere& atmosphere) {
  const Response& eye = observer();
  const std::size_t n = eye.wavelengths.size();
  const double top = atmosphere.planet.top_altitude;
  std::vector<double> sun(n), depth(n, 0), absorbed(n, 0), albedo(n);
  std::vector<std::vector<double>> scattering;
  for (std::size_t i = 0; i < n; ++i) {
    sun[i] = atmosphere.sun.irradiance.at(eye.wavelengths[i]);
    albedo[i] = atmosphere.planet.albedo.at(eye.wavelengths[i]);
  }
  for (const Constituent& c : atmosphere.constituents) {
    const double column = mean_density(c.profile, 0, top) * top;
    std::vector<double> s(n), a(n);
    double total = 0;
    for (std::size_t i = 0; i < n; ++i) {
      s[i] = c.scattering.at(eye.wavelengths[i]);
      a[i] = c.absorption.at(eye.wavelengths[i]) * column;
      total += s[i];
      depth[i] += s[i] * column + a[i];
    }
    if (total > 0)
      scattering.push_back(std::move(s));
    else
      for (std::size_t i = 0; i < n; ++i) absorbed[i] += a[i];  // a layer of its own, as ozone
  }
  scattering.push_back(albedo);
  scattering.emplace_back(n, 1.0);  // the sun itself
  std::vector<std::vector<double>> spectra;
  for (const auto& s : scattering) {
    for (double mass : {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 15.0, 25.0}) {
      // Twilight reaches the eye through far more of a high absorbing layer than of the air below it.
      for (double layer : {0.0, 10.0, 25.0}) {
        std::vector<double> spectrum(n), saturated(n);
        for (std::size_t i = 0; i < n; ++i) {
          const double light = sun[i] * s[i] * std::exp(-layer * absorbed[i]), path = mass * depth[i];
          spectrum[i] = light * std::exp(-path);
          // Light of a long path of air that shines and dims itself, as near the horizon.
          saturated[i] = light * (path > 1e-9 ? -std::expm1(-path) / path : 1);
        }
        spectra.push_back(std::move(spectrum));
        if (mass > 0) spectra.push_back(std::move(saturated));
      }
    }
  }
  return spectra;
}

std::vector<Xyz> fitted_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths) {
  const Response& eye = observer();
  std::array<std::array<double, 4>, 4> normal{};
  std::array<std::array<double, 4>, 3> right{};
  for (const auto& spectrum : family(atmosphere)) {
    Xyz colour{};
    std::array<double, 4> sample{};
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      add(colour, eye.curves[i], spectrum[i]);
      for (std::size_t k = 0; k < 4; ++k) {
        // Linear between the 1 nm points.
        const double apart = std::abs(eye.wavelengths[i] - wavelengths[k]);
        if (apart < 1) sample[k] += (1 - apart) * spectrum[i];
      }
    }
    const double brightness = colour[0] + colour[1] + colour[2];
    if (!(brightness > 0)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) normal[i][j] += sample[i] * sample[j] / (brightness * brightness);
      for (std::size_t c = 0; c < 3; ++c) right[c][i] += sample[i] * colour[c] / (brightness * brightness);
    }
  }
  double trace = 0;
  for (std::size_t i = 0; i < 4; ++i) trace += normal[i][i];
  if (!(trace > 0)) return hat_weights(wavelengths, [](double) { return 1.0; });
  for (std::size_t i = 0; i < 4; ++i)
    normal[i][i] += 1e-9 * trace;  // spectra of a gray planet do not tell the four apart
  std::vector<Xyz> weights(4);
  for (std::size_t c = 0; c < 3; ++c) {
    const Four column = solve_four(normal, right[c]);
    for (std::size_t k = 0; k < 4; ++k) weights[k][c] = column[k];
  }
  return weights;
}

}  // namespace

std::vector<Xyz> response_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths,
                                  const Response& response) {
  return hat_weights(
      wavelengths, [&](double w) { return atmosphere.sun.irradiance.at(w); }, response);
}

std::vector<Xyz> colour_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths) {
  if (wavelengths.size() == 4) return fitted_weights(atmosphere, wavelengths);
  return response_weights(atmosphere, wavelengths, observer());
}

std::array<double, 3> xyz_to_srgb(const Xyz& v) {
  return {3.2404542 * v[0] - 1.5371385 * v[1] - 0.4985314 * v[2],
          -0.9692660 * v[0] + 1.8760108 * v[1] + 0.0415560 * v[2],
          0.0556434 * v[0] - 0.2040259 * v[1] + 1.0572252 * v[2]};
}

Xyz srgb_to_xyz(const std::array<double, 3>& c) {
  return {0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2],
          0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2],
          0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]};
}

std::array<double, 3> spectrum_to_xyz(std::span<const double> wavelengths, std::span<const double> spectrum) {
  const auto weights = hat_weights(wavelengths, [](double) { return 1.0; });
  Xyz colour{};
  for (std::size_t i = 0; i < spectrum.size(); ++i) add(colour, weights[i], spectrum[i]);
  return colour;
}

std::vector<double> photometric_wavelengths() {
  std::vector<double> wavelengths;
  for (int i = 0; i < 40; ++i) wavelengths.push_back(385 + 10 * i);
  return wavelengths;
}

}  // namespace airlight
