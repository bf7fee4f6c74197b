#pragma once
#include "core/cube.glsl"
#include "core/picture.glsl"
#include "core/sun_direction.glsl"
#include "core/tables.glsl"
// The sky of codeflow.org (F. Boesch, "Advanced WebGL, part 2: sky rendering", 2011): a ray march through a unit sphere of constant
// density whose light is lost and returned by laws made for the eye. Lengths are in radii of the sphere; the eye looks from
// (0, 0, surface_height), z up. Equations and names are the article's; where a formula here looks different it is the same number.

struct Codeflow {
  Scalar4 kr;                  // [1] in 0.05..0.95  colour of air: the share of each channel that it scatters, and the base of what it absorbs
  Scalar intensity;            // [1] in 0..10       sunlight before it enters the air
  Scalar surface_height;       // [1] in 0.9..0.999  radius at which the eye stands; 1 minus this is the thickness of the air
  Scalar steps;                // [1] in 1..64       samples along the eye's ray
  Scalar scatter_strength;     // [1] in 0.001..1    how fast sunlight is absorbed on its way to a sample
  Scalar rayleigh_strength;    // [1] in 0.001..1    absorption of the bluish part on its way to the eye
  Scalar mie_strength;         // [1] in 0.0001..1   absorption of the aerosol part on its way to the eye
  Scalar rayleigh_power;       // [1] in 0.01..1     exponent of "long rays return more light", bluish part
  Scalar mie_power;            // [1] in 0.01..1     the same, aerosol part
  Scalar rayleigh_brightness;  // [1] in 0.1..10     gain of the bluish sky
  Scalar mie_brightness;       // [1] in 0.001..1    gain of the broad glow around the Sun
  Scalar mie_distribution;     // [1] in 0.01..0.99  g of that glow: larger is tighter
  Scalar spot_brightness;      // [1] in 1..100      gain of the Sun's disc
  Scalar spot_g;               // [1] in 0.9..0.9999 tightness of the disc
  Scalar spot_max;             // [1] in 1..100      phase function at which the disc saturates
  Scalar eye_margin;           // [1] in 0.01..0.5   how far below the ground the horizon of views lies
  Scalar sun_margin;           // [1] in 0.01..0.5   the same for sunlight on its way to samples
  Scalar show;                 // [1] in 0..6        0: the sky; parts of it: 1 cR, 2 cM, 3 fR, 4 fM, 5 spot, 6 ee
  Scalar pad0;                 // [1] in 0..1
  Scalar pad1;                 // [1] in 0..1
  Scalar pad2;                 // [1] in 0..1
};

/// Cornette and Shanks's phase function with mean 1 over the sphere [1].
/// @param g [1] in -0.5..0.9999
/// @param one_minus_cos [1] in 0..2
/// @bound 1e-3 scale 1   the peak of g = 0.9999 is (1 - g)^-2, of which float holds three digits
FN Float codeflow_lobe(Scalar g, Float one_minus_cos) { return 12.5663706143592 * phase_cornette_shanks(g, one_minus_cos); }

/// Distance from a point inside the unit sphere to its surface [1], from what 1 - p.p and p.d are.
/// @param gap [1] in 0..1  1 - p.p
/// @param along [1] in -1..1  p.d
FN Float codeflow_distance(Float gap, Float along) {
  Float c = max(gap, 0.0);
  Float root = sqrt(along * along + c);
  // Outward both terms of root - p.d are alike and cancel: the same root, divided.
  return select(along < 0.0, root - along, c / max(abs(along) + root, 1.0e-20));
}

/// Distance from a point inside the unit sphere to its surface [1].
/// @param position [1] in -0.57..0.57
/// @param direction [1] in -0.577..0.577
FN Float codeflow_depth(Vec3 position, Vec3 direction) {
  return codeflow_distance(1.0 - dot(position, position), dot(position, direction));
}

/// How free of the solid core a direction is [1]: 0 where it meets the core, 1 from half a radian above its edge.
/// The article's arc cosine of w.d is the angle at the point between the direction and the core's edge nearest to its closest approach; that
/// triangle has a right angle, so the angle is atan2(|n| - r, u) and needs no case for rays that look outward (u < 0).
/// @param squared [1] in 0..1   p.p
/// @param along [1] in -1..1    p.d
/// @param radius [1] in 0.3..0.99  of the core
/// @bound 1e-4 scale 1   near its edge the angle is that between nearly parallel lines
FN Float codeflow_free(Float squared, Float along, Scalar radius) {
  Float closest = sqrt(max(squared - along * along, 0.0));
  Float twice = 2.0 * arc_tangent2(max(closest - radius, 0.0), -along);
  Float t = min(twice * twice * twice, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// The same from position and direction [1].
/// @param position [1] in -0.57..0.57
/// @param direction [1] in -0.577..0.577
/// @param radius [1] in 0.3..0.99  of the core
/// @bound 1e-4 scale 1   as codeflow_free
FN Float codeflow_horizon(Vec3 position, Vec3 direction, Scalar radius) {
  return codeflow_free(dot(position, position), dot(position, direction), radius);
}

/// What is left of white light after a distance in air of which one length is lost as `loss` says: 1 - exp(-loss / distance) [1].
/// @param loss [1] in 0.001..3  strength times -ln kr, a channel each
/// @param distance [1] in 0..2  at 0 nothing is lost: the guard is what the article leaves to infinities
FN Vec3 codeflow_left(Vec3 loss, Float distance) {
  Float shortness = 1.0 / max(distance, 1.0e-9);
  return Vec3(one_minus_exp(loss.x * shortness), one_minus_exp(loss.y * shortness), one_minus_exp(loss.z * shortness));
}

/// -ln kr [1].
FN Vec3 codeflow_loss(IN(Codeflow) codeflow) {
  return Vec3(-ln(Float(codeflow.kr.x)), -ln(Float(codeflow.kr.y)), -ln(Float(codeflow.kr.z)));
}

/// Light left after a distance, per channel: 1 - kr^(strength / distance) [1].
/// @param strength [1] in 0.001..1
/// @param distance [1] in 0..2
FN Vec3 codeflow_absorb(IN(Codeflow) codeflow, Scalar strength, Float distance) {
  return codeflow_left(codeflow_loss(codeflow) * Float(strength), distance);
}

/// Red, green and blue of the sky in a direction, relative [1].
/// @param view [1] in -0.577..0.577
/// @param sun [1] in -0.577..0.577
/// @bound 1e-3 scale 10   random vectors are no unit vectors
FN Vec3 codeflow_sky(IN(Codeflow) codeflow, Vec3 view, Vec3 sun) {
  Float apart = one_minus_cos(view, sun);
  Float eye_along = codeflow.surface_height * view.z;
  Float sun_along = codeflow.surface_height * sun.z;
  Float gap = Float(1.0 - codeflow.surface_height * codeflow.surface_height);
  Float reach = codeflow_distance(gap, eye_along);
  Float step = reach * (1.0 / codeflow.steps);
  Vec3 loss = codeflow_loss(codeflow);
  Vec3 sun_loss = loss * Float(codeflow.scatter_strength);
  Vec3 rayleigh_loss = loss * Float(codeflow.rayleigh_strength);
  Vec3 mie_loss = loss * Float(codeflow.mie_strength);
  Scalar core = codeflow.surface_height - codeflow.sun_margin;
  Vec3 rayleigh = Vec3(Float(0.0), Float(0.0), Float(0.0));
  Vec3 mie = rayleigh;
  for (int i = 0; i < int(codeflow.steps); ++i) {
    // The left end of each step; the first sample is at the eye. p.p and p.sun of p = eye + x view follow from the eye's.
    Float x = Float(i) * step;
    Float squared = 1.0 - gap + x * (2.0 * eye_along + x);
    Float along = sun_along + x * (1.0 - apart);
    Vec3 arriving = codeflow_left(sun_loss, codeflow_distance(1.0 - squared, along)) * codeflow_free(squared, along, core);
    rayleigh = rayleigh + arriving * codeflow_left(rayleigh_loss, x);
    mie = mie + arriving * codeflow_left(mie_loss, x);
  }
  Float open = codeflow_free(1.0 - gap, eye_along, codeflow.surface_height - codeflow.eye_margin);
  Float gain = open * (codeflow.intensity / codeflow.steps);
  Float longest = ln(reach);
  rayleigh = rayleigh * Vec3(Float(codeflow.kr.x), Float(codeflow.kr.y), Float(codeflow.kr.z)) * (gain * exp(longest * codeflow.rayleigh_power));
  mie = mie * (gain * exp(longest * codeflow.mie_power));
  Float rayleigh_gain = codeflow_lobe(-0.01, apart) * codeflow.rayleigh_brightness;
  Float mie_gain = codeflow_lobe(codeflow.mie_distribution, apart) * codeflow.mie_brightness;
  Float spot = smooth_step(0.0, codeflow.spot_max, codeflow_lobe(codeflow.spot_g, apart)) * codeflow.spot_brightness;
  Vec3 colour = mie * (spot + mie_gain) + rayleigh * rayleigh_gain;
  if (codeflow.show > 0.5) {
    colour = rayleigh;
    if (codeflow.show > 1.5) colour = mie;
    if (codeflow.show > 2.5) colour = Vec3(rayleigh_gain, rayleigh_gain, rayleigh_gain);
    if (codeflow.show > 3.5) colour = Vec3(mie_gain, mie_gain, mie_gain);
    if (codeflow.show > 4.5) colour = Vec3(spot, spot, spot);
    if (codeflow.show > 5.5) colour = Vec3(open, open, open);
  }
  return colour;
}

/// The sky as a cube map, redrawn only when the Sun or a parameter changes: relative red, green, blue [1].
FN Vec4 codeflow_cube_pass(IN(Codeflow) codeflow, IN(SunDirection) sun_direction, IN(GridSize) size, Vec2 uv) {
  Vec3 sun = Vec3(sun_direction.direction.x, sun_direction.direction.y, sun_direction.direction.z);
  Vec3 colour = codeflow_sky(codeflow, cube_view(uv, size.width), sun);
  return Vec4(colour.x, colour.y, colour.z, Float(1.0));
}

/// A picture: one look into the cube map a pixel, linear sRGB [cd/m^2].
FN Vec4 codeflow_picture_pass(IN(Camera) camera, IN(Display) display, Table2 cube, Vec2 uv) {
  Float inside = Float(0.0);
  Vec3 view = camera_view(camera, uv, inside);
  return display_colour(display, lookup(cube, cube_uv(view, width_of(cube)))) * inside;
}

/// The sky along rays, relative red, green, blue [1]. The system says nothing of what lies in the air.
FN Vec4 codeflow_rays_pass(IN(Codeflow) codeflow, Table2 eyes, Table2 suns, Vec2 uv, OUT(Vec4) transmittance, OUT(Vec4) ground) {
  Vec4 eye = fetch_same(eyes, uv);
  Vec4 at = fetch_same(suns, uv);
  Vec3 colour = codeflow_sky(codeflow, Vec3(eye.y, eye.z, eye.w), Vec3(at.y, at.z, at.w));
  transmittance = Vec4(0.0);
  ground = Vec4(0.0);
  return Vec4(colour.x, colour.y, colour.z, Float(0.0));
}
