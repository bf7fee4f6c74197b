#pragma once
#include "core/radiance.glsl"
// Light on the ground and on whatever else is solid: the Sun's, where land leaves it visible, and the sky's, which is brighter
// towards the Sun and near the horizon. Skylight is summed for planes of every tilt beforehand (spherical harmonics of order 2 would
// miss a fifth of what a wall gets from the aureole). Axes: x horizontal towards the Sun, z up.

struct SurfaceGrid {
  Scalar azimuths;   // [1] in 2..32  of a plane's normal from the Sun: 0 to pi, the other side mirrors it
  Scalar tilts;      // [1] in 2..32  z of the normal, -1 to 1
  Scalar altitudes;  // [1] in 2..16  dense near the ground
  Scalar suns;       // [1] in 2..16  zenith cosines of the Sun
  Scalar highest;    // [m] in 1e3..1e5  the last altitude
  Scalar low_sun;    // [1] in -1..0  the first zenith cosine
  Scalar high_sun;   // [1] in 0.01..1  the last
  Scalar pad;        // [1] in 0..1
};

/// Skylight on planes over the azimuth of their normal (u), its z (v, a band for each altitude) and the Sun's zenith cosine (w), per solar
/// irradiance [1]: from a model's `sky_light`, whose rows are altitudes, then Suns.
FN Vec4 skylight_pass(IN(SurfaceGrid) grid, Table2 sky_light, Vec3 uvw) {
  Float azimuth = from_half_texel(uvw.x, grid.azimuths) * 3.14159265358979;
  Float row = floor(uvw.y * grid.tilts * grid.altitudes);
  Float band = floor((row + 0.5) * (1.0 / grid.tilts));
  Float z = clamp((row - band * grid.tilts) * (2.0 / (grid.tilts - 1.0)) - 1.0, -1.0, 1.0);
  Float across = sqrt((1.0 - z) * (1.0 + z));
  Float x = across * cos(azimuth);
  Float y = across * sin(azimuth);
  Float slice = floor(uvw.z * grid.suns);
  Float from = band + grid.altitudes * slice;
  Float mu_s = grid.low_sun + (grid.high_sun - grid.low_sun) * slice * (1.0 / (grid.suns - 1.0));
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < 256; ++i) {
    Float kept = Float(0.0);
    Vec3 d = hemisphere_direction(Float(i), mu_s, kept);
    // The direction and its mirror image; the light has been multiplied by z and its part of the ring.
    Float level = x * d.x + z * d.z;
    Float weight = max(level + y * d.y, 0.0) + max(level - y * d.y, 0.0);
    sum = sum + fetch(sky_light, Float(i), from) * (weight * 0.5 / d.z);
  }
  return sum * (6.28318530717959 / 256.0);
}

/// Skylight on a plane, per solar irradiance [1].
FN Vec4 skylight_on(IN(SurfaceGrid) grid, Table3 skylight, Float altitude, Float mu_s, Vec3 normal) {
  Float u = half_texel(abs(arc_tangent2(normal.y, normal.x)) * 0.318309886183791, grid.azimuths);
  Float w = half_texel(clamp((mu_s - grid.low_sun) * (1.0 / (grid.high_sun - grid.low_sun)), 0.0, 1.0), grid.suns);
  Float tilt = half_texel(clamp(0.5 + 0.5 * normal.z, 0.0, 1.0), grid.tilts);
  Float height = sqrt(clamp(altitude * (1.0 / grid.highest), 0.0, 1.0)) * (grid.altitudes - 1.0);
  Float band = min(floor(height), grid.altitudes - 2.0);
  Vec4 below = lookup(skylight, Vec3(u, (band + tilt) * (1.0 / grid.altitudes), w));
  Vec4 above = lookup(skylight, Vec3(u, (band + 1.0 + tilt) * (1.0 / grid.altitudes), w));
  return below + (above - below) * (height - band);
}

/// Light that leaves a surface towards any eye [W m^-2 sr^-1 nm^-1]; skylight that reaches it, and sunlight [W m^-2 nm^-1].
/// `places`: altitude [m], the Sun's zenith cosine, visible part of the Sun, visible part of the sky (as the plane is tilted);
/// `normals`: x towards the Sun, z up, w: cosine to the Sun; `albedos`: at four wavelengths.
/// What hides the sky is lit ground of the planet's albedo.
FN Vec4 surface_pass(IN(Air) air, IN(SurfaceGrid) grid, Table2 sunlight, Table3 skylight, Table2 places, Table2 normals, Table2 albedos, Vec2 uv, OUT(Vec4) from_sky, OUT(Vec4) from_sun) {
  Vec4 place = fetch_same(places, uv);
  Vec4 normal = fetch_same(normals, uv);
  Vec4 sun = sunlight_at(air, sunlight, max(place.x, 0.0), place.y);
  from_sun = sun * (max(normal.w, 0.0) * place.z) * Vec4(air.solar_irradiance);
  Vec4 level = skylight_on(grid, skylight, place.x, place.y, Vec3(Float(0.0), Float(0.0), Float(1.0)));
  // The table knows the tilt; the visible part knows it too, and what stands around.
  Float unhidden = min(place.w / max(0.5 + 0.5 * normal.z, 1.0e-3), 1.0);
  Vec4 around = (level + sun * max(place.y, 0.0)) * Vec4(air.albedo) * (1.0 - place.w);
  from_sky = (skylight_on(grid, skylight, place.x, place.y, xyz(normal)) * unhidden + around) * Vec4(air.solar_irradiance);
  return fetch_same(albedos, uv) * (from_sun + from_sky) * 0.318309886183791;
}
