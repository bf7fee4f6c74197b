#include "reference/optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight::reference {

Optics::Optics(const Atmosphere& atmosphere, std::span<const double> nanometres, bool point_sun, const Cloud* cloud)
    : constituents(atmosphere.constituents.size()),
      wavelengths(nanometres.size()),
      scatterers(constituents + (cloud ? 1 : 0)),
      sun_radius_(point_sun ? 0 : atmosphere.sun.angular_radius) {
  std::vector<double> vertical(wavelengths, 0.0);
  for (const Constituent& constituent : atmosphere.constituents) {
    const double column =
        atmosphere.planet.top_altitude * mean_density(constituent.profile, 0, atmosphere.planet.top_altitude);
    for (std::size_t w = 0; w < wavelengths; ++w) {
      scattering.push_back(constituent.scattering.at(nanometres[w]));
      extinction.push_back(scattering.back() + constituent.absorption.at(nanometres[w]));
      vertical[w] += extinction.back() * column;
    }
    phases.push_back(constituent.phase);
    samplers.emplace_back(constituent.phase);
  }
  if (cloud) {
    for (const double wavelength : nanometres) scattering.push_back(cloud->single_scattering_albedo.at(wavelength));
    phases.push_back(cloud->phase);
    samplers.emplace_back(cloud->phase);
  }
  for (const double wavelength : nanometres) {
    albedo.push_back(atmosphere.planet.albedo.at(wavelength));
    limb_darkening_.push_back(atmosphere.sun.limb_darkening.at(wavelength));
  }
  drawn_exponent_ = limb_darkening_.front();

  clearest_ = std::min_element(vertical.begin(), vertical.end()) - vertical.begin();
  thickest_ = std::max_element(vertical.begin(), vertical.end()) - vertical.begin();
  heroes = wavelengths == 1 ? 1 : most_heroes;
  hero_extinction.resize(constituents * heroes);
  hero_scattering.resize(scatterers * heroes);
  hero_albedo.resize(heroes);
  for (std::size_t c = 0; c < constituents; ++c)
    hero_values(std::span(extinction).subspan(c * wavelengths, wavelengths),
                std::span(hero_extinction).subspan(c * heroes, heroes));
  for (std::size_t c = 0; c < scatterers; ++c)
    hero_values(std::span(scattering).subspan(c * wavelengths, wavelengths),
                std::span(hero_scattering).subspan(c * heroes, heroes));
  hero_values(albedo, hero_albedo);
}

void Optics::hero_values(std::span<const double> by_wavelength, std::span<double> by_hero) const {
  by_hero[0] = 0;
  for (const double value : by_wavelength) by_hero[0] += value / double(wavelengths);
  if (heroes == 1) return;
  by_hero[1] = by_wavelength[clearest_];
  by_hero[2] = by_wavelength[thickest_];
}

// Radiance over the disc is proportional to (1 - rho^2)^(a/2), rho in units of the disc's radius, and rho drho is
// irradiance normal to the beam.
Optics::SunElement Optics::sun_element(const Vector& sun, Random& random, std::span<double> light) const {
  std::fill(light.begin(), light.end(), 1.0);
  if (sun_radius_ == 0) return {sun, 1};
  const double drawn = 1 + 0.5 * drawn_exponent_;
  const double rest = std::pow(1 - random(), 1 / drawn);  // 1 - rho^2
  for (std::size_t w = 0; w < light.size(); ++w)
    if (limb_darkening_[w] != drawn_exponent_)
      light[w] = (1 + 0.5 * limb_darkening_[w]) / drawn * std::pow(rest, 0.5 * (limb_darkening_[w] - drawn_exponent_));
  const double sine = std::sin(sun_radius_) * std::sqrt(1 - rest), cosine = std::sqrt((1 - sine) * (1 + sine));
  return {around(sun, sine, cosine, 2 * std::numbers::pi * random()), cosine};
}

}  // namespace airlight::reference
