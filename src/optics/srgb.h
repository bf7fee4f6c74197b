// The sRGB encoding of one value in 0..1 (IEC 61966-2-1), on the host.
#pragma once
#include <cmath>

namespace airlight {

inline double decode_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
inline double encode_srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

}  // namespace airlight
