#pragma once
// From linear light to a display: exposed linear sRGB in (1.0 = display white before the curve, 0.18 = middle grey), display
// linear sRGB in 0..1 out, and the sRGB encoding. Any input is allowed: negative (outside the gamut), huge (the sun), NaN.

/// Luminance of linear sRGB [1], IEC 61966-2-1.
/// @param rgb [1] in 0..4
FN Float tone_luminance(Vec3 rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

/// Part of the way from a grey to a component at which it meets the end of 0..1 [1]; 1 where it stays inside.
/// @param grey [1] in 0..1
/// @param component [1] in -2..3
/// @bound 2e-5 scale 1
FN Float tone_reach(Float grey, Float component) {
  Float apart = component - grey;
  Float room = select(apart > 0.0, 1.0 - grey, grey);
  return min(room / max(abs(apart), 1.0e-20), 1.0);
}

/// Nearest colour inside 0..1 on the straight line to the grey of the same luminance [1]: hue and luminance stay, saturation falls.
/// @param rgb [1] in -1..2
/// @bound 2e-5 scale 1
FN Vec3 tone_into_gamut(Vec3 rgb) {
  Float grey = clamp(tone_luminance(rgb), 0.0, 1.0);
  Float t = min(tone_reach(grey, rgb.x), min(tone_reach(grey, rgb.y), tone_reach(grey, rgb.z)));
  return Vec3(clamp(mix(grey, rgb.x, t), 0.0, 1.0), clamp(mix(grey, rgb.y, t), 0.0, 1.0), clamp(mix(grey, rgb.z, t), 0.0, 1.0));
}

/// Colour with no component below 0 or above 1e6 [1]: negative ones are lifted by moving towards the grey of the same luminance.
/// @param rgb [1] in -1..10
/// @bound 2e-5 scale 1
FN Vec3 tone_without_negatives(Vec3 rgb) {
  Float r = clamp(rgb.x, -1.0e6, 1.0e6);
  Float g = clamp(rgb.y, -1.0e6, 1.0e6);
  Float b = clamp(rgb.z, -1.0e6, 1.0e6);
  Float grey = max(tone_luminance(Vec3(r, g, b)), 0.0);
  Float low = min(r, min(g, b));
  Float t = select(low < 0.0, grey / max(grey - low, 1.0e-20), 1.0);
  return Vec3(max(mix(grey, r, t), 0.0), max(mix(grey, g, t), 0.0), max(mix(grey, b, t), 0.0));
}

/// Film-like response of one exposure [1]: x^1.4 / (x^1.4 + 0.413), 0 to 0, 0.18 to 0.18, infinity to 1.
///
/// The response of photoreceptors (Naka & Rushton 1966) with two numbers chosen here: the exponent gives a slope of
/// 1.4 (1 - 0.18) = 1.15 in log-log at middle grey, a print's contrast, and a toe; 0.413 = 0.18^1.4 (1 / 0.18 - 1) keeps
/// middle grey. The shoulder is long: 4 stops above grey give 0.92, 8 stops 0.998, so the sun's surroundings are not flat.
/// @param x [1] in 1e-4..1e4 log
/// @bound 2e-5 scale 1
FN Float tone_response(Float x) {
  Float p = power(clamp(x, 0.0, 1.0e6), 1.4);
  return p / (p + 0.41301);
}

/// Filmic tone curve [1]: the largest component goes through tone_response, the others keep their ratio to it; near white they catch up.
///
/// The smallest component moves from that ratio to its own tone_response as the 8th power of the largest one's, so colours keep
/// their saturation through the curve's middle, and light far above white (the sun, its aureole) turns white. The one in between
/// keeps its place, so the hue stays (in the sense of HSV) and nothing leaves 0..1. A curve on each channel instead would
/// turn a sunset's orange into yellow, and one on luminance leaves the gamut.
/// @param rgb [1] in -0.5..20
/// @bound 2e-5 scale 1
FN Vec3 tone_filmic(Vec3 rgb) {
  Vec3 c = tone_without_negatives(rgb);
  Float low = min(c.x, min(c.y, c.z));
  Float high = max(c.x, max(c.y, c.z));
  Float high_out = tone_response(high);
  Float p2 = high_out * high_out;
  Float p4 = p2 * p2;
  // Beyond white, a hundredth of the strongest channel reaches the weakest: a low sun has no blue at all, and would stand as a
  // deep orange spot, darker than the glow around it.
  Float low_out = mix(low * (high_out / max(high, 1.0e-20)), tone_response(low + 0.01 * max(high - 1.0, 0.0)), p4 * p4);
  Float scale = (high_out - low_out) / max(high - low, 1.0e-20);
  return Vec3(low_out + (c.x - low) * scale, low_out + (c.y - low) * scale, low_out + (c.z - low) * scale);
}

/// Reinhard's curve on luminance [1]: L (1 + L / white^2) / (1 + L), L = white gives 1; what then lies outside 0..1 moves to its grey.
///
/// Reinhard, Stark, Shirley & Ferwerda 2002, doi:10.1145/566654.566575, equation 4.
/// @param rgb [1] in -0.5..20
/// @param white [1] in 1..100  luminance that becomes display white
/// @bound 2e-5 scale 1
FN Vec3 tone_reinhard(Vec3 rgb, Scalar white) {
  Vec3 c = tone_without_negatives(rgb);
  Float luminance = tone_luminance(c);
  // min: beyond white all is white, and L^2 of the sun would leave the curve's range.
  Float scale = min((1.0 + luminance * (1.0 / (white * white))) / (1.0 + luminance), 1.0 / max(luminance, 1.0e-20));
  return tone_into_gamut(c * scale);
}

/// sRGB encoding of display-linear light [1]; IEC 61966-2-1.
/// @param light [1] in 0..1
/// @bound 2e-5 scale 1
FN Float srgb_encode(Float light) {
  Float x = clamp(light, 0.0, 1.0);
  return select(x <= 0.0031308, 12.92 * x, 1.055 * power(x, 0.416666667) - 0.055);
}
