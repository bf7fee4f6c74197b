// The kernel language for GLSL 4.50 and GLSL ES 3.00. The wrapper has already said #version.
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
#endif
#define FN
#define FN_SHARED
#define IN(T) in T
#define OUT(T) out T
#define Float float
#define Scalar float
#define Scalar4 vec4
#define Bool bool
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
#define Table2 sampler2D
#define Table3 sampler3D
float select(bool c, float a, float b) { return c ? a : b; }
vec2 select(bool c, vec2 a, vec2 b) { return c ? a : b; }
vec3 select(bool c, vec3 a, vec3 b) { return c ? a : b; }
vec4 select(bool c, vec4 a, vec4 b) { return c ? a : b; }
vec2 xy(vec4 v) { return v.xy; }
vec3 xyz(vec4 v) { return v.xyz; }

// The language's own max, min and clamp: the second argument when the first is NaN, which GLSL leaves open.
// Macros, because GLSL ES 3.00 forbids overloading a built-in.
float air_max(float a, float b) { return a > b ? a : b; }
float air_min(float a, float b) { return a < b ? a : b; }
vec4 air_max(vec4 a, float b) { return vec4(air_max(a.x, b), air_max(a.y, b), air_max(a.z, b), air_max(a.w, b)); }
vec4 air_min(vec4 a, float b) { return vec4(air_min(a.x, b), air_min(a.y, b), air_min(a.z, b), air_min(a.w, b)); }
float air_clamp(float x, float low, float high) { return air_min(air_max(x, low), high); }
vec4 air_clamp(vec4 x, float low, float high) { return air_min(air_max(x, low), high); }
bool air_any(bool b) { return b; }
#define max air_max
#define min air_min
#define clamp air_clamp
#define any air_any

// x = mantissa * 2^exponent with the mantissa in [1, 2), for normal x > 0.
float exponent_of(float x) { return float((floatBitsToInt(x) >> 23) - 127); }
float mantissa_of(float x) { return intBitsToFloat((floatBitsToInt(x) & 0x007fffff) | 0x3f800000); }
// 1 / sqrt(x) for normal x > 0; elsewhere anything.
float inverse_root(float x) { return inversesqrt(x); }

// Filtering by hand: hardware filters weigh with 8 bits, and WebGL2 may not filter 32-bit float at all.
vec4 fetch(sampler2D t, float column, float row) {
  vec2 size = vec2(textureSize(t, 0));
  return texelFetch(t, ivec2(int(clamp(column, 0.0, size.x - 1.0)), int(clamp(row, 0.0, size.y - 1.0))), 0);
}
float width_of(sampler2D t) { return float(textureSize(t, 0).x); }
float height_of(sampler2D t) { return float(textureSize(t, 0).y); }
vec4 fetch_same(sampler2D t, vec2 uv) {
  vec2 size = vec2(textureSize(t, 0));
  return fetch(t, floor(uv.x * size.x), floor(uv.y * size.y));
}
vec4 fetch_scalar(sampler2D t, int column, int row) { return texelFetch(t, ivec2(column, row), 0); }
vec4 lookup_cell(sampler2D t, float x, int row) {
  float cells = 0.5 * float(textureSize(t, 0).x);
  float y = clamp(x, 0.0, cells);
  float i = min(floor(y), cells - 1.0);
  return mix(texelFetch(t, ivec2(2 * int(i), row), 0), texelFetch(t, ivec2(2 * int(i) + 1, row), 0), y - i);
}
vec4 lookup_row(sampler2D t, float u, int row) {
  float last = float(textureSize(t, 0).x - 1);
  float x = clamp(u, 0.0, 1.0) * last;
  float i = min(floor(x), last - 1.0);
  return mix(texelFetch(t, ivec2(int(i), row), 0), texelFetch(t, ivec2(int(i) + 1, row), 0), x - i);
}
void lookup_rows(sampler2D t, float u, int row, out vec4 first, out vec4 second, out vec4 third) {
  first = lookup_row(t, u, row);
  second = lookup_row(t, u, row + 1);
  third = lookup_row(t, u, row + 2);
}
vec4 lookup(sampler2D t, vec2 uv) {
  vec2 size = vec2(textureSize(t, 0));
  float x = clamp(uv.x * size.x - 0.5, 0.0, size.x - 1.0), y = clamp(uv.y * size.y - 0.5, 0.0, size.y - 1.0);
  float i = min(floor(x), size.x - 2.0), j = min(floor(y), size.y - 2.0);
  ivec2 at = ivec2(int(i), int(j));
  vec4 a = mix(texelFetch(t, at, 0), texelFetch(t, at + ivec2(1, 0), 0), x - i);
  vec4 b = mix(texelFetch(t, at + ivec2(0, 1), 0), texelFetch(t, at + ivec2(1, 1), 0), x - i);
  return mix(a, b, y - j);
}
// The whole part of a division rounds, so x - n floor(x / n) can be exactly n, or just below 0: wrapped again.
float wrapped(float x, float n) {
  float r = clamp(x - n * floor(x * (1.0 / n)), 0.0, n);
  return r < n ? r : 0.0;
}
vec4 lookup_repeat(sampler2D t, vec2 uv) {
  vec2 size = vec2(textureSize(t, 0));
  float x = wrapped(uv.x * size.x - 0.5, size.x), y = wrapped(uv.y * size.y - 0.5, size.y);
  int i = int(x), j = int(y);
  int right = i < int(size.x) - 1 ? i + 1 : 0, below = j < int(size.y) - 1 ? j + 1 : 0;
  vec4 a = mix(texelFetch(t, ivec2(i, j), 0), texelFetch(t, ivec2(right, j), 0), x - float(i));
  vec4 b = mix(texelFetch(t, ivec2(i, below), 0), texelFetch(t, ivec2(right, below), 0), x - float(i));
  return mix(a, b, y - float(j));
}
vec4 lookup(sampler3D t, vec3 uvw) {
  vec3 size = vec3(textureSize(t, 0));
  float x = clamp(uvw.x * size.x - 0.5, 0.0, size.x - 1.0), y = clamp(uvw.y * size.y - 0.5, 0.0, size.y - 1.0);
  float z = clamp(uvw.z * size.z - 0.5, 0.0, size.z - 1.0);
  float i = min(floor(x), size.x - 2.0), j = min(floor(y), size.y - 2.0), k = min(floor(z), size.z - 2.0);
  ivec3 at = ivec3(int(i), int(j), int(k));
  vec4 a = mix(mix(texelFetch(t, at, 0), texelFetch(t, at + ivec3(1, 0, 0), 0), x - i),
               mix(texelFetch(t, at + ivec3(0, 1, 0), 0), texelFetch(t, at + ivec3(1, 1, 0), 0), x - i), y - j);
  vec4 b = mix(mix(texelFetch(t, at + ivec3(0, 0, 1), 0), texelFetch(t, at + ivec3(1, 0, 1), 0), x - i),
               mix(texelFetch(t, at + ivec3(0, 1, 1), 0), texelFetch(t, at + ivec3(1, 1, 1), 0), x - i), y - j);
  return mix(a, b, z - k);
}
