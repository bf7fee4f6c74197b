#pragma once
#include "precomputed/orders.glsl"
// What is seen along whole rays, to space or to the ground: over altitudes, directions, Suns and azimuths.
//
// `seen`         -ln of the mean over a ray's path of what the air adds to it, per solar irradiance [1/(m sr)]: of all orders but the
//                first, or, where nothing is marched, of all but that part of the first which `seen_peak` holds.
// `seen_peak`    where nothing is marched: the same of the phase class with the sharpest peak, in light of the first order, without its
//                phase function [1/m].
//                Columns: Suns, as in `source`; rows: directions, a band for each altitude; slices: half the azimuth from the Sun, by its sine.
// A mean hardly changes where a path becomes long or short, and -ln of it is as good at night as at noon. The directions of a band are
// three sets that share no cell: up; down, but past the limb; to the ground. So the horizon of each altitude is an edge between tables.

struct Sight {
  Scalar marched;    // [1] in 0..1    1: light of the first order is marched along each ray; 0: it comes from these tables, too
  Scalar suns;       // [1] in 2..96
  Scalar altitudes;  // [1] in 2..64
  Scalar ups;        // [1] in 2..64   directions up, by their path to the top
  Scalar limbs;      // [1] in 2..64   directions past the limb, by their sine
  Scalar grounds;    // [1] in 2..64   directions to the ground, by altitude over distance
  Scalar azimuths;   // [1] in 2..64
  Scalar pad;        // [1] in 0..1
};

/// How low a ray that looks down past the limb comes [1]: altitude of its lowest point over the altitude where it begins, nearly.
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..0
/// @bound 1 scale 1   a difference of two squares that are alike at the limb: compared as part of the passes
FN Float precomputed_seen_low(IN(Air) air, Float altitude, Float mu) {
  Float radius = air.ground_radius + altitude;
  Float gap = max(radius_gap(air.ground_radius, altitude, Float(0.0)), 1.0);
  return clamp((gap - radius * radius * mu * mu) / gap, 0.0, 1.0);
}
/// Row of such a ray within a band [1]: by 1 - x of the sine x = -mu r / sqrt(r^2 - R^2), which grows from 0 along the horizontal to 1 at the limb.
/// @param low [1] in 0..1
FN Float precomputed_seen_limb_row(IN(Sight) sight, Float low) {
  return sqrt(low / (1.0 + sqrt(1.0 - low))) * (sight.limbs - 1.0) + sight.ups;
}
/// Row of a direction up, or to the ground, within the band of an altitude [1]. Rows crowd at the horizon and at the zenith.
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..1
/// @param hits [1] in 0..1  the ground
/// @bound 1 scale 1e30   at the horizon engines may choose either set: compared as part of the passes
FN Float precomputed_seen_row(IN(Air) air, IN(Sight) sight, Float altitude, Float mu, Bool hits) {
  Float radius = air.ground_radius + altitude;
  Float ahead = max(air.top_altitude - altitude, 0.0);
  Float gap_above = max(radius_gap(air.ground_radius, Float(air.top_altitude), altitude), 0.0);
  // The path to the top beyond the shortest, without a difference of the two, which are alike about the zenith.
  Float b = radius * max(mu, 0.0);
  Float s = sqrt(b * b + gap_above);
  Float longer = ahead * radius * (1.0 - mu) * (1.0 + radius * (1.0 + mu) / (air.ground_radius + air.top_altitude + s)) / (b + s);
  Float up = longer / max(sqrt(gap_above) - ahead, 1.0e-3);
  // Of a short way down altitude over distance is the cosine; it stays so where there is no altitude.
  Float steep = select(altitude < 0.01, -mu, altitude / max(distance_to_ground(air.ground_radius, altitude, mu), 0.01));
  Float grazing = sqrt(altitude / (2.0 * air.ground_radius + altitude));
  Float down = (steep - grazing) / max(1.0 - grazing, 1.0e-3);
  up = clamp(up, 0.0, 1.0);
  down = clamp(down, 0.0, 1.0);
  Float above = sqrt(up / (2.0 - up)) * (sight.ups - 1.0);
  Float below = (1.0 - sqrt(0.04 * (1.0 - down) / (down + 0.04))) * (sight.grounds - 1.0) + (sight.ups + sight.limbs);
  return select(hits, below, above);
}
/// Its inverse: the zenith cosine of a row of a band [1], and the path of its ray.
/// @param altitude [m] in 0..1e5
/// @param row [1] in 0..10
/// @param reach [m]  at least 1
/// @bound 1 scale 1e30   as precomputed_seen_row
FN Float precomputed_seen_mu(IN(Air) air, IN(Sight) sight, Float altitude, Float row, OUT(Float) reach) {
  Float radius = air.ground_radius + altitude;
  Float gap_below = max(radius_gap(air.ground_radius, altitude, Float(0.0)), 0.0);
  Float gap_above = max(radius_gap(air.ground_radius, Float(air.top_altitude), altitude), 0.0);
  Float ahead = max(air.top_altitude - altitude, 0.0);
  Bool past = row > sight.ups - 0.5;
  Bool hits = row > sight.ups + sight.limbs - 0.5;
  Float part = select(hits, (row - sight.ups - sight.limbs) * (1.0 / (sight.grounds - 1.0)), select(past, (row - sight.ups) * (1.0 / (sight.limbs - 1.0)), row * (1.0 / (sight.ups - 1.0))));
  part = clamp(part, 0.0, 1.0);
  part = select(hits, 0.04 * part * (2.0 - part) / (1.04 - part * (2.0 - part)), part * part);
  Float path = max(mix(ahead, sqrt(gap_above), 2.0 * part / (1.0 + part)), 1.0);
  // Straight up and straight down are exact: an angle whose cosine is off by the last bit is off by 0.03 degrees.
  Float up = select(part > 0.0, clamp((gap_above - path * path) / (2.0 * radius * path), 0.0, 1.0), Float(1.0));
  Float limb = (part - 1.0) * sqrt(gap_below) / radius;
  Float grazing = sqrt(altitude / (2.0 * air.ground_radius + altitude));
  Float steep = max(mix(grazing, Float(1.0), part), 1.0e-6);
  Float down = select(steep < 1.0, -(steep * (2.0 * air.ground_radius + altitude) + altitude / steep) / (2.0 * radius), Float(-1.0));
  Float horizon = mu_horizon(air.ground_radius, altitude);
  Float mu = select(hits, clamp(down, -1.0, horizon), select(past, max(limb, horizon), up));
  reach = max(select(hits, altitude / steep, distance_to_shell(air.ground_radius, altitude, Float(air.top_altitude), mu)), 1.0);
  return mu;
}

/// A ray of the tables: where it begins, as meet_air says, its path, and how far it looks away from the Sun.
/// @param uvw [1] in 0..1
/// @param hits [1] in 0..1  the ground
/// @param reach [m]
/// @param away [1]  one minus the cosine of the angle between ray and Sun
/// @bound 1 scale 1e30   as precomputed_seen_row
FN Vec4 precomputed_seen_ray(IN(Air) air, IN(Sight) sight, Vec3 uvw, OUT(Bool) hits, OUT(Float) reach, OUT(Float) away) {
  Scalar rows = sight.ups + sight.limbs + sight.grounds;
  Float row = floor(uvw.y * rows * sight.altitudes);
  Float band = floor((row + 0.5) * (1.0 / rows));
  Float altitude = precomputed_level_altitude(air, band * (1.0 / (sight.altitudes - 1.0)));
  hits = row - band * rows > sight.ups + sight.limbs - 0.5;
  Float mu = precomputed_seen_mu(air, sight, altitude, row - band * rows, reach);
  Float mu_s = precomputed_sun(air, from_half_texel(uvw.x, sight.suns));
  Float half_sine = from_half_texel(uvw.z, sight.azimuths);
  Float cosine = 1.0 - 2.0 * half_sine * half_sine;
  Float across = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
  away = one_minus_cos(Vec3(across * cosine, across * sqrt(max((1.0 - cosine) * (1.0 + cosine), 0.0)), mu), precomputed_sun_direction(mu_s));
  return Vec4(altitude, mu, mu_s, 1.0 - away);
}

/// Which phase class has the sharpest peak.
FN int precomputed_sharpest(IN(Air) air, Table2 phases) {
  int sharpest = 0;
  Scalar peak = fetch_scalar(phases, 0, 0).x;
  int classes = int(air.classes);
  for (int i = 1; i < classes; ++i) {
    Scalar other = fetch_scalar(phases, 0, i).x;
    if (other > peak) {
      sharpest = i;
      peak = other;
    }
  }
  return sharpest;
}

/// Mean transmittance of a path in even air, (1 - exp(-depth)) / depth, nearly: a fraction that is alike to the second order at 0 and goes as
/// 1 / depth. What the air adds to a ray is the sum of its source times this, so that the tables need only know what is not even about it: how
/// nearly is of no matter, as what is kept has been divided by this and is multiplied by it again.
/// @param depth [1] in 0..100
FN Vec4 precomputed_mean_transmittance(Vec4 depth) { return (depth + 6.0) / (depth * (depth + 4.0) + 6.0); }

/// The table `seen`.
FN Vec4 precomputed_seen_pass(IN(Air) air, IN(Lattice) lattice, IN(Sight) sight, Table2 phases, Table2 layers, Table2 optical_depth, Table2 sunlit, Table3 source, Vec3 uvw) {
  Float reach = Float(0.0);
  Float away = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = precomputed_seen_ray(air, sight, uvw, hits, reach, away);
  Vec4 phase0 = Vec4(0.0);
  Vec4 phase1 = Vec4(0.0);
  Vec4 phase2 = Vec4(0.0);
  Vec4 phase3 = Vec4(0.0);
  precomputed_phases(air, phases, away, phase0, phase1, phase2, phase3);
  int sharpest = precomputed_sharpest(air, phases);
  if (sharpest == 0) phase0 = Vec4(0.0);
  if (sharpest == 1) phase1 = Vec4(0.0);
  if (sharpest == 2) phase2 = Vec4(0.0);
  if (sharpest == 3) phase3 = Vec4(0.0);
  Vec4 again = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  int orders = 2;
  if (sight.marched < 0.5) orders = 3;
  Vec4 first = precomputed_march(air, lattice, orders, Vec2(Float(24.0), Float(12.0)), 24, layers, optical_depth, sunlit, source, phase0, phase1, phase2, phase3, at, reach, again, depth);
  return -ln4(max((first + again) / (select(hits, precomputed_mean_transmittance(depth), Vec4(1.0)) * reach), 1.0e-30));
}
/// The table `seen_peak`.
FN Vec4 precomputed_seen_peak_pass(IN(Air) air, IN(Lattice) lattice, IN(Sight) sight, Table2 phases, Table2 layers, Table2 optical_depth, Table2 sunlit, Table3 source, Vec3 uvw) {
  Float reach = Float(0.0);
  Float away = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = precomputed_seen_ray(air, sight, uvw, hits, reach, away);
  int sharpest = precomputed_sharpest(air, phases);
  Vec4 phase0 = Vec4(0.0);
  Vec4 phase1 = Vec4(0.0);
  Vec4 phase2 = Vec4(0.0);
  Vec4 phase3 = Vec4(0.0);
  if (sharpest == 0) phase0 = Vec4(1.0);
  if (sharpest == 1) phase1 = Vec4(1.0);
  if (sharpest == 2) phase2 = Vec4(1.0);
  if (sharpest == 3) phase3 = Vec4(1.0);
  Vec4 again = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  Vec4 first = precomputed_march(air, lattice, 1, Vec2(Float(16.0), Float(0.0)), 16, layers, optical_depth, sunlit, source, phase0, phase1, phase2, phase3, at, reach, again, depth);
  return -ln4(max(first / (select(hits, precomputed_mean_transmittance(depth), Vec4(1.0)) * reach), 1.0e-30));
}

/// A whole ray's place in these tables, between two bands; how far it is from the lower to the upper; how much of what `upper` differs by from
/// its horizontal ray comes on top [1]. `at` as of meet_air.
/// @param at [1] in -1..1
/// @param hits [1] in 0..1  the ground
/// @param lower [1]
/// @param upper [1]
/// @bound 1 scale 1e30   as precomputed_seen_row
FN Vec2 precomputed_seen_place(IN(Air) air, IN(Sight) sight, Vec4 at, Bool hits, OUT(Vec3) lower, OUT(Vec3) upper) {
  Scalar rows = sight.ups + sight.limbs + sight.grounds;
  Scalar v = 1.0 / (rows * sight.altitudes);
  Float row = precomputed_seen_row(air, sight, at.x, at.y, hits);
  Float height = precomputed_layer(air, at.x) * (sight.altitudes - 1.0);
  Float band = min(floor(height), sight.altitudes - 2.0);
  Float next = band + 1.0;
  Float across = sqrt(max((1.0 - at.y) * (1.0 + at.y), 0.0)) * sqrt(max((1.0 - at.z) * (1.0 + at.z), 0.0));
  Float cosine = (at.w - at.y * at.z) / max(across, 1.0e-6);
  Float half_sine = sqrt(clamp(0.5 - 0.5 * cosine, 0.0, 1.0));
  lower = Vec3(half_texel(precomputed_sun_place(air, at.z), sight.suns), (band * rows + row + 0.5) * v, half_texel(half_sine, sight.azimuths));
  upper = Vec3(lower.x, lower.y + rows * v, lower.z);
  // Between two bands light goes as altitude does; along the way to the ground as that way.
  Float part = height - band;
  Float higher = select(hits, part, part * (height + band) / (next + band));
  Bool past = at.y < 0.0 && !hits;
  Float more = Float(0.0);
  if (any(past)) {
    // Past the limb it depends on the lowest point, which therefore stays where it is from band to band, but that horizontal rays stay
    // horizontal. What one sees there differs from the horizontal ray's light by the way down to that point and up again, which goes as the
    // height (the root of an altitude) times x: what straight lines between the bands miss of it comes on top.
    Float low = precomputed_seen_low(air, at.x, at.y);
    Float low_below = min(height * height * low / max(mix(band * band, height * height, low), 1.0e-6), 1.0);
    Float low_above = min(height * height * low / max(mix(next * next, height * height, low), 1.0e-6), 1.0);
    Float way_above = next * sqrt(1.0 - low_above);
    Float way = height * sqrt(1.0 - low) - (1.0 - higher) * band * sqrt(1.0 - low_below) - higher * way_above;
    more = select(past, max(way, 0.0) / max(way_above, 1.0e-6), more);
    lower.y = select(past, (band * rows + precomputed_seen_limb_row(sight, low_below) + 0.5) * v, lower.y);
    upper.y = select(past, (next * rows + precomputed_seen_limb_row(sight, low_above) + 0.5) * v, upper.y);
  }
  return Vec2(higher, more);
}

/// What one of these tables holds there, per path. What it has not been told is darkness.
FN Vec4 precomputed_seen_light(IN(Sight) sight, Table3 seen, Vec3 lower, Vec3 upper, Vec2 higher) {
  Vec4 above = lookup(seen, upper);
  Vec4 found = mix(lookup(seen, lower), above, higher.x);
  if (any(higher.y > 0.0)) {
    // A band's last row past the limb is its horizontal ray.
    Float band = floor(upper.y * sight.altitudes);
    Float row = band + (sight.ups + sight.limbs - 0.5) * (1.0 / (sight.ups + sight.limbs + sight.grounds));
    found = found + (above - lookup(seen, Vec3(upper.x, row * (1.0 / sight.altitudes), upper.z))) * higher.y;
  }
  return max(exp(-found) - Vec4(2.0e-30), 0.0);
}

/// What these tables tell of a whole ray, per solar irradiance [1/sr]: all that is not marched. `at` as of meet_air; `phase` of the class with
/// the sharpest peak.
FN Vec4 precomputed_seen(IN(Air) air, IN(Sight) sight, Table3 seen, Table3 seen_peak, Vec4 phase, Vec4 at, Bool hits, Float path, Vec4 depth) {
  Vec3 lower = Vec3(Float(0.0), Float(0.0), Float(0.0));
  Vec3 upper = lower;
  Vec2 higher = precomputed_seen_place(air, sight, at, hits, lower, upper);
  Vec4 light = precomputed_seen_light(sight, seen, lower, upper, higher);
  if (sight.marched < 0.5) light = light + precomputed_seen_light(sight, seen_peak, lower, upper, higher) * phase;
  return light * select(hits, precomputed_mean_transmittance(depth), Vec4(1.0)) * path;
}

/// Light of a ray's segment, so that it and the rest of the ray are the whole: what marching the segment and looking up the rest differ by from
/// looking up the whole is taken from the segment, all but (1 - share)^8 of it: nearly all where the segment is a third of what is seen, eight
/// times its own share where it is little.
/// @param marched [1/sr] in 0..1
/// @param rest [1/sr] in 0..1  attenuated
/// @param whole [1/sr] in 0..2
FN Vec4 precomputed_segment(Vec4 marched, Vec4 rest, Vec4 whole) {
  Vec4 sum = max(marched + rest, 1.0e-30);
  Vec4 others = 1.0 - min(marched / sum, 1.0);
  Vec4 twice = others * others;
  Vec4 much = (1.0 + others) * (1.0 + twice) * (1.0 + twice * twice);  // (1 - others^8) / (1 - others)
  // Both know the light to a few percent; where they differ by more there is next to none. A segment stays positive.
  return marched * (1.0 + much * (clamp(whole / sum, 0.88, 1.12) - 1.0));
}

/// What a view ray brings, all orders of scattering, per solar irradiance [1/sr]: the air's part; light reflected by the ground where the
/// ray meets it, already attenuated. A ray that ends in the air is marched through the lattice.
FN_SHARED Vec4 precomputed_ray_light(IN(Air) air, IN(Lattice) lattice, IN(Sight) sight, Scalar panels, Table2 phases, Table2 layers, Table2 sunlit, Table2 sunlight, Table2 optical_depth, Table3 source,
                                     Table2 ground_light, Table3 seen, Table3 seen_peak, Float altitude, Vec3 view, Vec3 sun, Float distance, OUT(Vec4) ground) {
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, sun, distance, reach, whole, hits);
  Float away = one_minus_cos(view, sun);
  Bool down = at.y < mu_horizon(air.ground_radius, at.x);
  Vec4 peak = Vec4(0.0);
  if (sight.marched < 0.5) peak = lookup_row(phases, sqrt(max(0.5 * away, 0.0)), precomputed_sharpest(air, phases));
  Vec4 light = Vec4(0.0);
  Vec4 depth = Vec4(0.0);
  Vec4 marched = Vec4(0.0);
  Vec4 ahead = Vec4(0.0);
  Bool ends = reach < whole;
  // What is marched knows its depth better than the table does, which is asked for what lies ahead of it alone.
  Vec4 from = at;
  if (any(ends)) from = select(ends, precomputed_along(air, at, reach), at);
  if (sight.marched < 0.5 || any(ends)) ahead = precomputed_depth_between(air, optical_depth, from, precomputed_along(air, at, whole));
  if (sight.marched > 0.5 || any(ends)) {
    // The source is looked up at the ends of panels alone: it wants more of them than sunlight does.
    int orders = 1;
    int most = int(panels);
    if (any(ends)) {
      orders = 3;
      most = 2 * most;
    }
    Vec4 phase0 = Vec4(0.0);
    Vec4 phase1 = Vec4(0.0);
    Vec4 phase2 = Vec4(0.0);
    Vec4 phase3 = Vec4(0.0);
    precomputed_phases(air, phases, away, phase0, phase1, phase2, phase3);
    light = precomputed_march(air, lattice, orders, precomputed_panels(select(ends, Float(2.0 * panels), Float(panels)), ends), most, layers, optical_depth, sunlit, source, phase0, phase1, phase2, phase3, at, reach, marched, depth);
    if (sight.marched < 0.5) {
      marched = marched + light;
      light = Vec4(0.0);
    }
  }
  Vec4 whole_depth = select(ends, depth + ahead, depth);
  if (sight.marched < 0.5) whole_depth = select(ends, whole_depth, ahead);
  Vec4 again = precomputed_seen(air, sight, seen, seen_peak, peak, at, down, whole, whole_depth);
  if (any(ends)) {
    Vec4 rest = precomputed_seen(air, sight, seen, seen_peak, peak, from, down, max(whole - reach, 0.0), ahead) * exp(-depth);
    again = select(ends, precomputed_segment(marched, rest, again), again);
  }
  ground = Vec4(0.0);
  if (any(hits)) {
    Vec4 reflected = ground_radiance(air, sunlight, sunlight, 1, at, reach) + precomputed_ground(air, ground_light, at, reach);
    ground = select(hits, reflected * exp(-whole_depth), Vec4(0.0));
  }
  return light + again;
}
