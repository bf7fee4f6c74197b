// Pictures of the sky.
#include <chrono>
#include <cmath>

#include "airlight/error.h"
#include "optics/colour.h"
#include "sky/camera.h"
#include "sky/checks.h"
#include "sky/sky_impl.h"

namespace airlight {
namespace {

/// What a unit of each of four channels adds to linear sRGB [cd/m^2].
std::vector<std::array<double, 3>> srgb_weights(const Atmosphere& atmosphere, std::span<const double> wavelengths) {
  std::vector<std::array<double, 3>> weights;
  for (const Xyz& xyz : colour_weights(atmosphere, wavelengths)) weights.push_back(xyz_to_srgb(xyz));
  return weights;
}
/// The channels are red, green and blue already.
std::vector<std::array<double, 3>> primaries(double luminance) {
  return {{luminance, 0, 0}, {0, luminance, 0}, {0, 0, luminance}, {0, 0, 0}};
}

}  // namespace

bool Sky::render(const Camera& camera, Direction sun, const PictureOptions& options,
                 const std::function<bool(int, int, std::span<const float>)>& strip) const {
  check(camera.width >= 1 && camera.width <= 65536, "picture width", camera.width, "1 .. 65536");
  check(camera.height >= 1 && camera.height <= 65536, "picture height", camera.height, "1 .. 65536");
  check_altitude(camera.altitude, impl_->atmosphere.planet.ground_radius, {nullptr, "altitude"});
  const Direction to_sun = checked_unit(sun, {nullptr, "sun"});
  const std::optional<ColourModel>& colours = impl_->model->colours;
  if (colours && !options.wavelengths.empty())
    throw InputError("a picture of " + std::to_string(options.wavelengths.size()) +
                     " wavelengths: expected none: model " + std::string(impl_->model->name) +
                     " draws in red, green and blue");
  std::vector<double> wavelengths = options.wavelengths;
  if (wavelengths.empty()) wavelengths.assign(realtime_quad.begin(), realtime_quad.end());
  if (wavelengths.size() % 4)
    throw InputError("a picture of " + std::to_string(wavelengths.size()) +
                     " wavelengths: expected a multiple of four");
  const std::vector<std::array<double, 3>> weights =
      colours ? primaries(colours->luminance) : srgb_weights(impl_->atmosphere, wavelengths);

  const double sun_radius =
      colours && colours->sun_radius > 0 ? colours->sun_radius : impl_->atmosphere.sun.angular_radius;

  struct Draw {
    const PassInfo* pass;
    std::vector<double> parameters;
    std::vector<Table> inputs;
  };
  const Shape shape{camera.width, camera.height, 1};
  std::vector<Draw> draws;
  for (std::size_t w = 0; w < wavelengths.size(); w += 4) {
    const Quad quad = quad_at(wavelengths, w);
    Binder b = impl_->binder(*impl_->model, quad, camera.altitude);
    const Situation s = impl_->situation(camera.altitude, Impl::datum_for(camera.altitude));
    Fields display{{"disc", {options.sun_disc ? 1.0 : 0.0}}};
    std::array<double, 4> exponent{};  // a system of colours has a uniform disc
    for (std::size_t k = 0; k < 4 && !colours; ++k) exponent[k] = impl_->atmosphere.sun.limb_darkening.at(quad[k]);
    const DiscInPicture disc = disc_in_picture(camera, to_sun, sun_radius, exponent);
    display["disc_gain"].assign(disc.gain.begin(), disc.gain.end());
    display["disc_radius"] = {disc.radius};
    display["disc_edge"] = {disc.edge};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& rgb = weights[w + k];
      display["red"].push_back(rgb[0]);
      display["green"].push_back(rgb[1]);
      display["blue"].push_back(rgb[2]);
    }
    b.set("camera", camera_fields(camera));
    b.set("observer", observer_fields(to_sun, s.altitude));
    b.set("sun_direction", Fields{{"direction", {to_sun[0], to_sun[1], to_sun[2], 0}}});
    b.set("display", std::move(display));
    const PassInfo& pass = kernel_pass(impl_->model->picture(s));
    draws.push_back({&pass, b.parameters(pass, shape), b.inputs(pass)});
  }

  // A strip of 4 MB stays in the cache until it is written; one that takes long is halved, so that a person can watch and stop.
  int rows = std::max(1, (1 << 18) / camera.width);
  constexpr auto patience = std::chrono::milliseconds(200);
  std::vector<float> rgba, more;
  for (int begin = 0, next = 0; begin < camera.height; begin = next) {
    const auto start = std::chrono::steady_clock::now();
    const int end = std::min(begin + rows, camera.height);
    rgba.resize(4 * std::size_t(end - begin) * std::size_t(camera.width));
    more.resize(draws.size() > 1 ? rgba.size() : 0);
    for (std::size_t d = 0; d < draws.size(); ++d) {
      impl_->engine->draw(*draws[d].pass, draws[d].parameters, draws[d].inputs, shape, begin, end,
                          d == 0 ? rgba : more);
      if (d > 0) {
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
          for (std::size_t c = 0; c < 3; ++c) rgba[i + c] += more[i + c];
        }
      }
    }
    if (!strip(begin, end, rgba)) return false;
    next = end;
    if (std::chrono::steady_clock::now() - start > patience) rows = std::max(1, rows / 2);
  }
  return true;
}

}  // namespace airlight
