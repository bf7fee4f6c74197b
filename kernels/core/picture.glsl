#pragma once
#include "core/camera.glsl"
#include "core/disc.glsl"
#include "core/march.glsl"
// What every picture of a sky needs: who looks, in which light, and how four wavelengths become a colour.

struct Observer {
  Scalar4 sun;           // [1] in -0.577..0.577  unit vector towards the Sun, z up at the observer
  Scalar altitude;       // [m] in 0..1e5
  Scalar pad0;           // [1] in 0..1
  Scalar pad1;           // [1] in 0..1
  Scalar pad2;           // [1] in 0..1
};

struct Display {
  Scalar4 disc_gain;     // [1/sr] in 0..1e5  makes the disc's pixels add up to the solar irradiance
  Scalar4 red;           // [cd m^-2 / (W m^-2 sr^-1 nm^-1)] in -1e5..1e5  linear sRGB from the four spectral radiances
  Scalar4 green;         // [cd m^-2 / (W m^-2 sr^-1 nm^-1)] in -1e5..1e5
  Scalar4 blue;          // [cd m^-2 / (W m^-2 sr^-1 nm^-1)] in -1e5..1e5
  Scalar disc;           // [1] in 0..1  1: draw the Sun's disc
  Scalar disc_radius;    // [rad] in 1e-3..1e-1  at least about a pixel
  Scalar disc_edge;      // [rad] in 1e-4..1e-2  width of its soft edge: a pixel
  Scalar pad;            // [1] in 0..1
};

/// Radiance of the Sun's disc at a pixel, seen through the air, per solar irradiance [1/sr].
FN Vec4 disc_radiance(IN(Air) air, IN(Observer) observer, IN(Display) display, Table2 optical_depth, Vec3 view, Float one_minus_cos) {
  Vec4 light = Vec4(0.0);
  Float reach = Float(display.disc_radius + display.disc_edge);
  if (any(2.0 * one_minus_cos < reach * reach)) {
    // A pixel larger than the disc reaches beyond it; the light still comes from the disc.
    Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
    Vec3 from = sun + (view - sun) * min(air.sun_radius / sqrt(max(2.0 * one_minus_cos, 1.0e-12)), 1.0);
    Float start = Float(0.0);
    Float mu = Float(0.0);
    Float skipped = enter_atmosphere(air.ground_radius, air.top_altitude, Float(observer.altitude), from, start, mu);
    Vec4 depth = lookup(optical_depth, depth_uv(air, start, mu, width_of(optical_depth), height_of(optical_depth)));
    Vec4 through = select(skipped < 0.0, Vec4(1.0), exp(-depth));
    Bool hidden = (skipped >= 0.0) && (mu < mu_horizon(air.ground_radius, start));
    Bool seen = (2.0 * one_minus_cos < reach * reach) && !hidden;
    light = select(seen, disc_shape(air.limb_darkening, display.disc_radius, display.disc_edge, one_minus_cos) * through * Vec4(display.disc_gain), Vec4(0.0));
  }
  return light;
}

/// Linear sRGB [cd/m^2], alpha 1, of four spectral radiances [W m^-2 sr^-1 nm^-1].
/// @param radiance [W m^-2 sr^-1 nm^-1] in 0..1
/// @bound 2e-5 scale 1e5   a difference of large weights
FN Vec4 display_colour(IN(Display) display, Vec4 radiance) {
  return Vec4(dot(radiance, Vec4(display.red)), dot(radiance, Vec4(display.green)), dot(radiance, Vec4(display.blue)), Float(1.0));
}
