#pragma once
#include "precomputed/march.glsl"
// Order by order: the light that reaches the lattice's places, what the air and the ground there make of it, and what of that
// reaches the places next.
//
// The lattice has too few directions for what a peaked phase function does to light that is already diffuse: each scattering would turn
// it by half a step of the lattice, and along the horizon that much is lost to the ground and to space. So light scattered by less than
// a small angle counts as not scattered at all (delta scaling: Joseph, Wiscombe & Weinman 1976, J. Atmos. Sci. 33, 2452):
// the air is one of smooth phase functions that scatters and takes away less. Sunlight itself keeps the true peaks: only diffuse light is
// treated so. The sum's last scattering, into what rays are answered from, is again that of the true air.

/// Altitude [m] of a row of `light`, the direction that its light comes from and the Sun's zenith cosine.
/// @param uv [1] in 0..1
/// @bound 1 scale 1e30   on the border of two rows engines may choose either: compared as part of the passes
FN Float precomputed_light_place(IN(Air) air, IN(Lattice) lattice, Vec2 uv, OUT(Vec3) view, OUT(Float) mu_s) {
  Scalar directions = lattice.rings * lattice.sectors;
  Float row = floor(uv.y * directions * lattice.altitudes);
  Float band = floor((row + 0.5) * (1.0 / directions));
  Float altitude = precomputed_altitude(air, lattice, band);
  Float solid_angle = Float(0.0);
  view = precomputed_direction(lattice, row - band * directions, mu_horizon(air.ground_radius, altitude), solid_angle);
  mu_s = precomputed_sun(air, from_half_texel(uv.x, lattice.suns));
  return altitude;
}
/// The Sun with this zenith cosine, over the x axis [1].
/// @param mu_s [1] in -1..1
FN Vec3 precomputed_sun_direction(Float mu_s) { return Vec3(sqrt(max((1.0 - mu_s) * (1.0 + mu_s), 0.0)), Float(0.0), mu_s); }

/// The part of what each phase class (u) scatters that counts as going straight on: its peak, cut off level where it ends [1]. A little
/// less, so that the mean cosine of all that is scattered stays as it is.
FN Vec4 precomputed_forward_pass(IN(Air) air, IN(Lattice) lattice, Table2 phases, Vec2 uv) {
  Float row = floor(uv.x * 4.0);
  Vec4 found = Vec4(0.0);
  int classes = int(air.classes);
  for (int i = 0; i < classes; ++i) {
    Vec4 level = lookup_row(phases, Float(lattice.straight), i);
    Vec4 peak = Vec4(0.0);
    Vec4 turned_in_peak = Vec4(0.0);
    Vec4 turned = Vec4(0.0);
    for (int k = 0; k < 512; ++k) {
      // x = sin(angle / 2) as a square finds the peak; a ring of the sphere is 8 pi x dx, and 1 - cos is 2 x^2.
      Float t = (Float(k) + 0.5) * (1.0 / 512.0);
      Float x = t * t;
      Float ring = t * t * t * (16.0 * 3.14159265358979 / 512.0);
      Vec4 phase = lookup_row(phases, x, i);
      Vec4 above = select(x < lattice.straight, phase - level, Vec4(0.0)) * ring;
      peak = peak + above;
      turned_in_peak = turned_in_peak + above * (2.0 * x * x);
      turned = turned + phase * (ring * 2.0 * x * x);
    }
    Vec4 straight = Vec4(1.0) - (Vec4(1.0) - peak) * turned / max(turned - turned_in_peak, 1.0e-6);
    found = select(abs(row - Float(i)) < 0.5, clamp(straight, 0.0, 0.95), found);
  }
  return found;
}

/// `layers` of the air without what it scatters straight on [1/m].
FN Vec4 precomputed_smooth_layers_pass(IN(Air) air, IN(GridSize) size, Table2 layers, Table2 forward, Vec2 uv) {
  Float row = floor(uv.y * size.height);
  Float column = floor(uv.x * size.width);
  Vec4 found = fetch(layers, column, row);
  int classes = int(air.classes);
  for (int i = 0; i < classes; ++i) {
    Vec4 straight = fetch(layers, column, Float(i) + 1.0) * fetch(forward, Float(i), Float(0.0));
    found = found - select((row < 0.5) || (abs(row - Float(i) - 1.0) < 0.5), straight, Vec4(0.0));
  }
  return max(found, 0.0);
}

/// A `source` that sends no light, as before the first scattering.
FN Vec4 precomputed_darkness_pass(Vec3 uvw) { return Vec4(80.0 + 0.0 * uvw.x); }

/// What the phase functions towards the Sun (u), one a component, sum up to over the directions at an altitude (v) [1]: 1 but for
/// what the directions miss of their peaks.
FN Vec4 precomputed_peaks_pass(IN(Air) air, IN(Lattice) lattice, Table2 phases, Vec2 uv) {
  Float altitude = precomputed_altitude(air, lattice, floor(uv.y * lattice.altitudes));
  Float horizon = mu_horizon(air.ground_radius, altitude);
  Vec3 sun = precomputed_sun_direction(precomputed_sun(air, from_half_texel(uv.x, lattice.suns)));
  Vec4 sum = Vec4(0.0);
  int count = int(lattice.rings * lattice.sectors);
  for (int i = 0; i < count; ++i) {
    Float solid_angle = Float(0.0);
    Float x = sqrt(0.5 * one_minus_cos(precomputed_direction(lattice, Float(i), horizon, solid_angle), sun));
    solid_angle = 2.0 * solid_angle;
    sum.x = sum.x + lookup_row(phases, x, 0).x * solid_angle;
    if (air.classes > 1.5) sum.y = sum.y + lookup_row(phases, x, 1).x * solid_angle;
    if (air.classes > 2.5) sum.z = sum.z + lookup_row(phases, x, 2).x * solid_angle;
    if (air.classes > 3.5) sum.w = sum.w + lookup_row(phases, x, 3).x * solid_angle;
  }
  return max(sum, 1.0e-3);
}

/// Light of the first order that reaches the lattice's places, with what of it is scattered straight on, per solar irradiance [1/sr].
FN Vec4 precomputed_first_light_pass(IN(Air) air, IN(Lattice) lattice, Table2 smooth_layers, Table2 forward, Table2 phases, Table2 sunlit, Table2 sunlight, Table2 peaks, Table3 darkness, Vec2 uv) {
  Vec3 view = Vec3(Float(0.0), Float(0.0), Float(1.0));
  Float mu_s = Float(0.0);
  Float altitude = precomputed_light_place(air, lattice, uv, view, mu_s);
  Vec3 sun = precomputed_sun_direction(mu_s);
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, sun, Float(1.0e30), reach, whole, hits);
  Vec4 phase0 = Vec4(0.0);
  Vec4 phase1 = Vec4(0.0);
  Vec4 phase2 = Vec4(0.0);
  Vec4 phase3 = Vec4(0.0);
  precomputed_phases(air, phases, one_minus_cos(view, sun), phase0, phase1, phase2, phase3);
  // Peaks between two directions would be missed or counted twice: all of them carry what they should.
  Vec4 peak = fetch(peaks, floor(uv.x * lattice.suns), floor(uv.y * lattice.altitudes));
  // Of sunlight the smooth layers scatter what the air scatters.
  phase0 = phase0 / ((Vec4(1.0) - fetch(forward, Float(0.0), Float(0.0))) * peak.x);
  phase1 = phase1 / ((Vec4(1.0) - fetch(forward, Float(1.0), Float(0.0))) * peak.y);
  phase2 = phase2 / ((Vec4(1.0) - fetch(forward, Float(2.0), Float(0.0))) * peak.z);
  phase3 = phase3 / ((Vec4(1.0) - fetch(forward, Float(3.0), Float(0.0))) * peak.w);
  Vec4 depth = Vec4(0.0);
  Vec4 none = Vec4(0.0);
  // It is asked once, of many: more panels than the next orders take cost little.
  Vec4 light = precomputed_march(air, lattice, 1, Vec2(Float(4.0 * lattice.panels), Float(lattice.panels)), 4 * int(lattice.panels), smooth_layers, sunlit, sunlit, darkness, phase0, phase1, phase2, phase3, at, reach, none, depth);
  return light + select(hits, ground_radiance(air, sunlight, sunlight, 1, at, reach) * exp(-depth), Vec4(0.0));
}

/// Light of the next order that reaches the lattice's places, per solar irradiance [1/sr].
FN Vec4 precomputed_next_light_pass(IN(Air) air, IN(Lattice) lattice, Table2 smooth_layers, Table2 sunlit, Table3 source, Table2 ground_light, Vec2 uv) {
  Vec3 view = Vec3(Float(0.0), Float(0.0), Float(1.0));
  Float mu_s = Float(0.0);
  Float altitude = precomputed_light_place(air, lattice, uv, view, mu_s);
  Float reach = Float(0.0);
  Float whole = Float(0.0);
  Bool hits = reach > 1.0;
  Vec4 at = meet_air(air, altitude, view, precomputed_sun_direction(mu_s), Float(1.0e30), reach, whole, hits);
  Vec4 depth = Vec4(0.0);
  Vec4 none = Vec4(0.0);
  Vec4 light = Vec4(0.0);
  precomputed_march(air, lattice, 2, Vec2(Float(lattice.panels), Float(0.0)), int(lattice.panels), smooth_layers, sunlit, sunlit, source, none, none, none, none, at, reach, light, depth);
  return light + select(hits, precomputed_ground(air, ground_light, at, reach) * exp(-depth), Vec4(0.0));
}

/// The part of light from one of the lattice's directions (u), with its mirror image, that the air sends into another (v: azimuth within
/// zenith angle within altitude) [1]. The same for all Suns and all orders; not yet scaled so that all of it is sent somewhere.
/// @param least [1] in 0..0.5  sine of half the angle within which the phase functions are level
FN Vec4 precomputed_weight(IN(Air) air, IN(Lattice) lattice, Scalar least, Table2 phases, Table2 layers, Vec2 uv) {
  Float row = floor(uv.y * lattice.azimuths * lattice.zeniths * lattice.altitudes);
  Float ring = floor((row + 0.5) * (1.0 / lattice.azimuths));
  Float band = floor((ring + 0.5) * (1.0 / lattice.zeniths));
  Float azimuth = (row - ring * lattice.azimuths) * (3.14159265358979 / (lattice.azimuths - 1.0));
  Float zenith = (ring - band * lattice.zeniths) * (3.14159265358979 / (lattice.zeniths - 1.0));
  Float across = sin(zenith);
  Vec3 sent = Vec3(across * cos(azimuth), across * sin(azimuth), cos(zenith));
  Float altitude = precomputed_altitude(air, lattice, band);
  Float solid_angle = Float(0.0);
  Vec3 view = precomputed_direction(lattice, floor(uv.x * lattice.rings * lattice.sectors), mu_horizon(air.ground_radius, altitude), solid_angle);
  // Light that comes from where one looks goes the other way: no scattering is "forward".
  Float x = max(sqrt(0.5 * one_minus_cos(view, sent)), least);
  Float mirrored = max(sqrt(0.5 * one_minus_cos(Vec3(view.x, -view.y, view.z), sent)), least);
  Float layer = precomputed_layer(air, altitude);
  // Where nothing scatters, as class 0 would.
  Vec4 share = lookup_row(layers, layer, 1) + Vec4(1.0e-25);
  Vec4 all = share;
  Vec4 weight = share * (lookup_row(phases, x, 0) + lookup_row(phases, mirrored, 0));
  if (air.classes > 1.5) {
    share = lookup_row(layers, layer, 2);
    all = all + share;
    weight = weight + share * (lookup_row(phases, x, 1) + lookup_row(phases, mirrored, 1));
  }
  if (air.classes > 2.5) {
    share = lookup_row(layers, layer, 3);
    all = all + share;
    weight = weight + share * (lookup_row(phases, x, 2) + lookup_row(phases, mirrored, 2));
  }
  if (air.classes > 3.5) {
    share = lookup_row(layers, layer, 4);
    all = all + share;
    weight = weight + share * (lookup_row(phases, x, 3) + lookup_row(phases, mirrored, 3));
  }
  return weight / all * solid_angle;
}

/// Such weights of the air itself.
FN Vec4 precomputed_weights_pass(IN(Air) air, IN(Lattice) lattice, Table2 phases, Table2 layers, Vec2 uv) { return precomputed_weight(air, lattice, 0.0, phases, layers, uv); }

/// Such weights of the smooth layers.
FN Vec4 precomputed_smooth_weights_pass(IN(Air) air, IN(Lattice) lattice, Table2 phases, Table2 smooth_layers, Vec2 uv) {
  return precomputed_weight(air, lattice, lattice.straight, phases, smooth_layers, uv);
}

/// -ln of what the air sends into a direction, per solar irradiance and scattering coefficient [1/sr], of light that reaches it.
FN Vec4 precomputed_sent_on(IN(Lattice) lattice, Table2 weights, Table2 light, Vec3 uvw) {
  Float ring = floor(uvw.y * lattice.zeniths * lattice.altitudes);
  Float row = ring * lattice.azimuths + floor(uvw.z * lattice.azimuths);
  Float first = floor((ring + 0.5) * (1.0 / lattice.zeniths)) * (lattice.rings * lattice.sectors);
  Float column = floor(uvw.x * lattice.suns);
  int count = int(lattice.rings * lattice.sectors);
  Vec4 sum = Vec4(0.0);
  Vec4 sum_of_weights = Vec4(0.0);
  for (int i = 0; i < count; ++i) {
    Vec4 weight = fetch(weights, Float(i), row);
    sum = sum + weight * fetch(light, column, first + Float(i));
    sum_of_weights = sum_of_weights + weight;
  }
  return -ln4(max(sum / sum_of_weights, 1.0e-30));
}

/// The table `source` of light of all orders.
FN Vec4 precomputed_source_pass(IN(Lattice) lattice, Table2 weights, Table2 light, Vec3 uvw) { return precomputed_sent_on(lattice, weights, light, uvw); }

/// The same of light of one order, per scattering coefficient of the smooth layers: what sends the next order.
FN Vec4 precomputed_smooth_source_pass(IN(Lattice) lattice, Table2 smooth_weights, Table2 light, Vec3 uvw) { return precomputed_sent_on(lattice, smooth_weights, light, uvw); }

/// -ln of the light that falls on the ground, per solar irradiance [1]: one row over the Suns.
FN Vec4 precomputed_ground_light_pass(IN(Lattice) lattice, Table2 light, Vec2 uv) {
  Float column = floor(uv.x * lattice.suns);
  int count = int(0.5 * lattice.rings * lattice.sectors);
  Vec4 sum = Vec4(0.0);
  for (int i = 0; i < count; ++i) {
    Float solid_angle = Float(0.0);
    Vec3 view = precomputed_direction(lattice, Float(i), Float(0.0), solid_angle);
    sum = sum + fetch(light, column, Float(i)) * (2.0 * solid_angle * view.z);
  }
  return -ln4(max(sum, 1.0e-30));
}

/// Sum of two tables.
FN Vec4 precomputed_sum_pass(Table2 light, Table2 others, Vec2 uv) { return fetch_same(light, uv) + fetch_same(others, uv); }

/// The sum with all orders that are still to come: each the same part of the one before, as the last was.
FN Vec4 precomputed_closed_pass(Table2 light_sum, Table2 light, Table2 light_before, Vec2 uv) {
  Vec4 last = fetch_same(light, uv);
  Vec4 ratio = clamp(last / max(fetch_same(light_before, uv), 1.0e-30), 0.0, 0.9);
  return fetch_same(light_sum, uv) + last * ratio / (Vec4(1.0) - ratio);
}
