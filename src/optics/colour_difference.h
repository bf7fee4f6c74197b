// How different two colours look.
#pragma once
#include <array>

#include "optics/colour.h"

namespace airlight {

/// CIE 1976 L*, a*, b*.
using Lab = std::array<double, 3>;

/// @param xyz  of a white of luminance 1; the white is D65
Lab lab_of(const Xyz& xyz);

/// CIEDE2000 with all parametric factors 1: 1 is about what an eye can just tell apart, side by side.
/// Source: Sharma, Wu & Dalal 2005, Color Research & Application 30, 21 (equations 2 to 22).
double ciede2000(const Lab& a, const Lab& b);

/// CIEDE2000 of two lights shown at the exposure that makes the first a middle grey (18.4 %, L* = 50), whatever their brightness:
/// so twilight is judged as day is, by an eye used to it. 0 where the first is black.
double colour_difference(const Xyz& truth, const Xyz& value);

}  // namespace airlight
