#pragma once
#include "core/cube.glsl"
#include "core/picture.glsl"
#include "core/tables.glsl"
#include "core/tone.glsl"
#include "realworldz/sky.glsl"
#include "realworldz/terrain.glsl"
// RealWorldz' pictures: sky over stars, terrain, both behind fog. World frame: east, north, up at the viewer, turned into the planet's.
//
// `sky_colours` over a quarter of |sun - view|^2 and exp(-optical depth); `stars` is a cube map: six faces side by side, each with a border
// of one texel, light per solid angle of a star of magnitude 0 being 1.

struct RealworldzView {
  Scalar4 east;       // [1] in -1..1  axes of the viewer's frame in the planet's, to which stars are fixed
  Scalar4 north;      // [1] in -1..1
  Scalar4 up;         // [1] in -1..1
  Scalar star_gain;   // [sr] in 0..1  light of the stars
  Scalar terrain;     // [1] in 0..1  0: a smooth ball
  Scalar steps;       // [1] in 1..512  along a ray over terrain
  Scalar show;        // [1] in 0..1  1: fog alone
};

/// A direction of the viewer's frame in the planet's [1].
/// @param d [1] in -1..1
FN Vec3 realworldz_turned(IN(RealworldzView) view, Vec3 d) {
  return Vec3(d.x * view.east.x + d.y * view.north.x + d.z * view.up.x, d.x * view.east.y + d.y * view.north.y + d.z * view.up.y,
              d.x * view.east.z + d.y * view.north.z + d.z * view.up.z);
}

/// Transmittance of the sky's air on the 65 rings around the viewer.
FN Vec4 realworldz_rings_pass(IN(Realworldz) rw, IN(Observer) observer, Table2 densities, Vec2 uv) {
  return Vec4(realworldz_rings(rw, densities, Float(observer.altitude), floor(uv.x * 65.0)));
}

/// Stars in a direction [1]; w: how dark it is there, 0 for bright stars.
FN Vec4 realworldz_stars(Table2 stars, Scalar gain, Vec3 d) {
  Vec4 light = lookup(stars, cube_uv(d, width_of(stars))) * gain;
  Float bright = tone_luminance(xyz(light));
  return Vec4(light.x, light.y, light.z, 1.0 - min(bright, 1.0));
}

/// The sky in a direction of the viewer's frame, stars included, before fog [1].
FN_SHARED Vec4 realworldz_sky(IN(RealworldzView) view, Table2 sky_colours, Table2 rings, Table2 stars, Vec3 d, Vec3 sun) {
  Vec2 ring = realworldz_ring(1.0 - arc_cosine(d.z) * (2.0 / 3.14159265358979));
  Float air = mix(fetch(rings, ring.x, Float(0.0)).x, fetch(rings, ring.x + 1.0, Float(0.0)).x, ring.y);
  Vec4 colour = lookup(sky_colours, Vec2(realworldz_sky_u(one_minus_cos(d, sun)), air));
  Vec4 behind = realworldz_stars(stars, view.star_gain, realworldz_turned(view, d));
  return realworldz_fragment(colour, behind, Vec4(1.0), Vec4(0.0));
}

/// Light that falls on a white surface: the Sun's, and a little of the sky [1].
/// @param level [1] in -1..1  z of the surface's normal above the local horizontal
/// @param mu_s [1] in -1..1  cosine of the Sun's zenith angle
/// @param direct [1] in 0..1  cosine to the Sun, 0 in shadow
FN Vec4 realworldz_light(IN(Realworldz) rw, Float level, Float mu_s, Float direct) {
  // The Sun sets for the ground as it does for the eye: over 3 degrees about the horizon.
  Float day = smooth_step(-0.05, 0.05, mu_s);
  Float diffuse = 0.25 * (0.5 + 0.5 * level) * smooth_step(-0.2, 0.2, mu_s);
  return Vec4(rw.sun_light) * (direct * day) + Vec4(rw.far_light) * diffuse;
}

/// Light of the ground lit by the Sun and a little by the sky [1].
/// @param p [m] in 3e4..4e4  in the planet's frame, as the normal and the Sun
/// @param normal [1] in -0.577..0.577
/// @param height [m] in 0..3e3
/// @param sun [1] in -0.577..0.577
FN Vec4 realworldz_lit(IN(Realworldz) rw, Vec3 p, Vec3 normal, Float height, Vec3 sun) {
  Vec3 up = realworldz_unit(p);
  Float steep = 1.0 - dot(normal, up);
  Float part = height * (1.0 / max(rw.relief, 1.0));
  Vec4 grass = Vec4(0.16, 0.22, 0.08, 0.0);
  Vec4 rock = Vec4(0.24, 0.21, 0.18, 0.0);
  Vec4 snow = Vec4(0.8, 0.82, 0.85, 0.0);
  Vec4 albedo = mix(mix(grass, snow, smooth_step(0.55, 0.7, part)), rock, smooth_step(0.12, 0.35, steep));
  return albedo * realworldz_light(rw, dot(normal, up), dot(up, sun), max(dot(normal, sun), 0.0));
}

/// The light of land that a picture shows, as core_surface_pass has it.
FN Vec4 realworldz_surface_pass(IN(Realworldz) rw, Table2 places, Table2 normals, Table2 albedos, Vec2 uv, OUT(Vec4) from_sky) {
  Vec4 place = fetch_same(places, uv);
  Vec4 normal = fetch_same(normals, uv);
  from_sky = realworldz_light(rw, normal.z, place.y, Float(0.0));
  return fetch_same(albedos, uv) * realworldz_light(rw, normal.z, place.y, max(normal.w, 0.0) * place.z);
}

/// A picture, linear sRGB [cd/m^2].
FN Vec4 realworldz_picture_pass(IN(Camera) camera, IN(Observer) observer, IN(Display) display, IN(Realworldz) rw, IN(RealworldzView) view, Table2 sky_colours, Table2 rings, Table2 stars, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 d = camera_view(camera, uv, inside);
  Vec3 sun = Vec3(observer.sun.x, observer.sun.y, observer.sun.z);
  Vec3 v = Vec3(Float(0.0), Float(0.0), Float(rw.ground_radius + observer.altitude));
  Vec3 viewer = realworldz_turned(view, v);
  Vec3 direction = realworldz_turned(view, d);
  Float height = Float(0.0);
  Float distance = realworldz_trace(rw, view.terrain, int(view.steps), viewer, direction, height);
  Bool hit = distance >= 0.0;
  Vec4 light = realworldz_sky(view, sky_colours, rings, stars, d, sun);
  Vec3 x = viewer + direction * select(hit, distance, 10.0 * rw.top_radius);
  Vec3 fog = realworldz_fog_anywhere(rw, x, viewer);
  if (any(hit)) {
    Vec3 normal = realworldz_normal(rw, view.terrain, x);
    light = select(hit, realworldz_lit(rw, x, normal, height, realworldz_turned(view, sun)), light);
  }
  light = light * realworldz_extinction(rw, fog.z) + Vec4(rw.far_light) * fog.z;
  if (view.show > 0.5) light = Vec4(fog.z);
  return display_colour(display, light) * inside;
}

/// The sky's light along rays; what fog leaves at their ends; no ground: relative linear RGB. A finite distance gives fog alone.
FN Vec4 realworldz_rays_pass(IN(Realworldz) rw, IN(RealworldzView) view, Table2 densities, Table2 sky_colours, Table2 stars, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 d = Vec3(eye.y, eye.z, eye.w);
  Vec3 viewer = Vec3(Float(0.0), Float(0.0), rw.ground_radius + eye.x);
  Vec3 x = viewer + d * min(at.x, 10.0 * rw.top_radius);
  Vec3 fog = realworldz_fog_anywhere(rw, x, viewer);
  transmittance = realworldz_extinction(rw, fog.z);
  ground = Vec4(0.0);
  Vec4 colour = lookup(sky_colours, Vec2(realworldz_sky_u(one_minus_cos(d, Vec3(at.y, at.z, at.w))), exp(-realworldz_sky_depth(rw, densities, eye.x, d.z))));
  colour = realworldz_fragment(colour, realworldz_stars(stars, view.star_gain, realworldz_turned(view, d)), transmittance, Vec4(0.0));
  return select(at.x < 1.0e12, Vec4(0.0), colour) + Vec4(rw.far_light) * fog.z;
}
