#pragma once
#include "core/math.glsl"
#include "core/phase.glsl"
// The sky of the 4-kilobyte intro "Appear" by Jetlag: single scattering of molecules and haze, marched by brute force through a
// spherical Earth's air, with clouds as more haze. Relative linear RGB; frame: x east, y up, z south, origin on the ground.
//
// A place is its `gap` = |p - C|^2 - R0^2 [m^2], C the Earth's centre: along a ray it is a quadratic of the distance, so that neither
// heights nor distances to shells cancel in float, and a height costs no root.

struct Jetlag {
  Scalar4 rayleigh;        // [1/m] in 1e-6..1e-4  red, green, blue: scattering = extinction at sea level
  Scalar4 cloud_base;      // [m] in 0..1e4  low: density is 0 up to here; low + 100: full
  Scalar4 cloud_top;       // [m] in 0..1e4  high; high - 1000
  Scalar4 eye;             // [m] in -1e4..1e4  x: east, z: south of the origin
  Scalar4 jitter;          // [1] in 0..1  x: of light steps, y: of view steps; z 1: random in pictures
  Scalar mie_scattering;   // [1/m] in 0..1e-4
  Scalar mie_extinction;   // [1/m] in 0..1e-4
  Scalar haze;             // [1] in 0..16  density of haze at sea level: 8 with clouds, else 1
  Scalar per_height;       // [1/m] in 5e-6..2e-5  of the height that both scale heights are whole parts of: a 12th, an 80th
  Scalar ground_radius;    // [m] in 1e6..1e7
  Scalar top;              // [m] in 1e4..1e5
  Scalar sun_intensity;    // [1] in 0..100
  Scalar clouds;           // [1] in 0..1  1: clouds
  Scalar near;             // [m] in 1e3..1e5  first zone of a long ray
  Scalar short_steps;      // [1] in 1..64
  Scalar near_steps;       // [1] in 1..64
  Scalar far_steps;        // [1] in 0..64
  Scalar light_steps;      // [1] in 1..64  below the clouds' top; without clouds: to the top of the air
  Scalar top_light_steps;  // [1] in 1..64  above it
  Scalar keep_top_length;  // [1] in 0..1  1, as printed: the light's last part is measured from its start, so it overshoots by the first
  Scalar midpoint;         // [1] in 0..1  1: corrected sampling, half of the own step dims a sample; 0, as printed: all of it does
  Scalar rayleigh_phase;   // [1/sr] in 0..0.1  0.0597
  Scalar mie_phase;        // [1/sr] in 0..0.1  0.0196
  Scalar mie_peak;         // [1] in 1e-3..1  1.58 - 1.52
  Scalar mie_slope;        // [1] in 0..2  1.52
  Scalar albedo;           // [1] in 0..1  of the ground
  Scalar ground_reach;     // [m] in 0..1e7  ground farther away is not seen: rays go on through the Earth, where height is 0
  Scalar pad0;             // [1] in 0..1
  Scalar pad1;             // [1] in 0..1
};

/// Where clouds have drifted to: offsets of the noise's four octaves, reduced by the host in double.
struct JetlagDrift {
  Scalar4 first;   // [texel] in 0..1023  w: clouds reach to this z [m]
  Scalar4 fourth;  // [texel] in 0..1023
  Scalar4 ninth;   // [texel] in 0..1023
  Scalar4 seventeenth;  // [texel] in 0..1023
};

/// Gap of a place, given relative to the origin [m^2].
/// @param p [m] in -1e5..1e5
/// @bound 2e-5 scale 1e11
FN Float jetlag_gap(IN(Jetlag) jetlag, Vec3 p) { return dot(p, p) + 2.0 * jetlag.ground_radius * p.y; }

/// Height of a place above the ground, 0 below it [m].
/// @param gap [m^2] in 0..2e11
/// @bound 2e-5 scale 1e3
FN Float jetlag_height(IN(Jetlag) jetlag, Float gap) {
  // R (sqrt(1 + q) - 1) as a series: its next term is 1e-8 of it up to 100 km, above which no density is left.
  Float q = clamp(gap * (1.0 / (jetlag.ground_radius * jetlag.ground_radius)), 0.0, 0.25);
  return jetlag.ground_radius * q * (0.5 - q * (0.125 - q * (0.0625 - q * 0.0390625)));
}

/// Densities of molecules and of haze, relative to those of clear air at sea level [1].
/// @param gap [m^2] in 0..2e11
FN Vec2 jetlag_density(IN(Jetlag) jetlag, Float gap) {
  // One exponential for both: its 12th power, over 8000 m, and its 80th, over 1200 m. Up to 96 km its argument is at most 1, so that a
  // polynomial does; higher up density stays at the 6e-6 that it has there. Marching takes most of its time here.
  Scalar radius = jetlag.ground_radius;
  Float q = max(gap * (1.0 / (radius * radius)), 0.0);
  // jetlag_height without the last term, which is a millimetre at 20 km.
  Float x = min(q * ((0.5 * radius * jetlag.per_height) - q * ((0.125 * radius * jetlag.per_height) - q * (0.0625 * radius * jetlag.per_height))), 1.0);
  // 1 - (1 - exp(-x)) / x * x, that quotient interpolated at the zeros of a Chebyshev polynomial: to 5e-9.
  Float part = 1.0 - x * (0.9999999979336 - x * (0.4999997972521 - x * (0.166663403115 - x * (0.04164684931344 - x * (0.008275504843689 -
               x * (0.00130077495802 - x * 0.000129076310222))))));
  Float second = part * part;
  Float fourth = second * second;
  Float eighth = fourth * fourth;
  Float sixteenth = eighth * eighth;
  Float thirtysecond = sixteenth * sixteenth;
  return Vec2(fourth * eighth, jetlag.haze * (thirtysecond * thirtysecond * sixteenth));
}

/// Distance along a ray to a sphere about the Earth's centre: where it enters, else where it leaves; -1 if it misses [m].
/// @param gap [m^2] in 0..2e11  of the ray's begin
/// @param along [m] in -6.4e6..6.4e6  from the Earth's centre to there, along the ray
/// @param shell [m^2] in 2e11..3e11  gap of the sphere
/// @bound 2e-5 scale 1e6
FN Float jetlag_escape(Float gap, Float along, Float shell) {
  Float c = gap - shell;
  Float discriminant = along * along - c;
  // The larger root as a sum, the other by their product: neither cancels.
  Float large = abs(along) + sqrt(max(discriminant, 0.0));
  Float other = c / max(large, 1.0e-6);
  Float enter = select(along < 0.0, other, -large);
  Float leave = select(along < 0.0, large, -other);
  return select(discriminant < 0.0, Float(-1.0), select(enter >= 0.0, enter, leave));
}

/// The noise: one channel of a repeating table in a plane, another in a second plane [1].
FN Float jetlag_noise(Table2 noise, Vec3 v) {
  // Texel centres are at whole coordinates.
  Scalar per_texel = 1.0 / width_of(noise);
  Vec4 first = lookup_repeat(noise, Vec2((v.x + 0.5) * per_texel, (v.z + 0.5) * per_texel));
  Vec4 second = lookup_repeat(noise, Vec2((v.y + 0.5) * per_texel, (v.x + 0.5) * per_texel));
  return 0.5 * (first.x + second.y);
}

/// Four octaves of the noise at a place among the drifting clouds [1].
FN_SHARED Float jetlag_cloud_noise(IN(JetlagDrift) drift, Table2 noise, Vec3 p) {
  Vec3 v = 0.0015 * p;
  return 0.75 * jetlag_noise(noise, v + xyz(Vec4(drift.first))) + 0.125 * jetlag_noise(noise, 4.0 * v + xyz(Vec4(drift.fourth))) +
         0.0625 * jetlag_noise(noise, 9.0 * v + xyz(Vec4(drift.ninth))) +
         0.0625 * jetlag_noise(noise, 17.0 * v + xyz(Vec4(drift.seventeenth))) - 0.1;
}

/// What clouds add to the density of haze [1].
FN Float jetlag_cloud(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 p, Float height) {
  Float density = Float(0.0);
  Bool inside = (height > jetlag.cloud_base.x) && (height < jetlag.cloud_top.x) && (p.z <= drift.first.w);
  if (any(inside)) {
    Float shape = smooth_step(jetlag.cloud_base.x, jetlag.cloud_base.y, height) * smooth_step(jetlag.cloud_top.x, jetlag.cloud_top.y, height) *
                  smooth_step(0.5, 0.55, jetlag_cloud_noise(drift, noise, p));
    density = select(inside, 250.0 * shape, 0.0);
  }
  return density;
}

/// Depths of molecules and of haze over a part of a ray through clear air, in equal steps from its beginning [m].
/// Of the steps some may be `known`, by the sum of their densities.
/// @param gap [m^2] in 0..2e11
/// @param along [m] in 0..4e5
/// @param begin [m] in 0..2e4
/// @param length [m] in 0..2e5
/// @param steps [1] in 1..32
/// @param jitter [1] in 0..1
/// @param known [1] in 0..1
/// @param sum [1] in 0..1
/// @bound 2e-5 scale 1e5
FN Vec2 jetlag_depth_clear(IN(Jetlag) jetlag, Float gap, Float along, Float begin, Float length, int steps, Float jitter, int known, Vec2 sum) {
  Vec2 total = sum;
  Float step_length = length * (1.0 / Float(steps));
  Float nth = Float(known) + jitter;
  for (int i = known; i < steps; ++i) {
    Float s = begin + step_length * nth;
    total = total + jetlag_density(jetlag, gap + s * (2.0 * along + s));
    nth = nth + 1.0;
  }
  return total * step_length;
}

/// The same, with clouds if there are any: they alone need the place where the ray begins.
FN Vec2 jetlag_depth(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 o, Vec3 direction, Float gap, Float along, Float begin, Float length, int steps, Float jitter, int known, Vec2 sum) {
  Vec2 depth = Vec2(0.0, 0.0);
  // Asked once, not at each step: without clouds all of a step stays in registers.
  if (jetlag.clouds > 0.5) {
    Vec2 total = sum;
    Float step_length = length * (1.0 / Float(steps));
    Float nth = Float(known) + jitter;
    for (int i = known; i < steps; ++i) {
      Float s = begin + step_length * nth;
      Float at = gap + s * (2.0 * along + s);
      total = total + jetlag_density(jetlag, at);
      total.y = total.y + jetlag_cloud(jetlag, drift, noise, o + direction * s, jetlag_height(jetlag, at));
      nth = nth + 1.0;
    }
    depth = total * step_length;
  } else {
    depth = jetlag_depth_clear(jetlag, gap, along, begin, length, steps, jitter, known, sum);
  }
  return depth;
}

/// Length of a ray inside the air [m].
/// @param gap [m^2] in 0..2e11  of its beginning
/// @param along [m] in -6.4e6..6.4e6  from the Earth's centre to there, along the ray
/// @bound 2e-5 scale 1e6
FN Float jetlag_to_top(IN(Jetlag) jetlag, Float gap, Float along) {
  return max(jetlag_escape(gap, along, Float(jetlag.top * (2.0 * jetlag.ground_radius + jetlag.top))), 0.0);
}

/// Depths of molecules and of haze from a place to the Sun [m].
/// Gap and distance along are those of the place and the Sun's direction; some of the first steps may be known.
FN_SHARED Vec2 jetlag_light(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 p, Vec3 sun, Float gap, Float along, int steps, Float jitter, int known, Vec2 sum) {
  Float length = jetlag_to_top(jetlag, gap, along);
  Vec2 depth = Vec2(0.0, 0.0);
  if (jetlag.clouds > 0.5) {
    // Finer steps as far as the clouds' top.
    Float below = max(jetlag_escape(gap, along, Float(jetlag.cloud_top.x * (2.0 * jetlag.ground_radius + jetlag.cloud_top.x))), 0.0);
    depth = jetlag_depth(jetlag, drift, noise, p, sun, gap, along, Float(0.0), below, steps, jitter, known, sum);
    Float rest = length;
    if (jetlag.keep_top_length < 0.5) rest = max(length - below, 0.0);
    depth = depth + jetlag_depth(jetlag, drift, noise, p, sun, gap, along, below, rest, int(jetlag.top_light_steps), jitter, 0, Vec2(0.0, 0.0));
  } else {
    depth = jetlag_depth_clear(jetlag, gap, along, Float(0.0), length, steps, jitter, known, sum);
  }
  return depth;
}

/// Transmittance of depths of molecules and haze [1]; w is 1.
/// @param depth [m] in 0..1e6
FN Vec4 jetlag_through(IN(Jetlag) jetlag, Vec2 depth) {
  Float haze = jetlag.mie_extinction * depth.y;
  return Vec4(exp(-(jetlag.rayleigh.x * depth.x + haze)), exp(-(jetlag.rayleigh.y * depth.x + haze)), exp(-(jetlag.rayleigh.z * depth.x + haze)), Float(1.0));
}

/// Light scattered by both species together, of what they gathered [1]: relative radiance; w is 0.
/// @param molecules [m] in 0..1e5
/// @param haze [m] in 0..1e5
/// @param one_minus_cos [1] in 0..2
/// @bound 2e-5 scale 1e3
FN Vec4 jetlag_scattered(IN(Jetlag) jetlag, Vec4 molecules, Vec4 haze, Float one_minus_cos) {
  Float mu = 1.0 - one_minus_cos;
  Float d = jetlag.mie_peak + jetlag.mie_slope * one_minus_cos;
  Float haze_phase = jetlag.mie_phase / max(d * sqrt(d), 1.0e-9);
  Vec4 light = molecules * Vec4(jetlag.rayleigh) * jetlag.rayleigh_phase + haze * (jetlag.mie_scattering * haze_phase);
  light = light * (jetlag.sun_intensity * (1.0 + mu * mu));
  return Vec4(light.x, light.y, light.z, Float(0.0));
}

/// Depths [m] of molecules and of haze along a ray through clear air, and the light that both gather there [m], in equal steps.
/// @param gap [m^2] in 0..2e11  of its beginning
/// @param along [m] in 0..4e5  from the Earth's centre to there, along the ray
/// @param length [m] in 0..2e5
/// @param sunward [m] in 0..4e6  from the Earth's centre to there, towards the Sun
/// @param toward [1] in -1..1  by which that grows with distance
/// @param jitter [1] in 0..1  x: of light steps, y: of view steps
/// @param known [1] in 0..1  1: the way to the Sun begins with the sample's own density
/// @bound 2e-5 scale 1e5
FN Vec2 jetlag_march_clear(IN(Jetlag) jetlag, Float gap, Float along, Float length, Float sunward, Float toward, Vec2 jitter, int known, OUT(Vec4) molecules, OUT(Vec4) haze) {
  int steps = int(jetlag.short_steps);
  int light_steps = int(jetlag.light_steps);
  Float step_length = length * (1.0 / Float(steps));
  Float own = Float(1.0 - 0.5 * jetlag.midpoint);  // part of the own step that dims a sample
  Float nth = jitter.y;
  Vec2 depth = Vec2(0.0, 0.0);
  molecules = Vec4(0.0);
  haze = Vec4(0.0);
  for (int i = 0; i < steps; ++i) {
    Float s = step_length * nth;
    Float at = gap + s * (2.0 * along + s);
    Float up = sunward + s * toward;
    Vec2 density = jetlag_density(jetlag, at);
    Vec2 q = density * step_length;
    Vec2 dims = depth + q * own;
    depth = depth + q;
    Vec2 sum = Vec2(0.0, 0.0);
    if (known > 0) sum = density;
    dims = dims + jetlag_depth_clear(jetlag, at, up, Float(0.0), jetlag_to_top(jetlag, at, up), light_steps, jitter.x, known, sum);
    Vec4 light = jetlag_through(jetlag, dims);
    molecules = molecules + light * q.x;
    haze = haze + light * q.y;
    nth = nth + 1.0;
  }
  return depth;
}

/// The same through clouds.
/// Both zones of a long ray and a short ray are one loop, each lane with steps of its own length.
FN Vec2 jetlag_march_cloud(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 o, Vec3 view, Vec3 sun, Float gap, Float along, Float length, Float sunward, Float toward, Vec2 jitter, int known, OUT(Vec4) molecules, OUT(Vec4) haze) {
  int short_steps = int(jetlag.short_steps);
  int near_steps = int(jetlag.near_steps);
  int steps = near_steps + int(jetlag.far_steps);
  if (steps < short_steps) steps = short_steps;
  Bool far = length >= jetlag.near;
  Float near_length = select(far, Float(jetlag.near / Scalar(near_steps)), length * (1.0 / Float(short_steps)));
  Float far_length = (length - jetlag.near) * (1.0 / max(Float(jetlag.far_steps), 1.0));
  Float own = Float(1.0 - 0.5 * jetlag.midpoint);
  Vec2 depth = Vec2(0.0, 0.0);
  molecules = Vec4(0.0);
  haze = Vec4(0.0);
  for (int i = 0; i < steps; ++i) {
    Float s = near_length * (Float(i) + jitter.y);
    Float step_length = near_length;
    if (i >= short_steps) step_length = select(far, step_length, 0.0);
    if (i >= near_steps) {
      s = select(far, jetlag.near + far_length * (Float(i - near_steps) + jitter.y), s);
      step_length = select(far, far_length, step_length);
    }
    if (any(step_length > 0.0)) {
      Float at = gap + s * (2.0 * along + s);
      Vec3 p = o + view * s;
      Vec2 density = jetlag_density(jetlag, at);
      density.y = density.y + jetlag_cloud(jetlag, drift, noise, p, jetlag_height(jetlag, at));
      Vec2 q = density * step_length;
      Vec2 dims = depth + q * own;
      depth = depth + q;
      Vec2 sum = Vec2(0.0, 0.0);
      if (known > 0) sum = density;
      dims = dims + jetlag_light(jetlag, drift, noise, p, sun, at, sunward + s * toward, int(jetlag.light_steps), jitter.x, known, sum);
      Vec4 light = jetlag_through(jetlag, dims);
      molecules = molecules + light * q.x;
      haze = haze + light * q.y;
    }
  }
  return depth;
}

/// Light that the air adds to a ray of some length, and what it leaves of the light behind.
/// Jitter is x: of light steps, y: of view steps; 0 without.
FN_SHARED Vec4 jetlag_scatter(IN(Jetlag) jetlag, IN(JetlagDrift) drift, Table2 noise, Vec3 o, Vec3 view, Float length, Vec3 sun, Vec2 jitter, OUT(Vec4) transmittance) {
  Float gap = jetlag_gap(jetlag, o);
  Float along = dot(o, view) + jetlag.ground_radius * view.y;
  Float sunward = dot(o, sun) + jetlag.ground_radius * sun.y;
  Float apart = one_minus_cos(view, sun);
  // Without jitter the way to the Sun begins with the sample's own density, which is known.
  int known = 0;
  if (jetlag.jitter.x + jetlag.jitter.z <= 0.0) known = 1;
  Vec4 molecules = Vec4(0.0);
  Vec4 haze = Vec4(0.0);
  Vec2 depth = Vec2(0.0, 0.0);
  if (jetlag.clouds > 0.5) {
    depth = jetlag_march_cloud(jetlag, drift, noise, o, view, sun, gap, along, length, sunward, 1.0 - apart, jitter, known, molecules, haze);
  } else {
    depth = jetlag_march_clear(jetlag, gap, along, length, sunward, 1.0 - apart, jitter, known, molecules, haze);
  }
  transmittance = jetlag_through(jetlag, depth);
  return jetlag_scattered(jetlag, molecules, haze, apart);
}
