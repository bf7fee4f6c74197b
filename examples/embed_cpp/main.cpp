#include <airlight/sky.h>

#include <cmath>
#include <cstdio>

int main() {
  const airlight::Sky sky(airlight::built_in_atmosphere("earth"), "skyview");
  const airlight::Ray zenith{.altitude = 0, .view = {0, 0, 1}, .sun = {0, std::sqrt(0.75), 0.5}};  // sun 30 degrees up
  const double wavelength[] = {550};
  double radiance[1];
  sky.evaluate(airlight::Quantity::radiance, {&zenith, 1}, wavelength, radiance);
  std::printf("zenith radiance at 550 nm: %.4f W m^-2 sr^-1 nm^-1\n", radiance[0]);
}
