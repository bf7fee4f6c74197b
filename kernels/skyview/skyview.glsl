#pragma once
#include "core/aerial.glsl"
#include "core/radiance.glsl"
// Real time: light scattered more than once from a small table, the sky as one observer sees it from another.
// After Hillaire 2020 (doi:10.1111/cgf.14050). Ours differs: altitudes instead of radii; optical depth and -ln of light in the
// tables; the first scattering keeps its phase functions inside the multiple-scattering table; the ground takes part in the
// series; the sky-view table is half a dome (the other half mirrors it) and holds each peaked phase class without its phase
// function, which is applied at the pixel: a halo stays as sharp as it is.

// Rows of the two tables below are directions and columns are Suns, so that the rays of one batch cross the same zones.

/// Light that reaches a place of the multiple-scattering table from one direction (64 rows a place) scattered or reflected once, per
/// solar irradiance [1/sr], times the direction's part of the sphere, of which the mean is 1.
FN Vec4 skyview_multiple_directions_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Vec2 uv) {
  Scalar places = size.height * (1.0 / 64.0);
  Float row = floor(uv.y * size.height);
  Float place = floor((row + 0.5) * (1.0 / 64.0));
  Float index = row - 64.0 * place;
  Float mu_s = Float(0.0);
  Float altitude = multiple_place(air, Vec2(uv.x, (place + 0.5) * (1.0 / places)), size.width, places, mu_s);
  Vec3 sun = Vec3(sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0)), Float(0.0), mu_s);
  Float ring = floor((index + 0.5) * 0.125);
  // Rings are closer to each other at the horizontal, where air is brightest.
  Float side = (ring + 0.5) * 0.25 - 1.0;
  Float z = side * abs(side);
  Float across = sqrt(max((1.0 - z) * (1.0 + z), 0.0));
  Float azimuth = (index - 8.0 * ring + 0.5) * 0.392699081698724;  // half a turn: the other half mirrors it
  Vec3 view = Vec3(across * cos(azimuth), across * sin(azimuth), z);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return (ray_light(air, 1, zones, profile, phases, sunlight, sunlight, sunlight, altitude, view, sun, Float(1.0e30), transmittance, ground) + ground) * (2.0 * abs(side));
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

/// Skylight on the ground from one direction (v), times its weight, for one zenith cosine of the Sun (u), per solar irradiance [1/sr].
FN Vec4 skyview_ground_directions_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Vec2 uv) {
  Float u = 2.0 * from_half_texel(uv.x, size.width) - 1.0;
  Float mu_s = u * abs(u);
  Vec3 sun = Vec3(sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0)), Float(0.0), mu_s);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  Float weight = Float(0.0);
  Vec3 view = hemisphere_direction(floor(uv.y * 256.0), mu_s, weight);
  return ray_light(air, 2, zones, profile, phases, sunlight, multiple, sunlight, Float(0.0), view, sun, Float(1.0e30), transmittance, ground) * weight;
}

/// -ln of the skylight on the ground, per solar irradiance [1]: one row over the Sun's zenith cosine.
FN Vec4 skyview_ground_light_pass(IN(GridSize) size, Table2 ground_directions, Vec2 uv) {
  return -ln4(max(sum_of_column(ground_directions, floor(uv.x * size.width), Float(0.0), 256) * (6.28318530717959 / 256.0), 1.0e-30));
}

// ---- the sky of one observer ----

/// The sky and the ground seen by one observer, per solar irradiance [1/sr]: light of the smooth phase class, light scattered more
/// than once and the ground; then classes 1 to 3 without their phase functions.
FN Vec4 skyview_sky_view_pass(IN(Air) air, IN(Observer) observer, IN(Dome) dome, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Table2 ground_light, Vec2 uv, OUT(Vec4) sky_class1, OUT(Vec4) sky_class2, OUT(Vec4) sky_class3) {
  Float altitude = Float(observer.altitude);
  Vec3 view = dome_view(dome.horizon, uv, dome.width, dome.height);
  Vec3 sun = Vec3(Float(sqrt(max(1.0 - observer.sun.z * observer.sun.z, 0.0))), Float(0.0), Float(observer.sun.z));
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, sun, Float(1.0e30), reach, whole, hits);
  Vec4 class0 = Vec4(0.0);
  Vec4 diffuse = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  gather_light(air, 2, zones, profile, sunlight, multiple, at, reach, class0, sky_class1, sky_class2, sky_class3, diffuse, depth);
  Vec4 ground = ground_radiance(air, sunlight, ground_light, 2, at, reach);
  Vec4 smooth_part = class0 * lookup_row(phases, sqrt(max(0.5 * one_minus_cos(view, sun), 0.0)), 0);
  return diffuse + smooth_part + select(hits, ground * exp(-depth), Vec4(0.0));
}

/// The sky and the ground in a direction, from the sky-view table, per solar irradiance [1/sr].
FN Vec4 skyview_seen(IN(Air) air, IN(Dome) dome, Table2 phases, Table2 sky_view, Table2 sky_class1, Table2 sky_class2, Table2 sky_class3, Vec3 view, Vec3 sun) {
  Vec2 at = dome_uv(dome.horizon, view, sun, dome.width, dome.height);
  Vec4 light = lookup(sky_view, at);
  Float x = sqrt(max(0.5 * one_minus_cos(view, sun), 0.0));
  if (air.classes > 1.5) light = light + lookup(sky_class1, at) * lookup_row(phases, x, 1);
  if (air.classes > 2.5) light = light + lookup(sky_class2, at) * lookup_row(phases, x, 2);
  if (air.classes > 3.5) light = light + lookup(sky_class3, at) * lookup_row(phases, x, 3);
  return light;
}

// ---- aerial perspective of one observer ----

/// Means along paths [1/m]: light scattered more than once, per solar irradiance [1/(m sr)]; optical depth; light of the first order
/// of phase classes 0 and 1 without their phase functions.
FN Vec4 skyview_aerial_pass(IN(Air) air, IN(Observer) observer, IN(Dome) froxels, Table2 zones, Table2 profile, Table2 sunlight, Table2 multiple, Vec3 uvw, OUT(Vec4) aerial_depth, OUT(Vec4) aerial_class0, OUT(Vec4) aerial_class1) {
  Float reach = Float(0.0);
  Vec4 at = aerial_ray(air, observer, froxels, uvw, reach);
  Vec4 diffuse = Vec4(0.0);
  Vec4 class2 = Vec4(0.0);
  Vec4 class3 = Vec4(0.0);
  gather_light(air, 2, zones, profile, sunlight, multiple, at, reach, aerial_class0, aerial_class1, class2, class3, diffuse, aerial_depth);
  Float mean = 1.0 / max(reach, 1.0e-3);
  aerial_depth = aerial_depth * mean;
  aerial_class0 = aerial_class0 * mean;
  aerial_class1 = aerial_class1 * mean;
  return diffuse * mean;
}
/// The same for phase classes 2 and 3 [1/m]; a pass has four outputs at most, and few airs have so many classes.
FN Vec4 skyview_aerial_class2_pass(IN(Air) air, IN(Observer) observer, IN(Dome) froxels, Table2 zones, Table2 profile, Table2 sunlight, Vec3 uvw, OUT(Vec4) aerial_class3) {
  Vec4 class2 = Vec4(0.0);
  aerial_class3 = Vec4(0.0);
  if (air.classes > 2.5) {
    Float reach = Float(0.0);
    Vec4 at = aerial_ray(air, observer, froxels, uvw, reach);
    Vec4 class0 = Vec4(0.0);
    Vec4 class1 = Vec4(0.0);
    Vec4 diffuse = Vec4(0.0);
    Vec4 depth = Vec4(0.0);
    gather_light(air, 1, zones, profile, sunlight, sunlight, at, reach, class0, class1, class2, aerial_class3, diffuse, depth);
    Float mean = 1.0 / max(reach, 1.0e-3);
    class2 = class2 * mean;
    aerial_class3 = aerial_class3 * mean;
  }
  return class2;
}

/// The air before each of a picture's points [W m^-2 sr^-1 nm^-1], with the shadows of land; its transmittance. A point is a texel of
/// `points` (view, and distance [m]; 1e15: the sky, with all behind it) and of `offsets` (x: see shadowed_light).
FN Vec4 skyview_haze_pass(IN(Air) air, IN(Observer) observer, IN(Dome) dome, IN(Dome) froxels, IN(Shadow) shadow, Table2 phases, Table2 sky_view, Table2 sky_class1, Table2 sky_class2, Table2 sky_class3, Table3 aerial, Table3 aerial_depth, Table3 aerial_class0, Table3 aerial_class1, Table3 aerial_class2, Table3 aerial_class3, Table2 shadow_map, Table2 points, Table2 offsets, Vec2 uv, OUT(Vec4) transmittance) {
  Vec4 point = fetch_same(points, uv);
  Vec3 view = xyz(point);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, Float(observer.altitude), view, sun, point.w, reach, whole, hits);
  Vec2 direction = dome_uv(froxels.horizon, view, sun, froxels.width, froxels.height);
  Vec4 shadowed = Vec4(0.0);
  Vec4 first = shadowed_light(air, froxels, shadow, observer, aerial_class0, aerial_class1, aerial_class2, aerial_class3, phases, shadow_map, view, fetch_same(offsets, uv).x, at, direction, reach, whole, shadowed);
  Vec3 place = Vec3(direction.x, direction.y, aerial_w(reach, whole, froxels.depth));
  Vec4 diffuse = lookup(aerial, place) * reach;
  transmittance = exp(-lookup(aerial_depth, place) * reach);
  Vec4 light = diffuse + shadowed;
  Bool sky = point.w > 9.9e14;
  if (any(sky)) {
    // The sky's own table has more directions; the shadows take the same part of it.
    Vec4 open = skyview_seen(air, dome, phases, sky_view, sky_class1, sky_class2, sky_class3, view, sun);
    light = select(sky, open * light / max(diffuse + first, 1.0e-30), light);
  }
  return light * Vec4(air.solar_irradiance);
}

/// A picture from the sky-view table, linear sRGB [cd/m^2].
FN Vec4 skyview_picture_pass(IN(Air) air, IN(Camera) camera, IN(Observer) observer, IN(Display) display, IN(Dome) dome, Table2 phases, Table2 optical_depth, Table2 sky_view, Table2 sky_class1, Table2 sky_class2, Table2 sky_class3, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec4 light = skyview_seen(air, dome, phases, sky_view, sky_class1, sky_class2, sky_class3, view, sun);
  if (display.disc > 0.5) light = light + disc_radiance(air, observer, display, optical_depth, view, one_minus_cos(view, sun));
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

/// Skylight from one direction of the hemisphere (u) for one observer (v), times its weight, per solar irradiance [1/sr].
FN Vec4 skyview_sky_light_pass(IN(Air) air, Table2 zones, Table2 profile, Table2 phases, Table2 sunlight, Table2 multiple, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 eye = fetch(eyes, Float(0.0), floor(uv.y * height_of(eyes)));
  Vec4 at = fetch(suns, Float(0.0), floor(uv.y * height_of(suns)));
  Float weight = Float(0.0);
  Vec3 view = hemisphere_direction(floor(uv.x * 256.0), at.w, weight);
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return ray_light(air, 2, zones, profile, phases, sunlight, multiple, sunlight, eye.x, view, sun_ahead(Vec3(at.y, at.z, at.w)), Float(1.0e30), transmittance, ground) * weight;
}
