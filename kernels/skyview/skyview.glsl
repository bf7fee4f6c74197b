#pragma once
#include "core/radiance.glsl"
// Real time: light scattered more than once from a small table, the sky as one observer sees it from another.
// After Hillaire 2020 (doi:10.1111/cgf.14050). Ours differs: altitudes instead of radii; optical depth and -ln of light in the
// tables; the first scattering keeps its phase functions inside the multiple-scattering table; the ground takes part in the
// series; the sky-view table is half a dome (the other half mirrors it) and holds each peaked phase class without its phase
// function, which is applied at the pixel: a halo stays as sharp as it is.

struct Dome {
  Scalar width;    // [1] in 32..256  of the sky-view table
  Scalar height;   // [1] in 32..256
  Scalar horizon;  // [1] in -0.5..0  mu_horizon at the observer
  Scalar pad;      // [1] in 0..1
};

// Rows of the two tables below are directions and columns are Suns, so that the rays of one batch cross the same zones.

/// Light that reaches a place of the multiple-scattering table from one direction (64 rows a place) scattered or reflected once, per
/// solar irradiance [1/sr].
FN Vec4 skyview_multiple_directions_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Vec2 uv) {
  Scalar places = size.height * (1.0 / 64.0);
  Float row = floor(uv.y * size.height);
  Float place = floor((row + 0.5) * (1.0 / 64.0));
  Float index = row - 64.0 * place;
  Float mu_s = Float(0.0);
  Float altitude = multiple_place(air, Vec2(uv.x, (place + 0.5) * (1.0 / places)), size.width, places, mu_s);
  Vec3 sun = Vec3(sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0)), Float(0.0), mu_s);
  Float ring = floor((index + 0.5) * 0.125);
  Float z = (ring + 0.5) * 0.25 - 1.0;
  Float across = sqrt(max((1.0 - z) * (1.0 + z), 0.0));
  Float azimuth = (index - 8.0 * ring + 0.5) * 0.392699081698724;  // half a turn: the other half mirrors it
  Vec3 view = Vec3(across * cos(azimuth), across * sin(azimuth), z);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return ray_light(air, 1, zones, profile, phases, sunlight, sunlight, sunlight, altitude, view, sun, Float(1.0e30), transmittance, ground) + ground;
}

/// The part of uniform light that arrives at an altitude (u, as v of the multiple-scattering table) from one of eight rings (v)
/// scattered or reflected once more [1].
FN Vec4 skyview_multiple_again_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Vec2 uv) {
  Float mu_s = Float(0.0);
  Float altitude = multiple_place(air, Vec2(uv.y, uv.x), size.height, size.width, mu_s);
  return scattered_again(air, zones, profile, altitude, (floor(uv.y * 8.0) + 0.5) * 0.25 - 1.0);
}

/// -ln of the source of light scattered more than once, per solar irradiance and scattering coefficient [1/sr].
/// Light of the second order is the mean over all directions of what has been scattered or reflected once; each further order
/// is the same fraction of the one before, so that the series has a closed sum (Hillaire 2020, equations 5 to 10).
FN Vec4 skyview_multiple_pass(IN(GridSize) size, Table2 multiple_directions, Table2 multiple_again, Vec2 uv) {
  Float row = floor(uv.y * size.height);
  Vec4 second = sum_of_column(multiple_directions, floor(uv.x * size.width), 64.0 * row, 64) * (1.0 / 64.0);
  Vec4 again = sum_of_column(multiple_again, row, Float(0.0), 8) * (1.0 / 8.0);
  return -ln4(max(second / max(Vec4(1.0) - again, 0.02), 1.0e-30));
}

/// Skylight on the ground from one direction (v) for one zenith cosine of the Sun (u), per solar irradiance [1/sr].
FN Vec4 skyview_ground_directions_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Vec2 uv) {
  Float u = 2.0 * from_half_texel(uv.x, size.width) - 1.0;
  Float mu_s = u * abs(u);
  Vec3 sun = Vec3(sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0)), Float(0.0), mu_s);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return ray_light(air, 2, zones, profile, phases, sunlight, multiple, sunlight, Float(0.0), hemisphere_direction(floor(uv.y * 256.0)), sun, Float(1.0e30), transmittance, ground);
}

/// -ln of the skylight on the ground, per solar irradiance [1]: one row over the Sun's zenith cosine.
FN Vec4 skyview_ground_light_pass(IN(GridSize) size, Table2 ground_directions, Vec2 uv) {
  return -ln4(max(sum_of_column(ground_directions, floor(uv.x * size.width), Float(0.0), 256) * (3.14159265358979 / 256.0), 1.0e-30));
}

// ---- the sky of one observer: u is the sine of half the azimuth from the Sun, v runs from the horizon up, then from it down ----

/// Table coordinates of a view [1].
/// @param horizon [1] in -0.5..0  mu_horizon at the observer
/// @param view [1] in -0.577..0.577
/// @param sun [1] in -0.577..0.577
/// @param width [1] in 32..256
/// @param height [1] in 32..256
/// @bound 1e-3 scale 1   the square root at the horizon: half the digits, a hundredth of a texel
FN Vec2 skyview_uv(Scalar horizon, Vec3 view, Vec3 sun, Scalar width, Scalar height) {
  Float view_across = max(sqrt(view.x * view.x + view.y * view.y), 1.0e-12);
  Float sun_across = max(sqrt(sun.x * sun.x + sun.y * sun.y), 1.0e-12);
  Float x = view.x / view_across - sun.x / sun_across;
  Float y = view.y / view_across - sun.y / sun_across;
  Float u = 0.5 * sqrt(x * x + y * y);
  Float above = view.z - horizon;
  Float up = sqrt(clamp(above * (1.0 / (1.0 - horizon)), 0.0, 1.0));
  Float down = sqrt(clamp(-above * (1.0 / (1.0 + horizon)), 0.0, 1.0));
  Scalar half_height = 0.5 * height;
  Float v = select(above < 0.0, 0.5 + 0.5 * half_texel(down, half_height), 0.5 * half_texel(up, half_height));
  return Vec2(half_texel(clamp(u, 0.0, 1.0), width), v);
}
/// The view of a place in the table, in the frame whose x axis points to the Sun's azimuth [1].
/// @param horizon [1] in -0.5..0
/// @param uv [1] in 0..1
/// @param width [1] in 32..256
/// @param height [1] in 32..256
/// @bound 1e-3 scale 1   towards the zenith and nadir the horizontal part is the root of what float leaves of 1 - mu^2: half the digits
FN Vec3 skyview_view(Scalar horizon, Vec2 uv, Scalar width, Scalar height) {
  Scalar half_height = 0.5 * height;
  Float u = from_half_texel(uv.x, width);
  Bool below = uv.y > 0.5;
  Float c = from_half_texel(select(below, 2.0 * uv.y - 1.0, 2.0 * uv.y), half_height);
  // Never on the horizon itself, where rounding would decide between sky and ground.
  Float mu = select(below, horizon - max(c * c, 1.0e-6) * (1.0 + horizon), horizon + max(c * c, 1.0e-6) * (1.0 - horizon));
  mu = clamp(mu, -1.0, 1.0);
  Float across = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
  return Vec3(across * (1.0 - 2.0 * u * u), across * 2.0 * u * sqrt(max(1.0 - u * u, 0.0)), mu);
}

/// The sky and the ground seen by one observer, per solar irradiance [1/sr]: light of the smooth phase class, light scattered more
/// than once and the ground; then classes 1 to 3 without their phase functions.
FN Vec4 skyview_sky_view_pass(IN(Air) air, IN(Observer) observer, IN(Dome) dome, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Table2 ground_light, Vec2 uv, OUT(Vec4) sky_class1, OUT(Vec4) sky_class2, OUT(Vec4) sky_class3) {
  Float altitude = Float(observer.altitude);
  Vec3 view = skyview_view(dome.horizon, uv, dome.width, dome.height);
  Vec3 sun = Vec3(Float(sqrt(max(1.0 - observer.sun.z * observer.sun.z, 0.0))), Float(0.0), Float(observer.sun.z));
  Float start = Float(0.0);
  Float mu = Float(0.0);
  Float mu_s = Float(0.0);
  Float nu = Float(0.0);
  Float reach = Float(0.0);
  Bool hits = reach > 1.0;
  meet_air(air, altitude, view, sun, Float(1.0e30), start, mu, mu_s, nu, reach, hits);
  Vec4 class0 = Vec4(0.0);
  Vec4 diffuse = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  gather_light(air, 2, zones, profile, sunlight, multiple, start, mu, mu_s, nu, reach, class0, sky_class1, sky_class2, sky_class3, diffuse, depth);
  Vec4 ground = ground_radiance(air, sunlight, ground_light, 2, start, mu_s, nu, reach);
  Vec4 smooth_part = class0 * lookup_row(phases, sqrt(max(0.5 * one_minus_cos(view, sun), 0.0)), 0);
  return diffuse + smooth_part + select(hits, ground * exp(-depth), Vec4(0.0));
}

/// A picture from the sky-view table, linear sRGB [cd/m^2].
FN Vec4 skyview_picture_pass(IN(Air) air, IN(Camera) camera, IN(Observer) observer, IN(Display) display, IN(Dome) dome, Table2 phases, Table2 optical_depth, Table2 sky_view, Table2 sky_class1, Table2 sky_class2, Table2 sky_class3, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Float apart = one_minus_cos(view, sun);
  Vec2 at = skyview_uv(dome.horizon, view, sun, dome.width, dome.height);
  Vec4 light = lookup(sky_view, at);
  Float x = sqrt(max(0.5 * apart, 0.0));
  if (air.classes > 1.5) light = light + lookup(sky_class1, at) * lookup_row(phases, x, 1);
  if (air.classes > 2.5) light = light + lookup(sky_class2, at) * lookup_row(phases, x, 2);
  if (air.classes > 3.5) light = light + lookup(sky_class3, at) * lookup_row(phases, x, 3);
  if (display.disc > 0.5) light = light + disc_radiance(air, observer, display, optical_depth, view, apart);
  return display_colour(display, light * Vec4(air.solar_irradiance)) * inside;
}

/// A picture by marching every pixel's ray: near the top and outside, where a sky-view table does not hold. Linear sRGB [cd/m^2].
FN Vec4 skyview_space_picture_pass(IN(Air) air, IN(Camera) camera, IN(Observer) observer, IN(Display) display, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 optical_depth, Table2 multiple, Table2 ground_light, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  Vec4 light = ray_light(air, 2, zones, profile, phases, sunlight, multiple, ground_light, Float(observer.altitude), view, sun, Float(1.0e30), transmittance, ground);
  light = light + ground;
  if (display.disc > 0.5) light = light + disc_radiance(air, observer, display, optical_depth, view, one_minus_cos(view, sun));
  return display_colour(display, light * Vec4(air.solar_irradiance)) * inside;
}

/// Radiance along rays as single_rays_pass, with light scattered more than once [W m^-2 sr^-1 nm^-1].
FN Vec4 skyview_rays_pass(IN(Air) air, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Table2 ground_light, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 view = Vec3(eye.y, eye.z, eye.w);
  Vec3 sun = Vec3(at.y, at.z, at.w);
  Vec4 light = ray_light(air, 2, zones, profile, phases, sunlight, multiple, ground_light, eye.x, view, sun, at.x, transmittance, ground);
  ground = ground * Vec4(air.solar_irradiance);
  transmittance = ray_transmittance(air, zones, profile, eye.x, view, at.x);
  return light * Vec4(air.solar_irradiance);
}

/// Skylight from one direction of the hemisphere (u) for one observer (v), per solar irradiance [1/sr].
FN Vec4 skyview_sky_light_pass(IN(Air) air, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 eye = fetch(eyes, Float(0.0), floor(uv.y * height_of(eyes)));
  Vec4 at = fetch(suns, Float(0.0), floor(uv.y * height_of(suns)));
  Vec3 view = hemisphere_direction(floor(uv.x * 256.0));
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return ray_light(air, 2, zones, profile, phases, sunlight, multiple, sunlight, eye.x, view, sun_ahead(Vec3(at.y, at.z, at.w)), Float(1.0e30), transmittance, ground);
}
