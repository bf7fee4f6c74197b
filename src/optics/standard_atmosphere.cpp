#include "optics/standard_atmosphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace airlight::standard_atmosphere {
namespace {

// Below 86 km the standard states the temperature as linear in geopotential height and lets weight balance pressure.
struct Layer {
  double base;         // geopotential height [m]
  double lapse;        // dT/dH [K/m]
  double temperature;  // at the base [K]
  double pressure;     // at the base, relative to sea level
};

constexpr double planet_radius = 6'356'766;  // the standard's, where gravity is 9.80665 m/s^2 [m]
constexpr double gravity_constant = 9.80665 * 0.0289644 / 8.31432;  // g0 M / R* [K/m], with the standard's own R*
constexpr double table_bottom = 86'000;  // geometric altitude where the published table takes over [m]

double geopotential(double altitude) { return planet_radius * altitude / (planet_radius + altitude); }
double geometric(double height) { return planet_radius * height / (planet_radius - height); }

double pressure_in(const Layer& layer, double height) {
  const double rise = height - layer.base;
  const double exponent =
      layer.lapse == 0 ? rise / layer.temperature : std::log1p(layer.lapse * rise / layer.temperature) / layer.lapse;
  return layer.pressure * std::exp(-gravity_constant * exponent);
}

std::array<Layer, 7> make_layers() {
  // Table 4 of the standard.
  std::array<Layer, 7> layers{{{0, -0.0065, 288.15, 1},
                               {11'000, 0, 0, 0},
                               {20'000, 0.0010, 0, 0},
                               {32'000, 0.0028, 0, 0},
                               {47'000, 0, 0, 0},
                               {51'000, -0.0028, 0, 0},
                               {71'000, -0.0020, 0, 0}}};
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const Layer& below = layers[i - 1];
    layers[i].temperature = below.temperature + below.lapse * (layers[i].base - below.base);
    layers[i].pressure = pressure_in(below, layers[i].base);
  }
  return layers;
}

const std::array<Layer, 7>& layers() {
  static const std::array<Layer, 7> made = make_layers();
  return made;
}

// Relative number density from p = n k T. From 80 to 86 km molecules begin to be split and their mean weight falls by
// 0.04 %; that is left out, as the table does not resolve it.
double hydrostatic_density(double altitude) {
  const double height = geopotential(altitude);
  const auto above = std::upper_bound(layers().begin(), layers().end(), height,
                                      [](double h, const Layer& layer) { return h < layer.base; });
  const Layer& layer = above == layers().begin() ? *above : *std::prev(above);
  const double temperature = layer.temperature + layer.lapse * (height - layer.base);
  return pressure_in(layer, height) * layers()[0].temperature / temperature;
}

// Above, where gases separate, the published number densities [1/m^3] every 2 km from 86 km, logarithmic between (the
// odd kilometres of the same table agree to 0.5 %).
constexpr double sea_level_density = 2.5470e25;
constexpr double table_step = 2000;
constexpr std::array<double, 18> table{1.447e20, 1.014e20, 7.116e19, 4.993e19, 3.494e19, 2.440e19,
                                       1.702e19, 1.189e19, 8.402e18, 5.956e18, 4.237e18, 3.023e18,
                                       2.144e18, 1.524e18, 1.118e18, 8.430e17, 6.498e17, 5.107e17};

double table_logarithm(std::size_t i) {
  // The lowest value is the hydrostatic one, which rounds to the published one: no step at 86 km.
  static const double bottom = std::log(hydrostatic_density(table_bottom));
  return i == 0 ? bottom : std::log(table[i] / sea_level_density);
}

double table_density(double altitude) {
  const double place = std::clamp((altitude - table_bottom) / table_step, 0.0, double(table.size() - 1));
  const std::size_t i = std::min(std::size_t(place), table.size() - 2);
  return std::exp(std::lerp(table_logarithm(i), table_logarithm(i + 1), place - double(i)));
}

}  // namespace

double density(double altitude) {
  return altitude < table_bottom ? hydrostatic_density(altitude) : table_density(altitude);
}

double mean_density(double from, double to) {
  // Eight Gauss-Legendre points integrate an exponential over one scale height to 1e-16; scale heights are 5 to 9 km.
  constexpr std::array<std::pair<double, double>, 4> nodes{{{0.1834346424956498, 0.3626837833783620},
                                                            {0.5255324099163290, 0.3137066458778873},
                                                            {0.7966664774136267, 0.2223810344533745},
                                                            {0.9602898564975363, 0.1012285362903763}}};
  const int parts = int(std::ceil((to - from) / 5000)) + (to <= from);
  double sum = 0;
  for (int part = 0; part < parts; ++part) {
    const double middle = from + (to - from) * (part + 0.5) / parts, half = (to - from) / parts / 2;
    for (const auto& [x, weight] : nodes) sum += weight / 2 * (density(middle - half * x) + density(middle + half * x));
  }
  return sum / parts;
}

const std::vector<double>& edges() {
  static const std::vector<double> made = [] {
    std::vector<double> altitudes;
    for (std::size_t i = 1; i < layers().size(); ++i) altitudes.push_back(geometric(layers()[i].base));
    for (std::size_t i = 0; i + 1 < table.size(); ++i) altitudes.push_back(table_bottom + table_step * double(i));
    return altitudes;
  }();
  return made;
}

}  // namespace airlight::standard_atmosphere
