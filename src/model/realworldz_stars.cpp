#include "model/realworldz_stars.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "airlight/sky.h"
#include "optics/colour.h"
#include "optics/csv.h"
#include "optics/shipped_data.h"

namespace airlight {

const std::vector<Star>& star_catalogue() {
  static const std::vector<Star> stars = [] {
    std::vector<Star> read;
    for (const CsvRow& row : parse_csv(shipped_text("stars.csv"), "stars.csv", "ascension,declination,magnitude,b_v")) {
      const double ascension = row.values[0] * std::numbers::pi / 180,
                   declination = row.values[1] * std::numbers::pi / 180;
      read.push_back({{std::cos(declination) * std::cos(ascension), std::cos(declination) * std::sin(ascension),
                       std::sin(declination)},
                      row.values[2],
                      row.values[3]});
    }
    return read;
  }();
  return stars;
}

std::array<double, 3> star_colour(double colour_index) {
  // Ballesteros 2012 (EPL 97, 34008), equation 14, for black bodies seen through the B and V filters.
  const double b_v = std::clamp(colour_index, -0.4, 2.0),
               temperature = 4600 * (1 / (0.92 * b_v + 1.7) + 1 / (0.92 * b_v + 0.62));
  const std::vector<double> wavelengths = photometric_wavelengths();
  std::vector<double> spectrum;
  for (double nm : wavelengths) {
    // Planck's law but for a factor; 1.438777e7 nm K is its second radiation constant.
    spectrum.push_back(std::pow(nm / 500, -5) / std::expm1(1.438777e7 / (nm * temperature)));
  }
  const auto xyz = spectrum_to_xyz(wavelengths, spectrum);
  std::array<double, 3> rgb = xyz_to_srgb({xyz[0], xyz[1], xyz[2]});
  for (double& c : rgb) c = std::max(c, 0.0);
  const double light = luminance(rgb);
  for (double& c : rgb) c /= light;
  return rgb;
}

// Faces of kernels/core/cube.glsl: what looks out of each, to the right and up in it.
constexpr struct {
  Direction out, right, up;
} faces[6] = {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
              {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},  {{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
              {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}, {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}};

StarMap star_map(int size) {
  const int side = size + 2;
  StarMap map{{side, 6 * side}, std::vector<double>(24 * std::size_t(side) * std::size_t(side))};
  const auto dot = [](const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  for (const Star& star : star_catalogue()) {
    const auto colour = star_colour(star.colour_index);
    const double light = std::pow(10, -0.4 * star.magnitude);
    for (int face = 0; face < 6; ++face) {
      const double major = dot(star.direction, faces[face].out);
      if (major <= 0.1) continue;
      const double s = dot(star.direction, faces[face].right) / major, t = dot(star.direction, faces[face].up) / major;
      const double x = (0.5 + 0.5 * s) * size + 0.5, y = (0.5 - 0.5 * t) * size + 0.5;  // texel 0 is the border
      const double texel_solid_angle = 4.0 / (double(size) * size) / std::pow(1 + s * s + t * t, 1.5);
      for (int corner = 0; corner < 4; ++corner) {
        const double i = std::floor(x) + corner % 2, j = std::floor(y) + corner / 2;
        if (i < 0 || j < 0 || i >= side || j >= side) continue;  // seen on another face
        const double part = (1 - std::abs(x - i)) * (1 - std::abs(y - j)) * light / texel_solid_angle;
        double* const texel = &map.rgba[4 * (std::size_t(face * side + int(j)) * std::size_t(side) + std::size_t(i))];
        for (std::size_t c = 0; c < 3; ++c) texel[c] += part * colour[c];
      }
    }
  }
  return map;
}

}  // namespace airlight
