// Compiled once per target and group of kernels (or "every_group.inc" at once), with
//   -DAIRLIGHT_SET=<set>  -DAIRLIGHT_TARGET=<group>_<set>  -DAIRLIGHT_REP=<number type>  -DAIRLIGHT_GROUP="<group>.inc"
// and that target's machine flags. Nothing outside the namespace may be defined but one constant table a group, at the end.
#include "engine/cpu/target.h"

#include "prelude/prelude.hpp"

namespace airlight::AIRLIGHT_TARGET {

// A struct is nothing but Scalars: its numbers arrive as doubles in the kernel's order.
template <class Struct>
static void unpack(const double* numbers, Struct& into) {
  static_assert(sizeof(Struct) % (4 * sizeof(Element)) == 0, "std140");
  Element* e = reinterpret_cast<Element*>(&into);
  for (unsigned i = 0; i < sizeof(Struct) / sizeof(Element); ++i) e[i] = static_cast<Element>(numbers[i]);
}
static inline Table2 make_Table2(const TableView& t) {
  return {static_cast<const Element*>(t.texels), t.width, t.height};
}
[[maybe_unused]] static inline Table3 make_Table3(const TableView& t) {
  return {static_cast<const Element*>(t.texels), t.width, t.height, t.depth};
}

FN Float load(const Element* e) {
  Float f;
  __builtin_memcpy(&f, e, sizeof f);
  return f;
}

// ---- functions: `lanes` sets of arguments at a time; the last batch repeats its last set ----
struct Batch {
  const EvalArguments& a;
  int at;
  Float get(int component) const {
    alignas(64) Element e[lanes];
    for (int i = 0; i < lanes; ++i) {
      const int set = at + i < a.count ? at + i : a.count - 1;
      e[i] = static_cast<Element>(a.varying[static_cast<long>(component) * a.count + set]);
    }
    return load(e);
  }
};
FN void put(const Batch& b, int component, Float value) {
  const Element* e = reinterpret_cast<const Element*>(&value);
  for (int i = 0; i < lanes && b.at + i < b.a.count; ++i)
    b.a.results[static_cast<long>(component) * b.a.count + b.at + i] = e[i];
}
[[maybe_unused]] FN void put(const Batch& b, int at, Bool value) { put(b, at, select(value, Float(1.0), Float(0.0))); }
[[maybe_unused]] FN void put(const Batch& b, int at, Vec2 v) {
  put(b, at, v.x);
  put(b, at + 1, v.y);
}
[[maybe_unused]] FN void put(const Batch& b, int at, Vec3 v) {
  put(b, at, v.x);
  put(b, at + 1, v.y);
  put(b, at + 2, v.z);
}
[[maybe_unused]] FN void put(const Batch& b, int at, Vec4 v) {
  put(b, at, v.x);
  put(b, at + 1, v.y);
  put(b, at + 2, v.z);
  put(b, at + 3, v.w);
}

// ---- passes ----
template <class T>
FN void store_texels(T* rgba, const Vec4& v, int count) {
  const Element* x = reinterpret_cast<const Element*>(&v.x);
  const Element* y = reinterpret_cast<const Element*>(&v.y);
  const Element* z = reinterpret_cast<const Element*>(&v.z);
  const Element* w = reinterpret_cast<const Element*>(&v.w);
  for (int i = 0; i < count; ++i) {
    rgba[4 * i] = static_cast<T>(x[i]);
    rgba[4 * i + 1] = static_cast<T>(y[i]);
    rgba[4 * i + 2] = static_cast<T>(z[i]);
    rgba[4 * i + 3] = static_cast<T>(w[i]);
  }
}
template <class Shade>
static void for_each_texel(const PassArguments& a, const Shade& shade) {
  alignas(64) Element ramp[lanes];
  for (int i = 0; i < lanes; ++i) ramp[i] = static_cast<Element>(i + 0.5);
  const Float offsets = load(ramp);
  for (int row = a.row_begin; row < a.row_end; ++row) {
    const int y = row % a.height, slice = row / a.height;
    const Float v = (y + 0.5) / a.height, w = (slice + 0.5) / a.depth;
    for (int x = 0; x < a.width; x += lanes) {
      // Lanes past the end compute the coordinates beyond 1 and are dropped.
      const Vec3 coordinates((offsets + double(x)) * (1.0 / a.width), v, w);
      Vec4 outputs[4];
      shade(coordinates, outputs);
      const int count = a.width - x < lanes ? a.width - x : lanes;
      for (int k = 0; k < a.output_count; ++k) {
        if (a.to_float) {
          store_texels(static_cast<float*>(a.outputs[k]) + 4 * (static_cast<long>(row - a.row_begin) * a.width + x),
                       outputs[k], count);
        } else {
          store_texels(static_cast<Element*>(a.outputs[k]) + 4 * (static_cast<long>(row) * a.width + x), outputs[k],
                       count);
        }
      }
    }
  }
}

#include AIRLIGHT_GROUP

}  // namespace airlight::AIRLIGHT_TARGET

#define AIRLIGHT_JOIN2(a, b) a##b
#define AIRLIGHT_JOIN(a, b) AIRLIGHT_JOIN2(a, b)
#define AIRLIGHT_EXPORT(group)                                                                   \
  extern const KernelTarget AIRLIGHT_JOIN(target_##group##_, AIRLIGHT_SET);                      \
  constinit const KernelTarget AIRLIGHT_JOIN(target_##group##_, AIRLIGHT_SET) = {                \
      AIRLIGHT_TARGET::lanes, sizeof(AIRLIGHT_TARGET::Element), AIRLIGHT_TARGET::passes_##group, \
      AIRLIGHT_TARGET::evals_##group};
namespace airlight {
AIRLIGHT_GROUPS(AIRLIGHT_EXPORT)
}  // namespace airlight
