#include "lens.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "picture_outputs.h"

namespace airlight::cli {
namespace {

constexpr Lens lenses[] = {
    {"perspective", Projection::perspective, 1280, 0.5625, 0, 90, {0.1, 170, "degrees"}},
    {"fisheye", Projection::fisheye, 1024, 1, 90, 180, {1, 360, "degrees"}},
    {"equirectangular", Projection::equirectangular, 2048, 0.5, 0, 360, {360, 360, "degrees"}},
    {"cube", Projection::cube, 512, 1, 0, 90, {90, 90, "degrees"}},
};

}  // namespace

const Lens& lens_named(std::string_view option, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Lens& lens : lenses) names.push_back(lens.name);
  return lenses[choose(option, name, names)];
}

const Lens& lens_of(Projection projection) { return *std::ranges::find(lenses, projection, &Lens::projection); }

void check_field_of_view(const Lens& lens, double degrees) {
  check_number(degrees, fmt::format("--field-of-view (of {})", lens.name), lens.legal_view);
}

}  // namespace airlight::cli
