// The kernel language for C++ (see docs/architecture.md). Include inside no namespace, after defining
//   AIRLIGHT_TARGET  namespace of this build of the kernels: one per number type, instruction set and translation unit's purpose
//   AIRLIGHT_REP     double, float, or an xsimd batch of float: what one variable of a kernel holds
// Nothing here may be merged with another build by the linker: all is in the target's namespace or templated on its batch.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <xsimd/xsimd.hpp>
#if defined(__AVX2__) || defined(__AVX512F__)
#include <immintrin.h>
#endif
#define FN [[gnu::always_inline]] inline
// Long functions that several entries call: compiled once a unit. Static, so still nothing for the linker to merge.
#define FN_SHARED [[gnu::noinline, maybe_unused]] static
#define IN(T) const T&
#define OUT(T) T&

namespace airlight::AIRLIGHT_TARGET {
using Rep = AIRLIGHT_REP;
template <class R> struct Traits { using Element = R; using Mask = bool; static constexpr int lanes = 1; };
template <class T, class A> struct Traits<xsimd::batch<T, A>> {
  using Element = T; using Mask = xsimd::batch_bool<T, A>; static constexpr int lanes = int(xsimd::batch<T, A>::size);
};
using Element = Traits<Rep>::Element;
using Mask = Traits<Rep>::Mask;
inline constexpr int lanes = Traits<Rep>::lanes;

// Scalar: the same in every lane. A class, so that 2.0 * s stays an Element and no double creeps into float code.
struct Scalar {
  Element v;
  Scalar() = default;
  constexpr Scalar(double x) : v(static_cast<Element>(x)) {}
  explicit operator int() const { return static_cast<int>(v); }
};
struct alignas(4 * sizeof(Element)) Scalar4 {
  Scalar x, y, z, w;
  Scalar4() = default;
  constexpr Scalar4(Scalar a, Scalar b, Scalar c, Scalar d) : x(a), y(b), z(c), w(d) {}
};
// Bool does not convert to bool: `if` on a value that differs between lanes is a compile error in every target.
struct Bool { Mask v; };
struct Float {
  Rep v;
  Float() = default;
  FN Float(double x) : v(static_cast<Element>(x)) {}
  FN Float(Scalar x) : v(x.v) {}
  FN explicit Float(int i) : v(static_cast<Element>(i)) {}
  FN static Float of(Rep r) { Float f; f.v = r; return f; }
};
struct Vec2 { Float x, y; Vec2() = default; FN Vec2(Float a, Float b) : x(a), y(b) {} };
struct Vec3 { Float x, y, z; Vec3() = default; FN Vec3(Float a, Float b, Float c) : x(a), y(b), z(c) {} };
struct Vec4 {
  Float x, y, z, w;
  Vec4() = default;
  FN explicit Vec4(Float a) : x(a), y(a), z(a), w(a) {}
  FN Vec4(Float a, Float b, Float c, Float d) : x(a), y(b), z(c), w(d) {}
  FN Vec4(const Scalar4& s) : x(s.x), y(s.y), z(s.z), w(s.w) {}
};

#define AIRLIGHT_OP(op)                                                                                        \
  FN Scalar operator op(Scalar a, Scalar b) { return Scalar(double(a.v op b.v)); }                             \
  FN Scalar4 operator op(Scalar4 a, Scalar4 b) { return {a.x op b.x, a.y op b.y, a.z op b.z, a.w op b.w}; }    \
  FN Float operator op(Float a, Float b) { return Float::of(a.v op b.v); }                                     \
  FN Vec2 operator op(Vec2 a, Vec2 b) { return {a.x op b.x, a.y op b.y}; }                                     \
  FN Vec2 operator op(Vec2 a, Float b) { return {a.x op b, a.y op b}; }                                        \
  FN Vec3 operator op(Vec3 a, Vec3 b) { return {a.x op b.x, a.y op b.y, a.z op b.z}; }                         \
  FN Vec3 operator op(Vec3 a, Float b) { return {a.x op b, a.y op b, a.z op b}; }                              \
  FN Vec3 operator op(Float a, Vec3 b) { return {a op b.x, a op b.y, a op b.z}; }                              \
  FN Vec4 operator op(Vec4 a, Vec4 b) { return {a.x op b.x, a.y op b.y, a.z op b.z, a.w op b.w}; }             \
  FN Vec4 operator op(Vec4 a, Float b) { return {a.x op b, a.y op b, a.z op b, a.w op b}; }                    \
  FN Vec4 operator op(Float a, Vec4 b) { return {a op b.x, a op b.y, a op b.z, a op b.w}; }
AIRLIGHT_OP(+) AIRLIGHT_OP(-) AIRLIGHT_OP(*) AIRLIGHT_OP(/)
#undef AIRLIGHT_OP
#define AIRLIGHT_COMPARE(op)                                             \
  FN bool operator op(Scalar a, Scalar b) { return a.v op b.v; }         \
  FN Bool operator op(Float a, Float b) { return {a.v op b.v}; }
AIRLIGHT_COMPARE(<) AIRLIGHT_COMPARE(<=) AIRLIGHT_COMPARE(>) AIRLIGHT_COMPARE(>=)
#undef AIRLIGHT_COMPARE
FN Scalar operator-(Scalar a) { return Scalar(double(-a.v)); }
FN Float operator-(Float a) { return Float::of(-a.v); }
FN Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
FN Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
FN Vec4 operator-(Vec4 a) { return {-a.x, -a.y, -a.z, -a.w}; }
FN Bool operator&&(Bool a, Bool b) { return {a.v && b.v}; }
FN Bool operator||(Bool a, Bool b) { return {a.v || b.v}; }
FN Bool operator!(Bool a) { return {!a.v}; }
FN bool any_lane(bool m) { return m; }
template <class T, class A> FN bool any_lane(xsimd::batch_bool<T, A> m) { return xsimd::any(m); }
/// True where some lane needs the work. It may skip work, never change a result.
FN bool any(Bool b) { return any_lane(b.v); }

// Number or batch: the only two sets of overloads. max and min return the second argument when the first is NaN,
// like the machine's instruction; so write max(suspect, bound).
FN Element pick(bool c, Element a, Element b) { return c ? a : b; }
FN Element larger(Element a, Element b) { return a > b ? a : b; }
FN Element smaller(Element a, Element b) { return a < b ? a : b; }
template <class T, class A> FN xsimd::batch<T, A> pick(xsimd::batch_bool<T, A> c, xsimd::batch<T, A> a, xsimd::batch<T, A> b) { return xsimd::select(c, a, b); }
#if defined(__SSE2__)
// On x86 the instruction does just that, whatever the compiler makes of a comparison.
template <class T, class A> FN xsimd::batch<T, A> larger(xsimd::batch<T, A> a, xsimd::batch<T, A> b) { return xsimd::max(a, b); }
template <class T, class A> FN xsimd::batch<T, A> smaller(xsimd::batch<T, A> a, xsimd::batch<T, A> b) { return xsimd::min(a, b); }
#else
// NEON's own max returns NaN when either is NaN.
template <class T, class A> FN xsimd::batch<T, A> larger(xsimd::batch<T, A> a, xsimd::batch<T, A> b) { return xsimd::select(a > b, a, b); }
template <class T, class A> FN xsimd::batch<T, A> smaller(xsimd::batch<T, A> a, xsimd::batch<T, A> b) { return xsimd::select(a < b, a, b); }
#endif
// sin of x + quarter * pi/2 for |x| < 8192, absolute error 1e-7. xsimd's sin drags in weak double functions for huge angles;
// built with AVX-512 they would replace the baseline's at link time.
FN Element fast_sin(Element x, double quarter) { return std::sin(x + static_cast<Element>(quarter * 1.57079632679489662)); }
template <class T, class A> FN xsimd::batch<T, A> fast_sin(xsimd::batch<T, A> x, double quarter) {
  using B = xsimd::batch<T, A>;
  const B n = xsimd::nearbyint(x * B(0.636619772f));
  const B r = xsimd::fnma(n, B(7.54978995e-8f), xsimd::fnma(n, B(4.83751297e-4f), xsimd::fnma(n, B(1.5703125f), x)));
  const B turn = n + B(static_cast<T>(quarter));
  const B q = turn - B(4.f) * xsimd::floor(turn * B(0.25f));  // 0, 1, 2, 3
  const B r2 = r * r;
  const B s = xsimd::fma(r * r2, xsimd::fma(r2, xsimd::fma(r2, B(-1.95152959e-4f), B(8.33216087e-3f)), B(-1.66666546e-1f)), r);
  const B c = xsimd::fma(r2 * r2, xsimd::fma(r2, xsimd::fma(r2, B(2.44331571e-5f), B(-1.38873163e-3f)), B(4.16666457e-2f)),
                         xsimd::fnma(r2, B(0.5f), B(1.f)));
  const B value = xsimd::select((q == B(1.f)) || (q == B(3.f)), c, s);
  return xsimd::select(q >= B(2.f), -value, value);
}
// AVX-512 scales by powers of two in one instruction, underflow and overflow included: half the work of xsimd's exp, relative error 5e-7.
FN Element fast_exp(Element x) { return std::exp(x); }
template <class A> FN xsimd::batch<float, A> fast_exp(xsimd::batch<float, A> x) {
#if defined(__AVX512F__)
  using B = xsimd::batch<float, A>;
  const B y = _mm512_min_ps(_mm512_max_ps(x, B(-150.f)), B(150.f));  // of a NaN, 0
  const B n = _mm512_roundscale_ps(y * B(1.44269504f), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
  const B r = xsimd::fnma(n, B(0.693147181f), y);
  B p = B(0.0013941119f);
  for (const float c : {0.00837513432f, 0.0416663513f, 0.166664153f, 0.5f, 1.f, 1.f}) p = xsimd::fma(p, r, B(c));
  return _mm512_scalef_ps(p, n);
#else
  return xsimd::exp(x);
#endif
}
// 1 / sqrt(x) for normal x > 0, to 3e-7: an estimate and a step of Newton's, five times faster than division and root. Elsewhere anything.
FN Element inverse_root(Element x) { return 1 / std::sqrt(x); }
template <class A> FN xsimd::batch<float, A> inverse_root(xsimd::batch<float, A> x) {
  using B = xsimd::batch<float, A>;
#if defined(__AVX512F__)
  const B y = _mm512_rsqrt14_ps(x);
#elif defined(__AVX2__)
  const B y = _mm256_rsqrt_ps(x);
#else
  return B(1.f) / xsimd::sqrt(x);
#endif
#if defined(__AVX2__)
  return y * xsimd::fnma(x * B(0.5f) * y, y, B(1.5f));
#endif
}
// x = mantissa * 2^exponent with the mantissa in [1, 2), for normal x > 0: what a logarithm is built on.
FN Element split_exponent(double x) { int e = 0; std::frexp(x, &e); return static_cast<Element>(e - 1); }
FN Element split_mantissa(double x) { int e = 0; return static_cast<Element>(2.0 * std::frexp(x, &e)); }
template <class A> FN xsimd::batch<float, A> split_exponent(xsimd::batch<float, A> x) {
  const auto bits = xsimd::bitwise_cast<xsimd::batch<std::int32_t, A>>(x);
  return xsimd::to_float((bits >> 23) - xsimd::batch<std::int32_t, A>(127));
}
template <class A> FN xsimd::batch<float, A> split_mantissa(xsimd::batch<float, A> x) {
  using I = xsimd::batch<std::int32_t, A>;
  const auto bits = xsimd::bitwise_cast<I>(x);
  return xsimd::bitwise_cast<xsimd::batch<float, A>>((bits & I(0x007fffff)) | I(0x3f800000));
}

#define AIRLIGHT_FUNCTION(name) \
  FN Float name(Float a) { using std::name; using xsimd::name; return Float::of(name(a.v)); }
AIRLIGHT_FUNCTION(sqrt) AIRLIGHT_FUNCTION(floor) AIRLIGHT_FUNCTION(abs)
#undef AIRLIGHT_FUNCTION
FN Float exp(Float a) { return Float::of(fast_exp(a.v)); }
FN Float sin(Float a) { return Float::of(fast_sin(a.v, 0.0)); }
FN Float cos(Float a) { return Float::of(fast_sin(a.v, 1.0)); }
FN Float inverse_root(Float a) { return Float::of(inverse_root(a.v)); }
FN Float exponent_of(Float a) { return Float::of(split_exponent(a.v)); }
FN Float mantissa_of(Float a) { return Float::of(split_mantissa(a.v)); }
FN Vec4 exp(Vec4 a) { return {exp(a.x), exp(a.y), exp(a.z), exp(a.w)}; }
FN Vec4 abs(Vec4 a) { return {abs(a.x), abs(a.y), abs(a.z), abs(a.w)}; }
FN Scalar sqrt(Scalar a) { return Scalar(double(std::sqrt(a.v))); }
FN Float max(Float a, Float b) { return Float::of(larger(a.v, b.v)); }
FN Float min(Float a, Float b) { return Float::of(smaller(a.v, b.v)); }
FN Scalar max(Scalar a, Scalar b) { return Scalar(double(larger(a.v, b.v))); }
FN Scalar min(Scalar a, Scalar b) { return Scalar(double(smaller(a.v, b.v))); }
FN Vec4 max(Vec4 a, Float b) { return {max(a.x, b), max(a.y, b), max(a.z, b), max(a.w, b)}; }
FN Vec4 min(Vec4 a, Float b) { return {min(a.x, b), min(a.y, b), min(a.z, b), min(a.w, b)}; }
FN Float clamp(Float x, Float low, Float high) { return min(max(x, low), high); }
FN Vec4 clamp(Vec4 x, Float low, Float high) { return min(max(x, low), high); }
FN Float select(Bool c, Float a, Float b) { return Float::of(pick(c.v, a.v, b.v)); }
FN Vec2 select(Bool c, Vec2 a, Vec2 b) { return {select(c, a.x, b.x), select(c, a.y, b.y)}; }
FN Vec3 select(Bool c, Vec3 a, Vec3 b) { return {select(c, a.x, b.x), select(c, a.y, b.y), select(c, a.z, b.z)}; }
FN Vec4 select(Bool c, Vec4 a, Vec4 b) { return {select(c, a.x, b.x), select(c, a.y, b.y), select(c, a.z, b.z), select(c, a.w, b.w)}; }
FN Float mix(Float a, Float b, Float t) { return a + (b - a) * t; }
FN Vec2 mix(Vec2 a, Vec2 b, Float t) { return a + (b - a) * t; }
FN Vec3 mix(Vec3 a, Vec3 b, Float t) { return a + (b - a) * t; }
FN Vec4 mix(Vec4 a, Vec4 b, Float t) { return a + (b - a) * t; }
FN Float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
FN Float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FN Float dot(Vec4 a, Vec4 b) { return a.x * b.x + a.y * b.y + (a.z * b.z + a.w * b.w); }
FN Vec2 xy(Vec4 v) { return {v.x, v.y}; }
FN Vec3 xyz(Vec4 v) { return {v.x, v.y, v.z}; }

// A table is interleaved RGBA. One 16-byte load per lane and a transpose give four channels; xsimd 8.1's gather is a
// scalar loop, and even the hardware's gather of one channel at a time costs twice as much.
struct Table2 { const Element* texels; int width, height; };
struct Table3 { const Element* texels; int width, height, depth; };

// Texels of all lanes on their way from a table: loaded, mixed with their neighbours as they lie in memory, and only then turned into
// one Float a channel: a bilinear lookup needs one transpose, not four.
template <class R> struct Texels {
  using At = std::ptrdiff_t;
  using Weight = Float;
  Vec4 v;
  FN static At address(R i) { return 4 * static_cast<std::ptrdiff_t>(i); }
  FN static Texels load(const R* p, At at) {
    p += at;
    return {Vec4(Float::of(p[0]), Float::of(p[1]), Float::of(p[2]), Float::of(p[3]))};
  }
  FN static Weight weights(Float t) { return t; }
  FN static Texels pair(const R* p, At at, Float t) { return mixed(load(p, at), load(p + 4, at), t); }
  FN static Texels mixed(const Texels& a, const Texels& b, Float t) { return {mix(a.v, b.v, t)}; }
  FN Vec4 channels() const { return v; }
};
template <class A> struct Texels<xsimd::batch<float, A>> {
  using B = xsimd::batch<float, A>;
#if defined(__AVX512F__)
  using Row = __m512;
  FN static Row unpack_low(Row a, Row b) { return _mm512_unpacklo_ps(a, b); }
  FN static Row unpack_high(Row a, Row b) { return _mm512_unpackhi_ps(a, b); }
  FN static Row low_halves(Row a, Row b) { return _mm512_shuffle_ps(a, b, 0x44); }
  FN static Row high_halves(Row a, Row b) { return _mm512_shuffle_ps(a, b, 0xee); }
  template <int k> FN static Row spread(Row f) { return _mm512_permute_ps(f, k * 0x55); }
#elif defined(__AVX2__)
  using Row = __m256;
  FN static Row unpack_low(Row a, Row b) { return _mm256_unpacklo_ps(a, b); }
  FN static Row unpack_high(Row a, Row b) { return _mm256_unpackhi_ps(a, b); }
  FN static Row low_halves(Row a, Row b) { return _mm256_shuffle_ps(a, b, 0x44); }
  FN static Row high_halves(Row a, Row b) { return _mm256_shuffle_ps(a, b, 0xee); }
  template <int k> FN static Row spread(Row f) { return _mm256_permute_ps(f, k * 0x55); }
#else
  typedef float Row __attribute__((vector_size(16)));
  FN static Row unpack_low(Row a, Row b) { return __builtin_shufflevector(a, b, 0, 4, 1, 5); }
  FN static Row unpack_high(Row a, Row b) { return __builtin_shufflevector(a, b, 2, 6, 3, 7); }
  FN static Row low_halves(Row a, Row b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
  FN static Row high_halves(Row a, Row b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
  template <int k> FN static Row spread(Row f) { return __builtin_shufflevector(f, f, k, k, k, k); }
#endif
  // Row k: the four channels of lane k, then (in wider registers) of lanes k + 4, k + 8, k + 12.
  Row row[4];
  // Texels counted double: 8 bytes each, the largest unit that an x86 address counts in.
  struct At { alignas(64) std::uint32_t twice[lanes]; };
  using Weight = Texels;

  FN static At address(B i) {
    At at;
    (xsimd::to_int(i) << 1).store_aligned(reinterpret_cast<std::int32_t*>(at.twice));
    // Through memory: gcc would pick the lanes out of the register one by one, which takes longer than all that follows.
    asm("" : "+m"(at.twice));
    return at;
  }
  FN static const float* place(const float* p, const At& at, int lane) { return p + 2 * static_cast<std::size_t>(at.twice[lane]); }
  FN static Texels load(const float* p, const At& at) {
    Texels t;
    for (int k = 0; k < 4; ++k) {
#if defined(__AVX512F__)
      t.row[k] = _mm512_castps128_ps512(_mm_loadu_ps(place(p, at, k)));
      t.row[k] = _mm512_insertf32x4(t.row[k], _mm_loadu_ps(place(p, at, k + 4)), 1);
      t.row[k] = _mm512_insertf32x4(t.row[k], _mm_loadu_ps(place(p, at, k + 8)), 2);
      t.row[k] = _mm512_insertf32x4(t.row[k], _mm_loadu_ps(place(p, at, k + 12)), 3);
#elif defined(__AVX2__)
      t.row[k] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(place(p, at, k))), _mm_loadu_ps(place(p, at, k + 4)), 1);
#else
      __builtin_memcpy(&t.row[k], place(p, at, k), sizeof(Row));
#endif
    }
    return t;
  }
  /// A texel and its right neighbour, mixed.
  FN static Texels pair(const float* p, const At& at, const Weight& weight) {
#if defined(__AVX512F__)
    Texels a, b;  // both in one load
    for (int k = 0; k < 4; ++k) {
      const __m512 first = _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_loadu_ps(place(p, at, k))), _mm256_loadu_ps(place(p, at, k + 4)), 1);
      const __m512 second = _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_loadu_ps(place(p, at, k + 8))), _mm256_loadu_ps(place(p, at, k + 12)), 1);
      a.row[k] = _mm512_shuffle_f32x4(first, second, 0x88);
      b.row[k] = _mm512_shuffle_f32x4(first, second, 0xdd);
    }
    return mixed(a, b, weight);
#else
    return mixed(load(p, at), load(p + 4, at), weight);
#endif
  }
  FN static Weight weights(Float t) {
    const B lane_weights = t.v;
    const Row f = lane_weights;
    return {{spread<0>(f), spread<1>(f), spread<2>(f), spread<3>(f)}};
  }
  FN static Texels mixed(const Texels& a, const Texels& b, const Weight& t) {
    Texels m;
    for (int k = 0; k < 4; ++k) m.row[k] = a.row[k] + (b.row[k] - a.row[k]) * t.row[k];
    return m;
  }
  FN Vec4 channels() const {
    const Row a = unpack_low(row[0], row[1]), b = unpack_high(row[0], row[1]);
    const Row c = unpack_low(row[2], row[3]), d = unpack_high(row[2], row[3]);
    return {Float::of(B(low_halves(a, c))), Float::of(B(high_halves(a, c))), Float::of(B(low_halves(b, d))), Float::of(B(high_halves(b, d)))};
  }
};
using Texel = Texels<Rep>;
// Addresses: max comes first, so that a NaN becomes texel 0. Exact in float below 2^24 texels a slice.
/// Texel at whole-numbered column and row, clamped to the table.
FN Vec4 fetch(const Table2& t, Float column, Float row) {
  const Float x = floor(clamp(column, 0.0, double(t.width - 1))), y = floor(clamp(row, 0.0, double(t.height - 1)));
  return Texel::load(t.texels, Texel::address((y * double(t.width) + x).v)).channels();
}
FN Scalar width_of(const Table2& t) { return Scalar(double(t.width)); }
FN Scalar height_of(const Table2& t) { return Scalar(double(t.height)); }
/// Texel at the same place of another table of the same shape, as a pass's own coordinates name it.
FN Vec4 fetch_same(const Table2& t, Vec2 uv) {
  return fetch(t, uv.x * double(t.width), uv.y * double(t.height));
}
/// Texel at a uniform column and row: the same for all lanes.
FN Scalar4 fetch_scalar(const Table2& t, int column, int row) {
  const Element* p = t.texels + 4 * (std::ptrdiff_t(t.width) * row + column);
  return {double(p[0]), double(p[1]), double(p[2]), double(p[3])};
}
/// Cells of two texels each, their values at the cell's lower and upper end: linear inside a cell, jumps between cells are kept.
/// @param x  which cell, and how far into it: 0 .. width / 2
FN Vec4 lookup_cell(const Table2& t, Float x, int row) {
  const Float y = clamp(x, 0.0, 0.5 * double(t.width));
  const Float i = min(floor(y), 0.5 * double(t.width) - 1.0);
  const Element* p = t.texels + 4 * std::ptrdiff_t(t.width) * row;
  const Float at = i + i;
  return Texel::pair(p, Texel::address(at.v), Texel::weights(y - i)).channels();
}
/// Linear along a row whose first and last texel stand at u = 0 and u = 1.
FN Vec4 lookup_row(const Table2& t, Float u, int row) {
  const Float x = clamp(u, 0.0, 1.0) * double(t.width - 1);
  const Float i = min(floor(x), double(t.width - 2));
  const Element* p = t.texels + 4 * std::ptrdiff_t(t.width) * row;
  return Texel::pair(p, Texel::address(i.v), Texel::weights(x - i)).channels();
}
/// The same of three rows, one below the other, at one place.
FN void lookup_rows(const Table2& t, Float u, int row, Vec4& first, Vec4& second, Vec4& third) {
  const Float x = clamp(u, 0.0, 1.0) * double(t.width - 1);
  const Float i = min(floor(x), double(t.width - 2));
  const std::ptrdiff_t stride = 4 * std::ptrdiff_t(t.width);
  const Element* p = t.texels + stride * row;
  const auto at = Texel::address(i.v);
  const auto across = Texel::weights(x - i);
  first = Texel::pair(p, at, across).channels();
  second = Texel::pair(p + stride, at, across).channels();
  third = Texel::pair(p + 2 * stride, at, across).channels();
}
FN Vec4 bilinear(const Element* p, int width, int height, Float x, Float y) {
  const Float i = min(floor(x), double(width - 2)), j = min(floor(y), double(height - 2));
  const auto at = Texel::address((j * double(width) + i).v);
  const auto across = Texel::weights(x - i);
  return Texel::mixed(Texel::pair(p, at, across), Texel::pair(p + 4 * std::ptrdiff_t(width), at, across), Texel::weights(y - j)).channels();
}
/// Bilinear, texel centres at (i + 0.5) / size, clamped to the edge. Both sizes at least 2.
FN Vec4 lookup(const Table2& t, Vec2 uv) {
  return bilinear(t.texels, t.width, t.height, clamp(uv.x * double(t.width) - 0.5, 0.0, double(t.width - 1)),
                  clamp(uv.y * double(t.height) - 0.5, 0.0, double(t.height - 1)));
}
// The whole part of a division rounds, so x - n floor(x / n) can be exactly n, or just below 0: wrapped again.
FN Float wrapped(Float x, double n) {
  const Float r = clamp(x - n * floor(x * (1.0 / n)), 0.0, n);
  return select(r < n, r, 0.0);
}
/// Bilinear, texel centres at (i + 0.5) / size, the table repeating without end.
FN Vec4 lookup_repeat(const Table2& t, Vec2 uv) {
  const double width = t.width, height = t.height;
  const Float x = wrapped(uv.x * width - 0.5, width), y = wrapped(uv.y * height - 0.5, height);
  const Float i = floor(x), j = floor(y);
  const Float right = select(i < width - 1.0, i + 1.0, 0.0), below = select(j < height - 1.0, j + 1.0, 0.0);
  const auto across = Texel::weights(x - i);
  const auto at = [&](Float column, Float row) { return Texel::load(t.texels, Texel::address((row * width + column).v)); };
  return Texel::mixed(Texel::mixed(at(i, j), at(right, j), across), Texel::mixed(at(i, below), at(right, below), across),
                      Texel::weights(y - j)).channels();
}
/// Trilinear, texel centres at (i + 0.5) / size, clamped to the edge. All sizes at least 2.
FN Vec4 lookup(const Table3& t, Vec3 uvw) {
  const Float x = clamp(uvw.x * double(t.width) - 0.5, 0.0, double(t.width - 1));
  const Float y = clamp(uvw.y * double(t.height) - 0.5, 0.0, double(t.height - 1));
  const Float z = clamp(uvw.z * double(t.depth) - 0.5, 0.0, double(t.depth - 1));
  const Float i = min(floor(x), double(t.width - 2)), j = min(floor(y), double(t.height - 2)), k = min(floor(z), double(t.depth - 2));
  const auto at = Texel::address(((k * double(t.height) + j) * double(t.width) + i).v);
  const auto across = Texel::weights(x - i), along = Texel::weights(y - j);
  const std::ptrdiff_t row = 4 * std::ptrdiff_t(t.width);
  const Element *front = t.texels, *back = front + row * t.height;
  return Texel::mixed(Texel::mixed(Texel::pair(front, at, across), Texel::pair(front + row, at, across), along),
                      Texel::mixed(Texel::pair(back, at, across), Texel::pair(back + row, at, across), along), Texel::weights(z - k)).channels();
}
}  // namespace airlight::AIRLIGHT_TARGET
