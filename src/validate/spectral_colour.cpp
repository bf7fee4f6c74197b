#include "validate/spectral_colour.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "airlight/sky.h"
#include "optics/colour_difference.h"
#include "validate/figure.h"

namespace airlight::validation {
namespace {

constexpr double degree = std::numbers::pi / 180;

template <class Weights>
Xyz sum_of(const std::vector<double>& radiance, const Weights& weights) {
  Xyz colour{};
  for (std::size_t w = 0; w < radiance.size(); ++w)
    for (std::size_t c = 0; c < 3; ++c) colour[c] += weights[w][c] * radiance[w];
  return colour;
}

/// The colours of skies by the rule that pictures use.
std::vector<Xyz> colours_of(const std::vector<SkySpectrum>& skies, const std::vector<double>& wavelengths) {
  std::map<std::string, std::vector<Xyz>> weights;
  std::vector<Xyz> colours;
  for (const SkySpectrum& sky : skies) {
    auto& own = weights[sky.atmosphere];
    if (own.empty()) own = colour_weights(built_in_atmosphere(sky.atmosphere), wavelengths);
    colours.push_back(sum_of(sky.radiance, own));
  }
  return colours;
}

ColourErrors compare(const std::vector<SkySpectrum>& skies, const std::vector<Xyz>& truth,
                     const std::vector<Xyz>& colours) {
  ColourErrors errors;
  for (ColourError* part : {&errors.day, &errors.twilight}) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < skies.size(); ++i) {
      if ((skies[i].sun_elevation >= 0) != (part == &errors.day)) continue;
      differences.push_back(colour_difference(truth[i], colours[i]));
      if (differences.back() > part->worst) part->worst = differences.back(), part->where = skies[i].where;
    }
    part->count = differences.size();
    part->median = percentile(differences, 0.5);
    part->p90 = percentile(differences, 0.9);
  }
  return errors;
}

/// Sums of a least-squares fit for any four of the wavelengths: every sky relative to its own brightness.
struct Normal {
  std::vector<std::vector<double>> products;  // wavelength by wavelength
  std::vector<Xyz> right;                     // wavelength by X, Y, Z
  double size = 0;                            // sum of squares of what is fitted
};

Normal normal_equations(const std::vector<SkySpectrum>& skies, const std::vector<Xyz>& colours, std::size_t W) {
  Normal normal{std::vector(W, std::vector<double>(W)), std::vector<Xyz>(W)};
  for (std::size_t n = 0; n < skies.size(); ++n) {
    const Xyz& colour = colours[n];
    const double brightness = colour[0] + colour[1] + colour[2];
    if (!(brightness > 0)) continue;
    for (std::size_t i = 0; i < W; ++i) {
      const double value = skies[n].radiance[i] / (brightness * brightness);
      for (std::size_t j = 0; j < W; ++j) normal.products[i][j] += value * skies[n].radiance[j];
      for (std::size_t c = 0; c < 3; ++c) normal.right[i][c] += value * colour[c];
    }
    for (const double c : colour) normal.size += c * c / (brightness * brightness);
  }
  return normal;
}

using Indices = std::array<std::size_t, 4>;

/// @param residual  sum of squares that remains
std::array<Xyz, 4> solve(const Normal& normal, const Indices& quad, double& residual) {
  std::array<Four, 4> a;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) a[i][j] = normal.products[quad[i]][quad[j]];
  // Skies differ little at neighbouring wavelengths: without this the matrix would amplify their last digits.
  const double trace = a[0][0] + a[1][1] + a[2][2] + a[3][3];
  for (std::size_t i = 0; i < 4; ++i) a[i][i] += 1e-9 * trace;
  std::array<Xyz, 4> matrix;
  residual = normal.size;
  for (std::size_t c = 0; c < 3; ++c) {
    Four right;
    for (std::size_t i = 0; i < 4; ++i) right[i] = normal.right[quad[i]][c];
    const Four column = solve_four(a, right);
    for (std::size_t i = 0; i < 4; ++i) {
      matrix[i][c] = column[i];
      residual -= column[i] * right[i];
    }
  }
  return matrix;
}

FittedQuad fitted(const std::vector<SkySpectrum>& skies, const std::vector<Xyz>& truth, const Normal& normal,
                  const Indices& quad) {
  const std::vector<double> grid = photometric_wavelengths();
  FittedQuad fit;
  double residual;
  fit.matrix = solve(normal, quad, residual);
  std::vector<Xyz> colours;
  for (const SkySpectrum& sky : skies) {
    std::vector<double> four;
    for (const std::size_t w : quad) four.push_back(sky.radiance[w]);
    colours.push_back(sum_of(four, fit.matrix));
  }
  for (std::size_t i = 0; i < 4; ++i) fit.wavelengths[i] = grid[quad[i]];
  fit.errors = compare(skies, truth, colours);
  fit.errors.wavelengths.assign(fit.wavelengths.begin(), fit.wavelengths.end());
  return fit;
}

}  // namespace

std::vector<SkySpectrum> sky_spectra(const std::string& model, const std::vector<double>& wavelengths) {
  std::vector<SkySpectrum> skies;
  const auto engine = make_engine("simd");
  for (const char* atmosphere : {"earth", "earth-hazy"}) {
    std::vector<Ray> rays;
    const std::size_t first = skies.size();
    for (const double sun : {60.0, 30.0, 10.0, 5.0, 2.0, 0.0, -2.0, -4.0, -6.0, -9.0, -12.0})
      for (const double altitude : {2.0, 10e3})
        for (const double view : {1.0, 5.0, 15.0, 40.0, 89.0})
          for (const double azimuth : {10.0, 90.0, 180.0}) {
            rays.push_back({.altitude = altitude,
                            .view = direction(azimuth * degree, view * degree),
                            .sun = direction(0, sun * degree)});
            skies.push_back(
                {fmt::format("{}, sun {:g}, from {:g} m, view {:g} degrees high, {:g} from the sun's azimuth",
                             atmosphere, sun, altitude, view, azimuth),
                 atmosphere,
                 sun,
                 {}});
          }
    std::vector<double> values(rays.size() * wavelengths.size());
    Sky(built_in_atmosphere(atmosphere), model, engine).evaluate(Quantity::radiance, rays, wavelengths, values);
    for (std::size_t i = 0; i < rays.size(); ++i)
      skies[first + i].radiance.assign(&values[i * wavelengths.size()],
                                       &values[i * wavelengths.size()] + wavelengths.size());
  }
  return skies;
}

std::vector<double> wavelengths_of(int count) {
  if (count == 3) return {440, 550, 680};
  if (count == 4) return {realtime_quad.begin(), realtime_quad.end()};
  std::vector<double> centres;
  for (int i = 0; i < count; ++i) centres.push_back(380 + 400.0 * (i + 0.5) / count);
  return centres;
}

ColourErrors colour_errors(const std::string& model, const std::vector<double>& wavelengths) {
  const std::vector<double> many = photometric_wavelengths();
  const std::vector<SkySpectrum> whole = sky_spectra(model, many), few = sky_spectra(model, wavelengths);
  ColourErrors errors = compare(whole, colours_of(whole, many), colours_of(few, wavelengths));
  errors.wavelengths = wavelengths;
  return errors;
}

FittedQuad fit_matrix(const std::vector<SkySpectrum>& skies, const std::array<double, 4>& wavelengths) {
  const std::vector<double> grid = photometric_wavelengths();
  const std::vector<Xyz> truth = colours_of(skies, grid);
  Indices quad;
  for (std::size_t i = 0; i < 4; ++i)
    quad[i] = std::size_t(std::ranges::min_element(grid, {}, [&](double w) { return std::abs(w - wavelengths[i]); }) -
                          grid.begin());
  return fitted(skies, truth, normal_equations(skies, truth, grid.size()), quad);
}

FittedQuad fit_quad(const std::vector<SkySpectrum>& skies) {
  const std::vector<double> grid = photometric_wavelengths();
  const std::vector<Xyz> truth = colours_of(skies, grid);
  const Normal normal = normal_equations(skies, truth, grid.size());
  constexpr std::size_t first = 2, last = 32;  // 405 and 705 nm: the eye sees little beyond
  Indices best{};
  double least = normal.size;
  for (std::size_t a = first; a <= last; ++a)
    for (std::size_t b = a + 1; b <= last; ++b)
      for (std::size_t c = b + 1; c <= last; ++c)
        for (std::size_t d = c + 1; d <= last; ++d) {
          double residual;
          solve(normal, {a, b, c, d}, residual);
          if (residual < least) least = residual, best = {a, b, c, d};
        }
  return fitted(skies, truth, normal, best);
}

}  // namespace airlight::validation
