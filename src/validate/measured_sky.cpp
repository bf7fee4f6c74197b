#include "validate/measured_sky.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "airlight/error.h"
#include "optics/coefficients.h"

namespace airlight::validation {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

MeasuredSky read_measured_sky(const std::string& path) try {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read");
  const auto json = nlohmann::json::parse(file);
  MeasuredSky sky;
  const auto wrong = json.at("suspect_direction_indices").get<std::vector<std::size_t>>();
  sky.wavelengths = json.at("wavelengths_nm").get<std::vector<double>>();
  const auto& directions = json.at("directions");
  for (const auto& set : json.at("sets")) {
    MeasuredSky::Scan scan{set.at("local_time_EDT"), 90 - set.at("sun_zenith_deg").get<double>(), {}, {}};
    const Direction sun =
        direction(set.at("sun_azimuth_from_symmetry_deg").get<double>() * degree, scan.sun_elevation * degree);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (std::ranges::find(wrong, i) != wrong.end()) continue;
      const double zenith = directions[i].at("view_zenith_deg"), azimuth = directions[i].at("view_azimuth_deg");
      scan.rays.push_back({.altitude = 0, .view = direction(azimuth * degree, (90 - zenith) * degree), .sun = sun});
      const auto row = set.at("radiance").at(i).get<std::vector<double>>();
      if (row.size() != sky.wavelengths.size()) throw InputError(path + ": a row of radiance of the wrong length");
      scan.values.insert(scan.values.end(), row.begin(), row.end());
    }
    sky.scans.push_back(std::move(scan));
  }
  return sky;
} catch (const nlohmann::json::exception& error) {
  throw InputError(path + ": " + error.what());
}

MeasuredSky at_every(const MeasuredSky& sky, std::size_t stride) {
  MeasuredSky part = sky;
  part.wavelengths.clear();
  for (std::size_t w = 0; w < sky.wavelengths.size(); w += stride) part.wavelengths.push_back(sky.wavelengths[w]);
  for (MeasuredSky::Scan& scan : part.scans) {
    const std::vector<double> all = std::move(scan.values);
    scan.values.clear();
    for (std::size_t row = 0; row < all.size(); row += sky.wavelengths.size())
      for (std::size_t w = 0; w < sky.wavelengths.size(); w += stride) scan.values.push_back(all[row + w]);
  }
  return part;
}

Atmosphere air_of_measured_sky(const MeasuredSky& sky, const StandardSpectrum& standard) {
  Atmosphere air = built_in_atmosphere("earth");
  air.name = "earth, 27 May 2013 at Ithaca";
  // The sun's lines change its light by a tenth from one box to the next: those of data/solar_irradiance.csv begin where these have
  // their middles, and between two of them the lines would be washed out.
  TableSpectrum sunlight{sky.wavelengths, {}, Sampling::point, ""};
  for (const double centre : sky.wavelengths) sunlight.values.push_back(standard.above_in_box(centre - 5, centre + 5));
  air.sun.irradiance = Spectrum(sunlight);
  air.planet.albedo = Spectrum(shipped_spectrum("grass_albedo.csv", Sampling::bins).value());
  for (Constituent& constituent : air.constituents) {
    if (constituent.name != "aerosol") continue;
    constituent.profile = ExponentialProfile{1200};
    const double extinction = 0.04 / path_length(constituent.profile, air.planet.top_altitude);
    const auto [scattering, absorption] = split_extinction(Spectrum(PowerSpectrum{1000, extinction, -0.8}), 0.8);
    constituent.scattering = scattering;
    constituent.absorption = absorption;
    constituent.phase = CornetteShanksPhase{0.7};
  }
  return air;
}

MeasuredSkyError compare_with_measured_sky(const MeasuredSky& sky, const Radiance& radiance) {
  MeasuredSkyError error{};
  double difference = 0, signed_difference = 0, square = 0, sum = 0;
  for (const MeasuredSky::Scan& scan : sky.scans) {
    const std::vector<double> values = radiance(scan.rays, sky.wavelengths);
    double own = 0, own_square = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      own += std::pow(values[i] - scan.values[i], 2);
      own_square += std::pow(scan.values[i], 2);
      signed_difference += values[i] - scan.values[i];
      sum += scan.values[i];
    }
    error.scans.push_back(std::sqrt(own / own_square));
    difference += own;
    square += own_square;
  }
  error.all = std::sqrt(difference / square);
  error.bias = signed_difference / sum;
  return error;
}

}  // namespace airlight::validation
