// Many questions in one call: they cost a fraction of as many calls, since rays share tables and run side by side.
#include <airlight/sky.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  constexpr double degree = 0.017453292519943295, altitude = 1200;
  const airlight::Sky sky(airlight::built_in_atmosphere("earth-hazy"), "skyview");
  const airlight::Direction sun = airlight::direction(120 * degree, 20 * degree);  // azimuth, elevation

  // The sky from the horizon in the south up to the zenith: N rays, W wavelengths, N x W answers with the ray slowest.
  std::vector<airlight::Ray> rays;
  for (int elevation = 0; elevation <= 90; elevation += 15)
    rays.push_back({.altitude = altitude, .view = airlight::direction(180 * degree, elevation * degree), .sun = sun});
  const std::vector<double> wavelengths{450, 550, 650};
  std::vector<double> radiance(rays.size() * wavelengths.size());
  sky.evaluate(airlight::Quantity::radiance, rays, wavelengths, radiance);
  for (std::size_t i = 0; i < rays.size(); ++i)
    std::printf("sky %2zu degrees up: %.4f %.4f %.4f W m^-2 sr^-1 nm^-1\n", 15 * i, radiance[3 * i],
                radiance[3 * i + 1], radiance[3 * i + 2]);

  // Haze before what one camera shows: L = L0 * transmittance + inscatter for every pixel, from tables of this observer and Sun.
  std::vector<airlight::Sight> pixels;
  for (const double kilometres : {0.1, 1.0, 10.0, 50.0})
    pixels.push_back({.view = airlight::direction(180 * degree, -0.5 * degree), .distance = 1000 * kilometres});
  std::vector<double> inscatter(pixels.size() * wavelengths.size()), transmittance(inscatter.size());
  sky.haze(altitude, sun, pixels, wavelengths, nullptr, inscatter, transmittance);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    std::printf("haze before %4.1f km at 550 nm: transmittance %.4f, inscatter %.4f W m^-2 sr^-1 nm^-1\n",
                pixels[i].distance / 1000, transmittance[3 * i + 1], inscatter[3 * i + 1]);
}
