// A full-screen pass over a finished frame, behind the text of prelude/prelude.glsl and skyview/skyview.glsl. The engine's world is y up
// (x east, -z north), in kilometres; its depth buffer is reversed: near / z, 0 at infinity.
uniform Air air;
uniform Observer observer;
uniform Dome dome;
uniform Dome froxels;
uniform Table2 phases, sky_view, sky_class1, sky_class2, sky_class3;
uniform Table3 aerial, aerial_depth, aerial_class0, aerial_class1, aerial_class2, aerial_class3;
uniform mat4x3 to_srgb;
uniform mat3x4 from_srgb;
uniform float white_luminance;  // of a colour of 1 [cd/m2]

uniform Table2 scene_colour, scene_depth;
uniform vec3 right, up, forward;  // camera: the view at (x, y) in -1..1 is forward + x right + y up
uniform float near_plane;         // [km]

in vec2 at;
out vec4 hazed;

vec3 to_kernels(vec3 v) { return vec3(v.x, -v.z, v.y); }  // frame: east, north, up

// The air before a point of the view [W m^-2 sr^-1 nm^-1]: docs/tables.md, "Aerial perspective".
vec4 inscatter(vec3 view, float distance, out vec4 transmittance) {
  vec3 sun = observer.sun.xyz;
  float reach, whole;
  bool hits;
  meet_air(air, observer.altitude, view, sun, distance, reach, whole, hits);
  vec3 place = vec3(dome_uv(froxels.horizon, view, sun, froxels.width, froxels.height), aerial_w(reach, whole, froxels.depth));
  float angle = sqrt(0.5 * one_minus_cos(view, sun));
  vec4 light = lookup(aerial, place) + lookup(aerial_class0, place) * lookup_row(phases, angle, 0);
  if (air.classes > 1.5) light += lookup(aerial_class1, place) * lookup_row(phases, angle, 1);
  if (air.classes > 2.5) light += lookup(aerial_class2, place) * lookup_row(phases, angle, 2);
  if (air.classes > 3.5) light += lookup(aerial_class3, place) * lookup_row(phases, angle, 3);
  transmittance = exp(-lookup(aerial_depth, place) * reach);
  return light * reach * air.solar_irradiance;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(scene_depth, pixel, 0).x;
  vec3 ray = forward + at.x * right + at.y * up;  // its length is that of a depth of 1
  vec3 view = to_kernels(normalize(ray));
  vec4 light;
  if (depth == 0.0) {
    light = skyview_seen(air, dome, phases, sky_view, sky_class1, sky_class2, sky_class3, view, observer.sun.xyz) * air.solar_irradiance;
  } else {
    vec4 transmittance;
    vec4 added = inscatter(view, near_plane / depth * length(ray) * 1000.0, transmittance);
    light = from_srgb * (texelFetch(scene_colour, pixel, 0).rgb * white_luminance) * transmittance + added;
  }
  hazed = vec4(to_srgb * light, 1.0);  // [cd/m2]
}
