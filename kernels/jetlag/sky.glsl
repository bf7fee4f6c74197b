#pragma once
#include "core/picture.glsl"
#include "core/radiance.glsl"
#include "core/tables.glsl"
#include "jetlag/jetlag.glsl"
// Jetlag's answers: rays, skylight, pictures. World frame: east, north, up.

/// One frame of a picture.
struct JetlagFrame {
  Scalar4 random;  // [texel] in 0..1023  x, y: of the noise at the picture's first pixel: its random numbers
  Scalar show;     // [1] in 0..3    0: the picture; 1: transmittance; 2: clouds at the height `slice`; 3: optical depth from there to the Sun
  Scalar slice;    // [m] in 0..2e4
  Scalar gain;     // [1] in 0..1    less than 1 while the intro fades in
  Scalar pad;      // [1] in 0..1
};

/// From (east, north, up) to the kernel's (east, up, south) [1].
/// @param v [1] in -1..1
FN Vec3 jetlag_frame(Vec3 v) { return Vec3(v.x, v.z, -v.y); }

/// Sunlight at a place through the air, in 32 steps [1].
FN_SHARED Vec4 jetlag_sunlight(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 p, Vec3 sun) {
  Float gap = jetlag_gap(jetlag, p);
  Float sunward = dot(p, sun) + jetlag.ground_radius * sun.y;
  Vec2 depth = jetlag_depth(jetlag, drift, noise, p, sun, gap, sunward, Float(0.0), jetlag_to_top(jetlag, gap, sunward), 32, Float(jetlag.jitter.x), 0, Vec2(0.0, 0.0));
  return jetlag_through(jetlag, depth) * jetlag.sun_intensity;
}

/// Light that the ground reflects, lit by the Sun through the air: the source divides by 3, not by pi [1].
FN_SHARED Vec4 jetlag_ground(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 p, Vec3 sun) {
  Float sunward = dot(p, sun) + jetlag.ground_radius * sun.y;
  Float facing = max(sunward * (1.0 / jetlag.ground_radius), 0.0);
  return jetlag_sunlight(jetlag, drift, noise, p, sun) * (facing * (jetlag.albedo * (1.0 / 3.0)));
}

/// The same of land that a picture shows, as core_surface_pass has it; the system has no skylight. Of a piece of land the altitude is known,
/// not the place: clouds shade it as they would at the eye's.
FN Vec4 jetlag_surface_pass(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Table2 places, Table2 normals, Table2 albedos, Vec2 uv, OUT(Vec4) from_sky) {
  Vec4 place = fetch_same(places, uv);
  Vec3 p = Vec3(Float(jetlag.eye.x), place.x, Float(jetlag.eye.z));
  Vec3 sun = Vec3(sqrt(max((1.0 - place.y) * (1.0 + place.y), 0.0)), place.y, Float(0.0));
  from_sky = Vec4(0.0);
  return fetch_same(albedos, uv) * jetlag_sunlight(jetlag, drift, noise, p, sun) * (max(fetch_same(normals, uv).w, 0.0) * place.z * (1.0 / 3.0));
}

/// A ray's light from the air alone [1]; its transmittance; the ground's light, attenuated.
/// An infinite distance goes to the top of the air, or to the ground where that is near enough to be seen.
FN_SHARED Vec4 jetlag_ray(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 o, Vec3 view, Vec3 sun, Float distance, Vec2 jitter, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Float gap = jetlag_gap(jetlag, o);
  Float along = dot(o, view) + jetlag.ground_radius * view.y;
  Float discriminant = along * along - gap;
  Float to_ground = gap / max(abs(along) + sqrt(max(discriminant, 0.0)), 1.0e-6);
  Bool hits = (along < 0.0) && (discriminant > 0.0) && (to_ground >= 0.0) && (to_ground < jetlag.ground_reach) && (to_ground <= distance);
  Float length = select(hits, to_ground, select(distance < 1.0e9, distance, jetlag_to_top(jetlag, gap, along)));
  Vec4 light = jetlag_scatter(jetlag, drift, noise, o, view, length, sun, jitter, transmittance);
  ground = Vec4(0.0);
  if (any(hits)) ground = select(hits, jetlag_ground(jetlag, drift, noise, o + view * length, sun) * transmittance, Vec4(0.0));
  return light;
}

/// The air's light along rays; the transmittance; the ground's light, attenuated: relative linear RGB.
FN Vec4 jetlag_rays_pass(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 o = Vec3(Float(jetlag.eye.x), eye.x, Float(jetlag.eye.z));
  return jetlag_ray(jetlag, drift, noise, o, jetlag_frame(Vec3(eye.y, eye.z, eye.w)), jetlag_frame(Vec3(at.y, at.z, at.w)), at.x, Vec2(Float(jetlag.jitter.x), Float(jetlag.jitter.y)), transmittance, ground);
}

/// Skylight from one direction of the hemisphere (u) for one observer (v), times its weight [1].
FN Vec4 jetlag_sky_light_pass(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 eye = fetch(eyes, Float(0.0), floor(uv.y * height_of(eyes)));
  Vec4 at = fetch(suns, Float(0.0), floor(uv.y * height_of(suns)));
  Float weight = Float(0.0);
  Vec3 view = hemisphere_direction(floor(uv.x * 256.0), at.w, weight);
  Vec3 o = Vec3(Float(jetlag.eye.x), eye.x, Float(jetlag.eye.z));
  Vec4 transmittance = Vec4(0.0);
  Vec4 ground = Vec4(0.0);
  return jetlag_ray(jetlag, drift, noise, o, jetlag_frame(view), jetlag_frame(sun_ahead(Vec3(at.y, at.z, at.w))), Float(1.0e30), Vec2(Float(jetlag.jitter.x), Float(jetlag.jitter.y)), transmittance, ground) * weight;
}

/// Sunlight at places [1].
FN Vec4 jetlag_sun_irradiance_pass(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Table2 eyes, Table2 suns, Vec2 uv) {
  Vec4 at = fetch_same(suns, uv);
  Vec3 sun = jetlag_frame(Vec3(at.y, at.z, at.w));
  Vec3 p = Vec3(Float(jetlag.eye.x), fetch_same(eyes, uv).x, Float(jetlag.eye.z));
  Vec2 depth = jetlag_light(jetlag, drift, noise, p, sun, jetlag_gap(jetlag, p), dot(p, sun) + jetlag.ground_radius * sun.y, 32, Float(jetlag.jitter.x), 0, Vec2(0.0, 0.0));
  return jetlag_through(jetlag, depth) * jetlag.sun_intensity;
}

/// Densities of molecules and haze, the clouds' noise, the height [m]: at places of the kernel's frame.
FN Vec4 jetlag_density_pass(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Table2 places, Vec2 uv) {
  Vec3 p = xyz(fetch_same(places, uv));
  Float gap = jetlag_gap(jetlag, p);
  Float height = jetlag_height(jetlag, gap);
  Vec2 density = jetlag_density(jetlag, gap);
  return Vec4(density.x, density.y + jetlag_cloud(jetlag, drift, noise, p, height), jetlag_cloud_noise(drift, noise, p), height);
}

/// The noise at coordinates in texels [1].
FN Vec4 jetlag_noise_pass(Table2 noise, Table2 places, Vec2 uv) {
  return Vec4(jetlag_noise(noise, xyz(fetch_same(places, uv))));
}

/// Depths [m] of molecules and haze from places (w: length [m]) along directions, in light steps.
FN Vec4 jetlag_depth_pass(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Table2 places, Table2 directions, Vec2 uv) {
  Vec4 place = fetch_same(places, uv);
  Vec3 direction = xyz(fetch_same(directions, uv));
  Vec2 depth = jetlag_depth(jetlag, drift, noise, xyz(place), direction, jetlag_gap(jetlag, xyz(place)), dot(xyz(place), direction) + jetlag.ground_radius * direction.y, Float(0.0), place.w, int(jetlag.light_steps), Float(jetlag.jitter.x), 0, Vec2(0.0, 0.0));
  return Vec4(depth.x, depth.y, Float(0.0), Float(0.0));
}

/// Where a ray meets the height `slice` [1]: density of clouds, 1 at most; or the optical depth from there to the Sun.
FN_SHARED Vec4 jetlag_slice(IN(Jetlag) jetlag, IN(JetlagDrift) drift, IN(JetlagFrame) frame, Table2 noise, Vec3 o, Vec3 view, Vec3 sun, Scalar jitter) {
  Float shell = Float(frame.slice * (2.0 * jetlag.ground_radius + frame.slice));
  Float to = jetlag_escape(jetlag_gap(jetlag, o), dot(o, view) + jetlag.ground_radius * view.y, shell);
  Vec3 p = o + view * max(to, 0.0);
  Vec4 shown = Vec4(0.0);
  if (frame.show < 2.5) {
    shown = Vec4(jetlag_cloud(jetlag, drift, noise, p, Float(frame.slice)) * (1.0 / 250.0));
  } else {
    Vec2 depth = jetlag_light(jetlag, drift, noise, p, sun, shell, dot(p, sun) + jetlag.ground_radius * sun.y, int(jetlag.light_steps), Float(jitter), 0, Vec2(0.0, 0.0));
    shown = Vec4(jetlag.rayleigh) * depth.x + Vec4(jetlag.mie_extinction * depth.y);
  }
  return select(to >= 0.0, shown, Vec4(0.0));
}

/// One frame of a picture, linear sRGB [cd/m^2].
FN Vec4 jetlag_picture_pass(IN(Camera) camera, IN(Observer) observer, IN(Display) display, IN(Jetlag) jetlag, IN(JetlagDrift) drift, IN(JetlagFrame) frame, IN(GridSize) size, Table2 noise, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 sun = jetlag_frame(Vec3(observer.sun.x, observer.sun.y, observer.sun.z));
  Vec3 o = Vec3(Float(jetlag.eye.x), Float(observer.altitude), Float(jetlag.eye.z));
  Vec2 at = uv;
  Vec2 jitter = Vec2(Float(jetlag.jitter.x), Float(jetlag.jitter.y));
  if (jetlag.jitter.z > 0.5) {
    // With the value 1 the published loop runs a step less.
    Vec4 random = min(lookup_repeat(noise, Vec2((floor(uv.x * size.width) + frame.random.x + 0.5) * (1.0 / 1024.0), (floor(uv.y * size.height) + frame.random.y + 0.5) * (1.0 / 1024.0))), 0.999);
    at = Vec2(uv.x + (random.x - 0.5) * (1.0 / size.width), uv.y + (random.y - 0.5) * (1.0 / size.height));
    jitter = Vec2(random.z, random.w);
  }
  Vec3 view = jetlag_frame(camera_view(camera, at, inside));
  Vec4 light = Vec4(0.0);
  if (frame.show > 1.5) {
    light = jetlag_slice(jetlag, drift, frame, noise, o, view, sun, jetlag.jitter.x);
  } else {
    Vec4 transmittance = Vec4(0.0);
    Vec4 ground = Vec4(0.0);
    light = jetlag_ray(jetlag, drift, noise, o, view, sun, Float(1.0e30), jitter, transmittance, ground) + ground;
    if (frame.show > 0.5) light = transmittance;
  }
  // Pixels that a fisheye leaves black do not depend on the jitter.
  camera_view(camera, uv, inside);
  return display_colour(display, light * frame.gain) * inside;
}
