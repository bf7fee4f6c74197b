#pragma once
// Straight rays over a sphere, in altitudes [m] above it: 32-bit float cannot resolve r^2 - R^2 on a planet (one ulp is 4e6 m^2).
// A ray starts at `altitude` with the cosine `mu` of its zenith angle. Its lowest point lies where r mu + path = 0.

/// Difference of the squared radii at two altitudes, factored [m^2].
/// @param ground_radius [m] in 1e3..1e8 log
/// @param upper [m] in 0..1e5
/// @param lower [m] in 0..1e5
/// @bound 2e-5 scale 1e13   relative to the planet's square at its largest
FN Float radius_gap(Scalar ground_radius, Float upper, Float lower) { return (upper - lower) * (2.0 * ground_radius + upper + lower); }

/// Cosine of the zenith angle of the geometric horizon [1]: 0 at altitude 0, -1 far away.
/// @param ground_radius [m] in 1e3..1e8 log
/// @param altitude [m] in 0..1e6
FN Float mu_horizon(Scalar ground_radius, Float altitude) {
  return -sqrt(max(radius_gap(ground_radius, altitude, Float(0.0)), 0.0)) / (ground_radius + altitude);
}

/// Distance to the sphere of altitude `shell` from inside it [m].
/// @param ground_radius [m] in 1e3..1e8 log
/// @param altitude [m] in 0..1e5
/// @param shell [m] in 1e5..2e5
/// @param mu [1] in -1..1
/// @bound 2e-5 scale 1e4
FN Float distance_to_shell(Scalar ground_radius, Float altitude, Float shell, Float mu) {
  Float b = (ground_radius + altitude) * mu;
  Float gap = radius_gap(ground_radius, shell, altitude);
  Float s = sqrt(max(b * b + gap, 0.0));
  // Two forms of one root; each cancels for one sign of mu. The floor keeps the unused one finite.
  return select(mu > 0.0, gap / max(b + s, 1.0e-6), s - b);
}

/// Distance to the ground [m]; only for mu below mu_horizon, elsewhere finite but meaningless.
/// @param ground_radius [m] in 1e6..1e8 log
/// @param altitude [m] in 1..1e5
/// @param mu [1] in -1..-0.5
/// @bound 2e-5 scale 1
FN Float distance_to_ground(Scalar ground_radius, Float altitude, Float mu) {
  Float b = (ground_radius + altitude) * mu;
  Float gap = max(radius_gap(ground_radius, altitude, Float(0.0)), 0.0);
  return gap / max(sqrt(max(b * b - gap, 0.0)) - b, 1.0e-6);
}

/// Altitude after a path along the ray [m].
/// @param ground_radius [m] in 1e3..1e8 log
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..1
/// @param path [m] in 0..1e5
/// @bound 2e-5 scale 1e5   the sum of altitude and path is what float resolves
FN Float altitude_along(Scalar ground_radius, Float altitude, Float mu, Float path) {
  Float r = ground_radius + altitude;
  Float gain = path * (2.0 * r * mu + path);  // r'^2 - r^2
  return altitude + gain / (r + sqrt(max(r * r + gain, 0.0)));
}

/// Path at which a ray that descends (leg 0) or ascends (leg 1) is at altitude `shell` [m].
/// Where it never is, the path of its lowest point or beyond the leg's other end: callers clamp to the leg.
/// @param ground_radius [m] in 1e3..1e8 log
/// @param altitude [m] in 0..1e5
/// @param along [m] in -1e6..1e6  radius times mu: minus the path to the lowest point
/// @param shell [m] in 0..1e5
/// @param leg [1] in 0..1
/// @bound 2e-5 scale 1e6
FN Float path_to_shell(Scalar ground_radius, Float altitude, Float along, Float shell, int leg) {
  Float gap = radius_gap(ground_radius, shell, altitude);
  Float beyond = sqrt(max(along * along + gap, 0.0));
  Float ahead = abs(along);
  Float ratio = gap / max(beyond + ahead, 1.0e-6);
  if (leg == 0) return -ratio;
  return select(along < 0.0, beyond + ahead, ratio);
}

/// Moves a ray that starts outside the atmosphere to where it enters; others stay as they are. Returns the path skipped [m],
/// or a negative number where the ray misses the atmosphere.
/// @param ground_radius [m] in 1e6..1e8 log
/// @param top [m] in 1e5..2e5
/// @param altitude [m] in 0..1e6
/// @param view [1] in -0.577..0.577  unit vector, z up at the observer
/// @param entry_altitude [m]
/// @param entry_mu [1]
/// @bound 1 scale 1e30   a ray that grazes the top may miss it on one engine: compared as part of the passes
FN Float enter_atmosphere(Scalar ground_radius, Scalar top, Float altitude, Vec3 view, OUT(Float) entry_altitude, OUT(Float) entry_mu) {
  // The horizontal part of the view resolves a planet of a degree across from afar; 1 - mu^2 would not.
  Float horizontal = sqrt(view.x * view.x + view.y * view.y);
  Float r = ground_radius + altitude;
  Float lowest = r * horizontal - ground_radius;
  Float across = radius_gap(ground_radius, Float(top), lowest);  // squared half chord inside the top sphere
  Bool outside = altitude > top;
  Bool misses = outside && ((view.z >= 0.0) || (across <= 0.0));
  Float half_chord = sqrt(max(across, 0.0));
  entry_altitude = select(outside, Float(top), altitude);
  entry_mu = select(outside, -half_chord / (ground_radius + top), view.z);
  Float skipped = select(outside, max(-r * view.z - half_chord, 0.0), Float(0.0));
  return select(misses, Float(-1.0), skipped);
}

/// The stretch of a ray in the shadow that a sphere casts away from the Sun, as paths from its start [m]; empty: begin >= end.
/// @param ground_radius [m] in 1e6..1e8 log
/// @param altitude [m] in 0..1e5
/// @param mu [1] in -1..1
/// @param mu_s [1] in -1..1   cosine of the Sun's zenith angle at the start
/// @param nu [1] in -1..1     cosine of the angle between ray and Sun
/// @param begin [m]
/// @param end [m]
/// @bound 1 scale 1e30   the shadow's edge is steep in its arguments: compared as part of the passes
FN void planet_shadow(Scalar ground_radius, Float altitude, Float mu, Float mu_s, Float nu, OUT(Float) begin, OUT(Float) end) {
  Float r = ground_radius + altitude;
  // Across the Sun's direction the squared distance from the axis is a parabola in the path: a p^2 + 2 b p + c + R^2.
  Float a = max((1.0 - nu) * (1.0 + nu), 1.0e-6);
  Float b = r * (mu - mu_s * nu);
  Float c = radius_gap(ground_radius, altitude, Float(0.0)) - r * r * mu_s * mu_s;
  Float root = b * b - a * c;
  Float s = sqrt(max(root, 0.0));
  // The root that does not cancel, and the other from the product of the two.
  Float q = -(b + select(b < 0.0, -s, s));
  Float p1 = q / a;
  Float p2 = c / select(abs(q) < 1.0e-6, Float(1.0e-6), q);
  Float first = min(p1, p2);
  Float second = max(p1, p2);
  // Only behind the terminator plane, where r mu_s + p nu < 0, is the cylinder a shadow.
  Float plane = -r * mu_s / select(abs(nu) < 1.0e-6, select(nu < 0.0, Float(-1.0e-6), Float(1.0e-6)), nu);
  begin = select(nu < 0.0, max(first, plane), first);
  end = select(nu < 0.0, second, min(second, plane));
  begin = select(root > 0.0, begin, Float(1.0e30));
  end = select(root > 0.0, end, Float(-1.0e30));
  // A Sun straight along the ray: all of the ray is on one side of the cylinder and the plane.
}
