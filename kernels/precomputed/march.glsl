#pragma once
#include "core/radiance.glsl"
#include "precomputed/lattice.glsl"
// Light of all orders along a ray, from few points. A ray is cut into panels with three Gauss points each. They are thin where the air
// changes most and grow from there as sinh does, which suits a ray to the zenith, one along the ground and one past the limb alike;
// the edges of the planet's shadow are ends of panels.
//
// `layers`  the air over the distance to the horizon. Row 0: extinction, rows 1 to 4: scattering of the phase classes [1/m]. A lane finds its
//           own altitude in it, where `profile` wants all lanes in one zone.

/// A row of `profile` at an altitude [1/m].
/// @param row [1] in 0..4
FN Vec4 precomputed_profile(IN(Air) air, Table2 zones, Table2 profile, Float altitude, int row) {
  Vec4 found = Vec4(0.0);
  int count = int(air.zones);
  for (int i = 0; i < count; ++i) {
    Scalar4 zone = fetch_scalar(zones, i, 0);
    found = select(altitude >= zone.x, lookup_cell(profile, profile_cell(air, zone, altitude), row), found);
  }
  return found;
}

/// Place of a squared distance to the horizon, r^2 - R^2, in `layers` and in `sunlit` [1]. So places follow from a path along a ray without
/// its altitude, which would be one root and one division more.
/// @param squared [m^2] in 0..1e12
FN Float precomputed_level(IN(Air) air, Float squared) {
  return squared * inverse_root(max(squared, 1.0)) * (1.0 / sqrt(air.top_altitude * (2.0 * air.ground_radius + air.top_altitude)));
}
/// Altitude of such a place [m].
/// @param level [1] in 0..1
/// @bound 2e-5 scale 1e5
FN Float precomputed_level_altitude(IN(Air) air, Float level) {
  Float squared = level * level * (air.top_altitude * (2.0 * air.ground_radius + air.top_altitude));
  return min(squared / (air.ground_radius + sqrt(air.ground_radius * air.ground_radius + squared)), air.top_altitude);
}
/// Place of an altitude [1].
/// @param altitude [m] in 0..1e5
FN Float precomputed_layer(IN(Air) air, Float altitude) { return precomputed_level(air, max(radius_gap(air.ground_radius, altitude, Float(0.0)), 0.0)); }

/// The table `layers` [1/m].
FN Vec4 precomputed_layers_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Vec2 uv) {
  Float altitude = precomputed_level_altitude(air, from_half_texel(uv.x, size.width));
  Float row = floor(uv.y * size.height);
  Vec4 found = Vec4(0.0);
  int rows = 1 + int(air.classes);
  for (int i = 0; i < rows; ++i) found = select(abs(row - Float(i)) < 0.5, precomputed_profile(air, zones, profile, altitude, i), found);
  return found;
}

/// Zenith cosine of the Sun's centre where its upper limb appears behind the ground [1].
/// @param level [1] in 0..1
/// @param inverse_radius [1/m] in 1e-7..2e-7
/// @bound 2e-5 scale 1   a cosine
FN Float precomputed_sunrise(IN(Air) air, Float level, Float inverse_radius) {
  Scalar longest = sqrt(air.top_altitude * (2.0 * air.ground_radius + air.top_altitude));
  return -(level * (longest * (1.0 - 0.5 * air.sun_radius * air.sun_radius)) + air.ground_radius * air.sun_radius) * inverse_radius;
}
/// Sun's zenith cosine since its rise to place in the table `sunlit` [1].
/// @param risen [1] in 0..1
FN Float precomputed_sunlit_place(IN(Air) air, Float risen) {
  Scalar longest = sqrt(air.top_altitude * (2.0 * air.ground_radius + air.top_altitude));
  Float part = risen * (1.0 / (1.0 + air.sun_radius + longest / (air.ground_radius + air.top_altitude)));
  return part * inverse_root(max(part, 1.0e-12));
}
/// The table `sunlit`: -ln of sunlight, as `sunlight`, over the Sun's zenith cosine since its rise (u) and `layers`' places (v) [1]: with fewer
/// roots on the way to a texel.
FN Vec4 precomputed_sunlit_pass(IN(Air) air, IN(GridSize) size, Table2 optical_depth, Vec2 uv) {
  Float level = from_half_texel(uv.y, size.height);
  Float altitude = precomputed_level_altitude(air, level);
  Scalar longest = sqrt(air.top_altitude * (2.0 * air.ground_radius + air.top_altitude));
  Float part = from_half_texel(uv.x, size.width);
  Float risen = part * part * (1.0 + air.sun_radius + longest / (air.ground_radius + air.top_altitude));
  Float mu_s = min(precomputed_sunrise(air, level, 1.0 / (air.ground_radius + altitude)) + risen, 1.0);
  return disc_depth(air, optical_depth, altitude, upper_limb(air, mu_s));
}

/// Number whose hyperbolic sine is x [1].
/// @param x [1] in -1e4..1e4
/// @bound 2e-5 scale 1   it places panels, which may lie anywhere
FN Float precomputed_inverse_sinh(Float x) {
  Float size = ln(abs(x) + sqrt(x * x + 1.0));
  return select(x < 0.0, -size, size);
}

/// Hyperbolic sine [1].
/// @param x [1] in -20..20
/// @bound 2e-5 scale 1e8   as precomputed_inverse_sinh
FN Float precomputed_sinh(Float x) {
  Float size = exp(clamp(x, -40.0, 40.0));
  return 0.5 * (size - 1.0 / size);
}

/// How far from the edge of the planet's shadow the Sun shines on a ray with much light [m]: where it passes the ground at a twelfth of the air's
/// height. At the edge itself, as umbra_along has it, all its light is lost on the way. A ray along the sunlight may never come there: no further
/// than where it has climbed as much from its lowest point, above which there is less air to be seen.
/// @param at [1] in -1..1  as of meet_air
/// @param edge [m] in 0..1e5  path to the edge
/// @param onward [1] in -1..1  1: the light is behind the edge, -1: before it
/// @bound 1 scale 1e30   a place for panels, compared as part of the passes
FN Float precomputed_dawn(IN(Air) air, Vec4 at, Float edge, Float onward) {
  Scalar twelfth = 0.08 * air.top_altitude;
  Scalar height = twelfth + air.sun_radius * sqrt(2.0 * air.top_altitude * (air.ground_radius + air.top_altitude));
  Float radius = air.ground_radius + at.x;
  // The distance from the shadow's axis grows with a slope and a curvature, and so does altitude.
  Float slope = max(onward * (radius * (at.y - at.z * at.w) + edge * (1.0 - at.w) * (1.0 + at.w)) * (1.0 / air.ground_radius), 0.0);
  Float bend = max((1.0 - at.w) * (1.0 + at.w) - slope * slope, 0.0) * (2.0 * height / air.ground_radius);
  Float along = onward * (radius * at.y + edge);
  Float climb = max(along, 0.0) * (1.0 / air.ground_radius);
  Float lowest = max(-along, 0.0) + 2.0 * twelfth / (climb + sqrt(climb * climb + 2.0 * twelfth / air.ground_radius));
  return min(2.0 * height / max(slope + sqrt(slope * slope + bend), 1.0e-6), lowest);
}

/// How the panels of a piece of a ray lie: x: path [m] at which the air that is seen is densest, around which they crowd; y: how fast light and air
/// change there [m]; z: the first panel's begin as inverse_sinh((path - x) / y), w: what all panels stride in it. `at` as of meet_air; `dawn` and
/// `dusk`: the path [m] between which there is light to see; `crowd`: how much the panels do.
FN Vec4 precomputed_piece(IN(Air) air, Table2 layers, Vec4 at, Float begin, Float end, Float dawn, Float dusk, Float crowd) {
  Float along = (air.ground_radius + at.x) * at.y;
  Float centre = clamp(-along, dawn, dusk);
  Float altitude = max(altitude_along(air.ground_radius, at.x, at.y, centre), 0.0);
  Vec4 dense = lookup_row(layers, precomputed_layer(air, altitude), 0);
  Scalar higher = air.top_altitude * (1.0 / 64.0);
  Vec4 thin = lookup_row(layers, precomputed_layer(air, altitude + higher), 0);
  Vec4 ones = Vec4(0.25);
  Float extinction = dot(dense, ones);
  Float fall = clamp((1.0 - dot(thin, ones) / max(extinction, 1.0e-20)) * (1.0 / higher), 4.0 / air.top_altitude, 1.0 / higher);
  // A scale height is climbed on the slope, or by the ground's curvature; and air is gone through, if what lies before it lets one see it.
  Float slope = abs(along + centre) / (air.ground_radius + altitude) * fall;
  Float rate = slope + sqrt(fall * (0.5 / air.ground_radius));
  Float passed = extinction * min(centre - begin, 1.0 / rate);
  // What lies behind an optical depth of one is hardly seen: panels crowd before it.
  Float behind = ln(max(passed, 1.0));
  centre = max(centre - 2.0 * behind / (slope + sqrt(slope * slope + behind * fall * (2.0 / air.ground_radius)) + 1.0e-20), begin);
  // There the air is thinner: without another look, panels in haze would be far too long.
  if (any(passed > 1.0)) extinction = dot(lookup_row(layers, precomputed_layer(air, max(altitude_along(air.ground_radius, at.x, at.y, centre), 0.0)), 0), ones);
  rate = (rate + extinction * exp(-extinction * min(centre - begin, 1.0 / rate))) * crowd;
  Float scale = 1.0 / rate;
  Float first = precomputed_inverse_sinh((begin - centre) * rate);
  Float last = precomputed_inverse_sinh((end - centre) * rate);
  return Vec4(centre, scale, first, last - first);
}

/// The phase functions of an angle from the Sun [1/sr]; 0 of classes that the air has not got.
FN void precomputed_phases(IN(Air) air, Table2 phases, Float away, OUT(Vec4) phase0, OUT(Vec4) phase1, OUT(Vec4) phase2, OUT(Vec4) phase3) {
  Float x = sqrt(max(0.5 * away, 0.0));
  phase0 = lookup_row(phases, x, 0);
  phase1 = Vec4(0.0);
  phase2 = Vec4(0.0);
  phase3 = Vec4(0.0);
  if (air.classes > 1.5) phase1 = lookup_row(phases, x, 1);
  if (air.classes > 2.5) phase2 = lookup_row(phases, x, 2);
  if (air.classes > 3.5) phase3 = lookup_row(phases, x, 3);
}

/// A ray further along: `at` as of meet_air, at a path on.
/// @param at [1] in -1..1
/// @param path [m] in 0..1e5
/// @bound 2e-5 scale 1e5   as altitude_along
FN Vec4 precomputed_along(IN(Air) air, Vec4 at, Float path) {
  Float altitude = altitude_along(air.ground_radius, at.x, at.y, path);
  Float radius = air.ground_radius + at.x;
  Float from_centre = 1.0 / (air.ground_radius + altitude);
  Float mu = clamp((radius * at.y + path) * from_centre, -1.0, 1.0);
  Float mu_s = clamp((radius * at.z + path * at.w) * from_centre, -1.0, 1.0);
  return Vec4(altitude, mu, mu_s, at.w);
}

/// What the air at a path along a ray sends back along it, as precomputed_source_at.
FN Vec4 precomputed_sent(IN(Air) air, IN(Lattice) lattice, Table3 source, Vec4 at, Float path) {
  Vec4 there = precomputed_along(air, at, path);
  return precomputed_source_at(air, lattice, source, there.x, there.y, there.z, there.w);
}

/// How -ln of what the air sends changes with the Sun's zenith cosine, roughly [1]: slowly by day, a decade in two degrees after it has set.
/// @param mu_s [1] in -1..1
FN Float precomputed_dusk(Float mu_s) { return 3.0 * mu_s + 47.0 * min(mu_s, 0.03); }

/// What the ground sends back of light that has been scattered, per solar irradiance [1/sr]. `at` and `reach` are those of a ray that ends there.
FN Vec4 precomputed_ground(IN(Air) air, Table2 ground_light, Vec4 at, Float reach) {
  Float mu_s = ((air.ground_radius + at.x) * at.z + reach * at.w) * (1.0 / air.ground_radius);
  return exp(-lookup_row(ground_light, precomputed_sun_place(air, mu_s), 0)) * Vec4(air.albedo) * 0.318309886183791;
}

/// Panels of a ray, and those of them for a piece in the planet's shadow, where light of the first order is missing [1]: half, or, where
/// nothing but depth is asked of it, none.
/// @param panels [1] in 3..64
/// @param all [1] in 0..1  orders are asked for, not the first alone
/// @bound 1 scale 1   whole numbers
FN Vec2 precomputed_panels(Float panels, Bool all) { return Vec2(panels, select(all, floor(panels * 0.5), Float(0.0))); }

/// Optical depth between two places of a ray [1], from that to space: looking from the lower one where the ray goes down. `from`, `to`: as `at`
/// of meet_air.
FN Vec4 precomputed_depth_between(IN(Air) air, Table2 optical_depth, Vec4 from, Vec4 to) {
  Bool down = to.y < 0.0;
  Vec2 near = depth_uv(air, select(down, to.x, from.x), select(down, -to.y, from.y), width_of(optical_depth), height_of(optical_depth));
  Vec2 far = depth_uv(air, select(down, from.x, to.x), select(down, -from.y, to.y), width_of(optical_depth), height_of(optical_depth));
  return max(lookup(optical_depth, near) - lookup(optical_depth, far), 0.0);
}

/// Light that the air sends along a ray, per solar irradiance [1/sr]: the first order's; `again`: the others'; the optical depth of the path.
/// `at` is where the ray meets the air, as meet_air says; `orders` 1: the first alone, 2: the others alone (`first` is 0 then), 3: both;
/// `panels`: of the ray, and those of them that a piece in the planet's shadow gets: with none, its depth comes from `optical_depth`, which is
/// not read otherwise; `most`: the largest number of any ray; phase0 to 3: the phase functions towards the Sun.
FN_SHARED Vec4 precomputed_march(IN(Air) air, IN(Lattice) lattice, int orders, Vec2 panels, int most, Table2 layers, Table2 optical_depth, Table2 sunlit, Table3 source,
                                 Vec4 phase0, Vec4 phase1, Vec4 phase2, Vec4 phase3, Vec4 at, Float reach, OUT(Vec4) again, OUT(Vec4) depth) {
  Float radius = air.ground_radius + at.x;
  // A lit piece, one in the planet's shadow, and another lit one; those that a ray has not got are empty.
  Float dark = reach;
  Float light_again = reach;
  if (orders != 2) {
    umbra_along(air, at.x, at.y, at.z, at.w, dark, light_again);
    dark = clamp(dark, 0.0, reach);
    light_again = clamp(light_again, dark, reach);
  }
  Bool shaded = light_again > dark;
  dark = select(shaded, dark, reach);
  light_again = select(shaded, light_again, reach);
  Bool begins_lit = dark > 0.0;
  Bool ends_lit = light_again < reach;
  // Sunlight is looked up at all points of a panel and needs panels further away as well; what is sent, at their ends alone.
  Float crowd = select(panels.y > 0.5, Float(1.0), Float(0.5));
  Float dusk = dark;
  if (any(shaded)) dusk = select(shaded, max(dark - precomputed_dawn(air, at, dark, Float(-1.0)), 0.0), dark);
  Vec4 piece0 = precomputed_piece(air, layers, at, Float(0.0), dark, Float(0.0), dusk, crowd);
  Vec4 piece1 = piece0;
  Vec4 piece2 = piece0;
  if (any(shaded)) {
    Float dawn = min(light_again + precomputed_dawn(air, at, light_again, Float(1.0)), reach);
    piece1 = precomputed_piece(air, layers, at, dark, light_again, dark, light_again, crowd);
    piece2 = precomputed_piece(air, layers, at, light_again, reach, dawn, reach, crowd);
  }
  // Two lit pieces share panels as their strides are: where the shadow is but touched, one may be next to nothing.
  Float lit = select(shaded, panels.x - panels.y, panels.x);
  Float share = clamp(floor(lit * (0.25 + 0.5 * piece0.w / max(piece0.w + piece2.w, 1.0e-6)) + 0.5), 1.0, lit - 1.0);
  Float lit_first = select(begins_lit, select(ends_lit, share, lit), Float(0.0));
  Float lit_last = panels.x - select(ends_lit, lit - lit_first, Float(0.0));
  piece0.w = piece0.w / max(lit_first, 1.0);
  piece1.w = piece1.w / max(lit_last - lit_first, 1.0);
  piece2.w = piece2.w / max(panels.x - lit_last, 1.0);
  Bool skips = shaded && (panels.y < 0.5) && (begins_lit || ends_lit);
  Vec4 skipped = Vec4(0.0);
  if (any(skips)) skipped = select(skips, precomputed_depth_between(air, optical_depth, precomputed_along(air, at, dark), precomputed_along(air, at, light_again)), skipped);

  Vec4 first = Vec4(0.0);
  again = Vec4(0.0);
  depth = Vec4(0.0);
  Float start = radius_gap(air.ground_radius, at.x, Float(0.0));
  Float twice_along = 2.0 * radius * at.y;
  Float end = Float(0.0);
  Float layer_end = Float(0.0);
  Float dusk_end = Float(0.0);
  Vec4 sent_end = Vec4(0.0);
  if (orders > 1) {
    layer_end = precomputed_layer(air, at.x);
    dusk_end = precomputed_dusk(at.z);
    sent_end = precomputed_sent(air, lattice, source, at, end);
  }
  for (int i = 0; i < most; ++i) {
    Bool before = Float(i) < lit_first - 0.5;
    Bool behind = Float(i) > lit_last - 0.5;
    Vec4 piece = select(before, piece0, select(behind, piece2, piece1));
    Float piece_end = select(before, dark, select(behind, reach, light_again));
    Float place = Float(i) - select(before, Float(0.0), select(behind, lit_last, lit_first));
    Float to_go = select(before, lit_first, select(behind, panels.x, lit_last)) - (Float(i) + 1.0);
    Bool over = skips && behind && (place < 0.5);
    // Panels that others' rays have more of pass over a ray's own end, too: its depth is added once, below.
    depth = depth + select(over && ends_lit, skipped, Vec4(0.0));
    Float begin = select(over, light_again, end);
    end = clamp(piece.x + piece.y * precomputed_sinh(piece.z + piece.w * (place + 1.0)), begin, piece_end);
    end = select(to_go < 0.5, piece_end, end);
    Float stride = end - begin;
    // Three-point Gauss, and the depth up to each point by the matching collocation (Butcher 1964): order 6.
    Float path0 = begin + 0.112701665379258 * stride;
    Float path1 = begin + 0.5 * stride;
    Float path2 = begin + 0.887298334620742 * stride;
    Float squared0 = max(start + path0 * (twice_along + path0), 0.0);
    Float squared1 = max(start + path1 * (twice_along + path1), 0.0);
    Float squared2 = max(start + path2 * (twice_along + path2), 0.0);
    Float level0 = precomputed_level(air, squared0);
    Float level1 = precomputed_level(air, squared1);
    Float level2 = precomputed_level(air, squared2);
    Vec4 extinction0 = Vec4(0.0);
    Vec4 extinction1 = Vec4(0.0);
    Vec4 extinction2 = Vec4(0.0);
    Vec4 scattering00 = Vec4(0.0);
    Vec4 scattering01 = Vec4(0.0);
    Vec4 scattering02 = Vec4(0.0);
    Vec4 scattering10 = Vec4(0.0);
    Vec4 scattering11 = Vec4(0.0);
    Vec4 scattering12 = Vec4(0.0);
    lookup_rows(layers, level0, 0, extinction0, scattering00, scattering10);
    lookup_rows(layers, level1, 0, extinction1, scattering01, scattering11);
    lookup_rows(layers, level2, 0, extinction2, scattering02, scattering12);
    extinction0 = extinction0 * stride;
    extinction1 = extinction1 * stride;
    extinction2 = extinction2 * stride;
    Vec4 sent_begin = sent_end;
    Float layer_begin = layer_end;
    Float dusk_begin = dusk_end;
    Float climb = Float(0.0);
    Float turn = Float(0.0);
    if (orders > 1) {
      sent_end = precomputed_sent(air, lattice, source, at, end);
      Float altitude_end = altitude_along(air.ground_radius, at.x, at.y, end);
      layer_end = precomputed_layer(air, altitude_end);
      dusk_end = precomputed_dusk((radius * at.z + end * at.w) / (air.ground_radius + altitude_end));
      climb = 4.0 * (layer_end - layer_begin);
      turn = abs(dusk_end - dusk_begin);
    }
    for (int node = 0; node < 3; ++node) {
      Float weight = Float(0.277777777777778);
      Float path = path0;
      Float squared = squared0;
      Float level = level0;
      Vec4 scattering = scattering00;
      Vec4 more = scattering10;
      Vec4 passed = 0.138888888888889 * extinction0 - 0.0359766675249389 * extinction1 + 0.00978944401530832 * extinction2;
      if (node == 1) {
        weight = Float(0.444444444444444);
        path = path1;
        squared = squared1;
        level = level1;
        scattering = scattering01;
        more = scattering11;
        passed = 0.300263194980865 * extinction0 + 0.222222222222222 * extinction1 - 0.0224854172030869 * extinction2;
      }
      if (node == 2) {
        path = path2;
        squared = squared2;
        level = level2;
        scattering = scattering02;
        more = scattering12;
        passed = 0.267988333762469 * extinction0 + 0.480421111969383 * extinction1 + 0.138888888888889 * extinction2;
      }
      passed = depth + max(passed, 0.0);
      Vec4 towards = scattering * phase0 + more * phase1;
      scattering = scattering + more;
      if (air.classes > 2.5) {
        more = lookup_row(layers, level, 3);
        scattering = scattering + more;
        towards = towards + more * phase2;
      }
      if (air.classes > 3.5) {
        more = lookup_row(layers, level, 4);
        scattering = scattering + more;
        towards = towards + more * phase3;
      }
      Float inverse_radius = inverse_root(air.ground_radius * air.ground_radius + squared);
      Float mu_s = (radius * at.z + path * at.w) * inverse_radius;
      if (orders != 2) {
        Float risen = mu_s - precomputed_sunrise(air, level, inverse_radius);
        Vec2 place = Vec2(half_texel(precomputed_sunlit_place(air, risen), width_of(sunlit)), half_texel(level, height_of(sunlit)));
        first = first + select(risen > 0.0, towards * exp(-(passed + lookup(sunlit, place))) * (weight * stride), Vec4(0.0));
      }
      if (orders > 1) {
        // Between a panel's ends -ln of what is sent goes as altitude and the Sun do.
        Float climbing = select(climb < 0.0, Float(-4.0), Float(4.0));
        Float between = (clamp((level - layer_begin) * climbing, 0.0, abs(climb)) + min(abs(precomputed_dusk(mu_s) - dusk_begin), turn) + 1.0e-3 * (path - begin) / max(stride, 1.0e-3)) / (abs(climb) + turn + 1.0e-3);
        again = again + scattering * exp(-(passed + mix(sent_begin, sent_end, between))) * (weight * stride);
      }
    }
    depth = depth + 0.277777777777778 * (extinction0 + extinction2) + 0.444444444444444 * extinction1;
  }
  depth = depth + select(ends_lit, Vec4(0.0), skipped);
  return first;
}
