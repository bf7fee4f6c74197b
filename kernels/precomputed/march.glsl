#pragma once
#include "core/radiance.glsl"
#include "precomputed/lattice.glsl"
// Light of all orders along a ray, from few points. A ray is cut into panels with three Gauss points each. They are thin where the air
// changes most and grow from there as sinh does, which suits a ray to the zenith, one along the ground and one past the limb alike;
// the edges of the planet's shadow are ends of panels.
//
// `layers`  the air over sqrt(altitude / top). Row 0: extinction, rows 1 to 4: scattering of the phase classes [1/m]. A lane finds its
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

/// The table `layers` [1/m].
FN Vec4 precomputed_layers_pass(IN(Air) air, IN(GridSize) size, Table2 zones, Table2 profile, Vec2 uv) {
  Float u = from_half_texel(uv.x, size.width);
  Float row = floor(uv.y * size.height);
  Vec4 found = Vec4(0.0);
  int rows = 1 + int(air.classes);
  for (int i = 0; i < rows; ++i) found = select(abs(row - Float(i)) < 0.5, precomputed_profile(air, zones, profile, u * u * air.top_altitude, i), found);
  return found;
}

/// Place of an altitude in `layers` [1].
/// @param altitude [m] in 0..1e5
FN Float precomputed_layer(IN(Air) air, Float altitude) { return sqrt(clamp(altitude * (1.0 / air.top_altitude), 0.0, 1.0)); }

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

/// How the panels of a piece of a ray lie: x: path [m] at which the air is densest, around which they crowd; y: how fast light and air
/// change there [m]; z: the first panel's begin as inverse_sinh((path - x) / y), w: the panels' stride in it. `at` as of meet_air.
FN Vec4 precomputed_piece(IN(Air) air, Table2 layers, Vec4 at, Float begin, Float end, Float panels) {
  Float along = (air.ground_radius + at.x) * at.y;
  Float centre = clamp(-along, begin, end);
  Float altitude = max(altitude_along(air.ground_radius, at.x, at.y, centre), 0.0);
  Vec4 dense = lookup_row(layers, precomputed_layer(air, altitude), 0);
  Scalar higher = air.top_altitude * (1.0 / 64.0);
  Vec4 thin = lookup_row(layers, precomputed_layer(air, altitude + higher), 0);
  Vec4 ones = Vec4(0.25);
  Float extinction = dot(dense, ones);
  Float fall = clamp((1.0 - dot(thin, ones) / max(extinction, 1.0e-20)) * (1.0 / higher), 4.0 / air.top_altitude, 1.0 / higher);
  // A scale height is climbed on the slope, or by the ground's curvature; and air is gone through, if what lies before it lets one see it.
  Float rate = abs(along + centre) / (air.ground_radius + altitude) * fall + sqrt(fall * (0.5 / air.ground_radius));
  rate = rate + extinction * exp(-extinction * min(centre - begin, 1.0 / rate));
  Float scale = 1.0 / rate;
  Float first = precomputed_inverse_sinh((begin - centre) * rate);
  Float last = precomputed_inverse_sinh((end - centre) * rate);
  return Vec4(centre, scale, first, (last - first) / max(panels, 1.0));
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

/// What the air at a path along a ray sends back along it, as precomputed_source_at.
FN Vec4 precomputed_sent(IN(Air) air, IN(Lattice) lattice, Table3 source, Vec4 at, Float path) {
  Float altitude = altitude_along(air.ground_radius, at.x, at.y, path);
  Float radius = air.ground_radius + at.x;
  Float from_centre = 1.0 / (air.ground_radius + altitude);
  Float mu = clamp((radius * at.y + path) * from_centre, -1.0, 1.0);
  Float mu_s = clamp((radius * at.z + path * at.w) * from_centre, -1.0, 1.0);
  return precomputed_source_at(air, lattice, source, altitude, mu, mu_s, at.w);
}

/// How -ln of what the air sends changes with the Sun's zenith cosine, roughly [1]: slowly by day, a decade in two degrees after it has set.
/// @param mu_s [1] in -1..1
FN Float precomputed_dusk(Float mu_s) { return 3.0 * mu_s + 47.0 * min(mu_s, 0.03); }

/// What the ground sends back of light that has been scattered, per solar irradiance [1/sr]. `at` and `reach` are those of a ray that ends there.
FN Vec4 precomputed_ground(IN(Air) air, Table2 ground_light, Vec4 at, Float reach) {
  Float mu_s = ((air.ground_radius + at.x) * at.z + reach * at.w) * (1.0 / air.ground_radius);
  return exp(-lookup_row(ground_light, precomputed_sun_place(mu_s), 0)) * Vec4(air.albedo) * 0.318309886183791;
}

/// Light that the air sends along a ray, per solar irradiance [1/sr]; the optical depth of the path. `at` is where the ray meets the air,
/// as meet_air says; `first` 1: with light of the first order, 0: without; phase0 to 3: the phase functions towards the Sun.
FN_SHARED Vec4 precomputed_march(IN(Air) air, IN(Lattice) lattice, int first, Scalar panels, Table2 layers, Table2 sunlight, Table3 source,
                                 Vec4 phase0, Vec4 phase1, Vec4 phase2, Vec4 phase3, Vec4 at, Float reach, OUT(Vec4) depth) {
  Float radius = air.ground_radius + at.x;
  // A lit piece, one in the planet's shadow, and another lit one; those that a ray has not got are empty.
  Float dark = reach;
  Float light_again = reach;
  if (first > 0) {
    umbra_along(air, at.x, at.y, at.z, at.w, dark, light_again);
    dark = clamp(dark, 0.0, reach);
    light_again = clamp(light_again, dark, reach);
  }
  Bool shaded = light_again > dark;
  dark = select(shaded, dark, reach);
  light_again = select(shaded, light_again, reach);
  Bool begins_lit = dark > 0.0;
  Bool ends_lit = light_again < reach;
  // Of the panels a third for the shadow, where light of the first order is missing; the rest for the lit pieces.
  Float third = floor(Float(panels) * 0.333334);
  Float lit = select(shaded, panels - third, Float(panels));
  Float lit_first = select(begins_lit, select(ends_lit, floor(0.5 * lit), lit), Float(0.0));
  Float lit_last = panels - select(ends_lit, lit - lit_first, Float(0.0));
  Vec4 piece0 = precomputed_piece(air, layers, at, Float(0.0), dark, lit_first);
  Vec4 piece1 = piece0;
  Vec4 piece2 = piece0;
  if (any(shaded)) {
    piece1 = precomputed_piece(air, layers, at, dark, light_again, lit_last - lit_first);
    piece2 = precomputed_piece(air, layers, at, light_again, reach, panels - lit_last);
  }

  Vec4 light = Vec4(0.0);
  depth = Vec4(0.0);
  Float end = Float(0.0);
  Float layer_end = precomputed_layer(air, at.x);
  Float dusk_end = precomputed_dusk(at.z);
  Vec4 sent_end = precomputed_sent(air, lattice, source, at, end);
  int count = int(panels);
  for (int i = 0; i < count; ++i) {
    Bool before = Float(i) < lit_first - 0.5;
    Bool behind = Float(i) > lit_last - 0.5;
    Vec4 piece = select(before, piece0, select(behind, piece2, piece1));
    Float piece_end = select(before, dark, select(behind, reach, light_again));
    Float place = Float(i) - select(before, Float(0.0), select(behind, lit_last, lit_first));
    Float to_go = select(before, lit_first, select(behind, Float(panels), lit_last)) - (Float(i) + 1.0);
    Float begin = end;
    end = clamp(piece.x + piece.y * precomputed_sinh(piece.z + piece.w * (place + 1.0)), begin, piece_end);
    end = select(to_go < 0.5, piece_end, end);
    Vec4 sent_begin = sent_end;
    sent_end = precomputed_sent(air, lattice, source, at, end);
    Float layer_begin = layer_end;
    Float dusk_begin = dusk_end;
    Float altitude_end = altitude_along(air.ground_radius, at.x, at.y, end);
    layer_end = precomputed_layer(air, altitude_end);
    dusk_end = precomputed_dusk((radius * at.z + end * at.w) / (air.ground_radius + altitude_end));
    Float climb = 4.0 * (layer_end - layer_begin);
    Float climbing = select(climb < 0.0, Float(-4.0), Float(4.0));
    Float turn = abs(dusk_end - dusk_begin);
    Float share = 1.0 / (abs(climb) + turn + 1.0e-3);
    Float stride = end - begin;
    // Three-point Gauss, and the depth up to each point by the matching collocation (Butcher 1964): order 6.
    Float altitude0 = altitude_along(air.ground_radius, at.x, at.y, begin + 0.112701665379258 * stride);
    Float altitude1 = altitude_along(air.ground_radius, at.x, at.y, begin + 0.5 * stride);
    Float altitude2 = altitude_along(air.ground_radius, at.x, at.y, begin + 0.887298334620742 * stride);
    Float layer0 = precomputed_layer(air, altitude0);
    Float layer1 = precomputed_layer(air, altitude1);
    Float layer2 = precomputed_layer(air, altitude2);
    Vec4 extinction0 = lookup_row(layers, layer0, 0) * stride;
    Vec4 extinction1 = lookup_row(layers, layer1, 0) * stride;
    Vec4 extinction2 = lookup_row(layers, layer2, 0) * stride;
    for (int node = 0; node < 3; ++node) {
      Float part = Float(0.112701665379258);
      Float weight = Float(0.277777777777778);
      Float altitude = altitude0;
      Float layer = layer0;
      Vec4 passed = 0.138888888888889 * extinction0 - 0.0359766675249389 * extinction1 + 0.00978944401530832 * extinction2;
      if (node == 1) {
        part = Float(0.5);
        weight = Float(0.444444444444444);
        altitude = altitude1;
        layer = layer1;
        passed = 0.300263194980865 * extinction0 + 0.222222222222222 * extinction1 - 0.0224854172030869 * extinction2;
      }
      if (node == 2) {
        part = Float(0.887298334620742);
        altitude = altitude2;
        layer = layer2;
        passed = 0.267988333762469 * extinction0 + 0.480421111969383 * extinction1 + 0.138888888888889 * extinction2;
      }
      passed = depth + max(passed, 0.0);
      Vec4 scattering = lookup_row(layers, layer, 1);
      Vec4 towards = scattering * phase0;
      if (air.classes > 1.5) {
        Vec4 more = lookup_row(layers, layer, 2);
        scattering = scattering + more;
        towards = towards + more * phase1;
      }
      if (air.classes > 2.5) {
        Vec4 more = lookup_row(layers, layer, 3);
        scattering = scattering + more;
        towards = towards + more * phase2;
      }
      if (air.classes > 3.5) {
        Vec4 more = lookup_row(layers, layer, 4);
        scattering = scattering + more;
        towards = towards + more * phase3;
      }
      Float mu_s = (radius * at.z + (begin + part * stride) * at.w) / (air.ground_radius + altitude);
      // Between a panel's ends -ln of what is sent goes as altitude and the Sun do.
      Float between = (clamp((layer - layer_begin) * climbing, 0.0, abs(climb)) + min(abs(precomputed_dusk(mu_s) - dusk_begin), turn) + 1.0e-3 * part) * share;
      Vec4 seen = Vec4(0.0);
      if (first > 0) seen = towards * sunlight_at(air, sunlight, altitude, mu_s) * exp(-passed);
      seen = seen + scattering * exp(-(passed + mix(sent_begin, sent_end, between)));
      light = light + seen * (weight * stride);
    }
    depth = depth + 0.277777777777778 * (extinction0 + extinction2) + 0.444444444444444 * extinction1;
  }
  return light;
}

/// What a view ray brings, all orders of scattering, per solar irradiance [1/sr]: the air's part; light reflected by the ground where the
/// ray meets it, already attenuated.
FN_SHARED Vec4 precomputed_ray_light(IN(Air) air, IN(Lattice) lattice, Scalar panels, Table2 phases, Table2 layers, Table2 sunlight, Table3 source,
                                     Table2 ground_light, Float altitude, Vec3 view, Vec3 sun, Float distance, OUT(Vec4) ground) {
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, sun, distance, reach, whole, hits);
  Vec4 phase0 = Vec4(0.0);
  Vec4 phase1 = Vec4(0.0);
  Vec4 phase2 = Vec4(0.0);
  Vec4 phase3 = Vec4(0.0);
  precomputed_phases(air, phases, one_minus_cos(view, sun), phase0, phase1, phase2, phase3);
  Vec4 depth = Vec4(0.0);
  Vec4 light = precomputed_march(air, lattice, 1, panels, layers, sunlight, source, phase0, phase1, phase2, phase3, at, reach, depth);
  ground = Vec4(0.0);
  if (any(hits)) {
    Vec4 reflected = ground_radiance(air, sunlight, sunlight, 1, at, reach) + precomputed_ground(air, ground_light, at, reach);
    ground = select(hits, reflected * exp(-depth), Vec4(0.0));
  }
  return light;
}
