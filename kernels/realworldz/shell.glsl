#pragma once
#include "core/math.glsl"
// RealWorldz' aerial perspective: fog shaped by two spheres, without scattering. Places are relative to the planet's centre.

struct Realworldz {
  Scalar4 far_transmittance;  // [1] in 0..1  colour multiplier at full fog
  Scalar4 far_light;          // [1] in 0..10  air light at full fog
  Scalar4 sun_light;          // [1] in 0..10  on terrain
  Scalar bounding_radius;     // [m] in 62e3..64e3  of the highest terrain
  Scalar outer_radius;        // [m] in 64e3..70e3  shell without fog
  Scalar inner_radius;        // [m] in 50e3..58e3  shell of full fog
  Scalar clear;               // [1] in 0..2  strength of the clear zone around the viewer
  Scalar clear_falloff;       // [m^-2] in 1e-9..1e-7 log  inverse square width of that zone
  Scalar auto_clear;          // [1] in 0..1  1: that strength is the fog's at the viewer
  Scalar ground_radius;       // [m] in 50e3..60e3  of the lowest terrain
  Scalar top_radius;          // [m] in 70e3..80e3  of the sky's air
  Scalar density;             // [1/m] in 1e-5..1e-3 log  the sky's optical depth per length at the ground
  Scalar scale_height;        // [m] in 500..5000
  Scalar relief;              // [m] in 0..3e3  height of the highest terrain
  Scalar painted;             // [1] in 0..1  1: the sky's air is as dense as the table `densities` says; 0: exponential
};

/// Squared length [m^2].
/// @param v [m] in -1e5..1e5
/// @bound 2e-5 scale 1e9
FN Float realworldz_square(Vec3 v) { return dot(v, v); }

/// Vector at length 1, or 0 if it has none [1].
/// @param v [m] in -1e5..1e5
FN Vec3 realworldz_unit(Vec3 v) { return v * (1.0 / max(sqrt(dot(v, v)), 1.0e-9)); }

/// Centre of the shells: beyond the planet's, so that the outer one touches the bounding sphere above the viewer [m].
/// @param viewer [m] in 3e4..5e4
/// @bound 2e-5 scale 1e4
FN Vec3 realworldz_centre(IN(Realworldz) rw, Vec3 viewer) { return realworldz_unit(viewer) * (rw.bounding_radius - rw.outer_radius); }

/// Shell function: 0 on the outer shell, 1 on the inner [1].
/// @param x [m] in -4e4..4e4
/// @param viewer [m] in 3e4..5e4
FN Float realworldz_shell(IN(Realworldz) rw, Vec3 x, Vec3 viewer) {
  Vec3 d = x - realworldz_centre(rw, viewer);
  return (rw.outer_radius * rw.outer_radius - dot(d, d)) / ((rw.outer_radius - rw.inner_radius) * (rw.outer_radius + rw.inner_radius));
}

/// Fog at a place inside the bounding sphere [1]: the shell function, what the clear zone takes off, and the difference, in 0..1.
/// @param x [m] in -4e4..4e4
/// @param viewer [m] in 3e4..5e4
FN Vec3 realworldz_fog(IN(Realworldz) rw, Vec3 x, Vec3 viewer) {
  Float shell = realworldz_shell(rw, x, viewer);
  Float strength = Float(rw.clear);
  // Never negative: a viewer above the outer shell would have fog before him.
  if (rw.auto_clear > 0.5) strength = max(realworldz_shell(rw, viewer, viewer), 0.0);
  Vec3 d = x - viewer;
  Float clear = strength * exp(-rw.clear_falloff * dot(d, d));
  return Vec3(shell, clear, clamp(shell - clear, 0.0, 1.0));
}

/// Distance at which a viewer's horizon ray meets the bounding sphere [m]: the tangent from outside, half the chord from inside.
/// @param viewer [m] in 3e4..5e4
/// @param least [m] in 100..1000
/// @bound 1e-3 scale 1e4   a root: near the sphere half the digits
FN Float realworldz_horizon(IN(Realworldz) rw, Vec3 viewer, Scalar least) {
  return max(sqrt(abs(dot(viewer, viewer) - rw.bounding_radius * rw.bounding_radius)), least);
}

/// Place that stands for one outside the bounding sphere, such as a moon or the sky [m].
/// @param x [m] in 6e4..9e4
/// @param viewer [m] in 3e4..5e4
/// @param least [m] in 100..1000
/// @bound 1e-3 scale 1e5   as realworldz_horizon; places at the viewer's have no direction
FN Vec3 realworldz_project(IN(Realworldz) rw, Vec3 x, Vec3 viewer, Scalar least) {
  return viewer + realworldz_unit(x - viewer) * realworldz_horizon(rw, viewer, least);
}

/// Fog at any place [1], as realworldz_fog.
/// @param x [m] in -4e4..4e4
/// @param viewer [m] in 3e4..5e4
FN Vec3 realworldz_fog_anywhere(IN(Realworldz) rw, Vec3 x, Vec3 viewer) {
  Bool outside = dot(x, x) > rw.bounding_radius * rw.bounding_radius;
  return realworldz_fog(rw, select(outside, realworldz_project(rw, x, viewer, 0.01 * rw.bounding_radius), x), viewer);
}

/// What fog leaves of the light behind it [1].
/// @param fog [1] in 0..1
FN Vec4 realworldz_extinction(IN(Realworldz) rw, Float fog) {
  return mix(Vec4(1.0), Vec4(rw.far_transmittance), fog);
}
