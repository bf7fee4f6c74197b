// The lenses that commands know by name.
#pragma once
#include <string_view>

#include "airlight/camera.h"
#include "number.h"

namespace airlight::cli {

struct Lens {
  std::string_view name;
  Projection projection;
  int width;                        ///< when no size is said [pixels]
  double height_over_width;         ///< when a width alone is said
  double elevation, field_of_view;  ///< when not said [degrees]
  Interval legal_view;

  bool has_one_view() const { return legal_view.low == legal_view.high; }
};

/// "perspective", "fisheye", "equirectangular" or "cube". @throws InputError with "did you mean".
const Lens& lens_named(std::string_view option, std::string_view name);
const Lens& lens_of(Projection projection);
/// @throws InputError "--field-of-view (of fisheye) = 400: expected 1 .. 360 degrees"
void check_field_of_view(const Lens& lens, double degrees);

}  // namespace airlight::cli
