#include "render/ground_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "airlight/model_info.h"

namespace airlight {

void ground_light(const Sky& sky, std::span<const SurfacePoint> points, double sun_zenith_cosine,
                  std::span<const double> wavelengths, std::span<const double> albedo, std::span<double> radiance,
                  std::span<double> skylight) {
  // Sky::surface knows the sky's light for Suns within 3 degrees of one. Bands of 6 degrees meet at Suns that both of them know, so no
  // edge shows.
  constexpr double width = 6 * std::numbers::pi / 180, most = std::numbers::pi / 2;
  const double middle = std::asin(sun_zenith_cosine);
  const auto sine = [&](double bands) { return std::sin(std::clamp(middle + bands * width, -most, most)); };
  const auto [low, high] = std::ranges::minmax(points, {}, &SurfacePoint::sun_zenith_cosine);
  // A published system of colours lights all ground alike.
  if (model_info(sky.model()).colours || (low.sun_zenith_cosine >= sine(-0.5) && high.sun_zenith_cosine <= sine(0.5))) {
    sky.surface(points, sun_zenith_cosine, wavelengths, albedo, radiance, skylight);
    return;
  }
  const auto nth = [&](const SurfacePoint& p) {
    return int(std::floor((std::asin(p.sun_zenith_cosine) - middle) / width + 0.5));
  };
  std::map<int, std::vector<std::size_t>> bands;
  for (std::size_t i = 0; i < points.size(); ++i) bands[nth(points[i])].push_back(i);
  const std::size_t W = wavelengths.size();
  for (const auto& [band, which] : bands) {
    std::vector<SurfacePoint> some;
    std::vector<double> own(W * which.size()), light(own.size()), from_sky(own.size());
    for (std::size_t j = 0; j < which.size(); ++j) {
      some.push_back(points[which[j]]);
      std::copy_n(&albedo[W * which[j]], W, &own[W * j]);
    }
    sky.surface(some, band == 0 ? sun_zenith_cosine : sine(band), wavelengths, own, light, from_sky);
    for (std::size_t j = 0; j < which.size(); ++j) {
      std::copy_n(&light[W * j], W, &radiance[W * which[j]]);
      std::copy_n(&from_sky[W * j], W, &skylight[W * which[j]]);
    }
  }
}

}  // namespace airlight
