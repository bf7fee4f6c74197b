// Pictures of the sky.
#include <chrono>
#include <cmath>
#include <optional>

#include "airlight/error.h"
#include "engine/stage.h"
#include "optics/colour.h"
#include "sky/camera.h"
#include "sky/channel_colours.h"
#include "sky/checks.h"
#include "sky/frame_blend.h"
#include "sky/sky_impl.h"

namespace airlight {
namespace {

using Row = std::array<double, 3>;

/// The w-th to the last of four, or nothing where there are fewer.
std::array<Row, 4> four_at(const std::vector<Row>& weights, std::size_t w) {
  std::array<Row, 4> four{};
  for (std::size_t k = 0; k < 4 && w + k < weights.size(); ++k) four[k] = weights[w + k];
  return four;
}

void check_picture(const Camera& camera, double ground_radius) {
  check(camera.width >= 1 && camera.width <= 65536, "picture width", camera.width, "1 .. 65536");
  check(camera.height >= 1 && camera.height <= 65536, "picture height", camera.height, "1 .. 65536");
  check_altitude(camera.altitude, ground_radius, {nullptr, "altitude"});
}

void no_wavelengths_for_colours(const Model& model, std::size_t count) {
  if (model.colours && count > 0)
    throw InputError("a picture of " + std::to_string(count) + " wavelengths: expected none: model " +
                     std::string(model.name) + " draws in red, green and blue");
}

}  // namespace

std::vector<Sky::Impl::Draw> Sky::Impl::draws_for(const Camera& camera, const Direction& to_sun, bool sun_disc,
                                                  const Quad& quad,
                                                  const std::array<std::array<double, 3>, 4>& weights) {
  const std::optional<ColourModel>& colours = model->colours;
  const double sun_radius = colours && colours->sun_radius > 0 ? colours->sun_radius : atmosphere.sun.angular_radius;
  Binder b = binder(*model, quad, camera.altitude);
  const Situation s = situation(camera.altitude, datum_for(camera.altitude));
  Fields display{{"disc", {sun_disc ? 1.0 : 0.0}}};
  std::array<double, 4> exponent{};  // a system of colours has a uniform disc
  for (std::size_t k = 0; k < 4 && !colours; ++k) exponent[k] = atmosphere.sun.limb_darkening.at(quad[k]);
  const DiscInPicture disc = disc_in_picture(camera, to_sun, sun_radius, exponent);
  display["disc_gain"].assign(disc.gain.begin(), disc.gain.end());
  display["disc_radius"] = {disc.radius};
  display["disc_edge"] = {disc.edge};
  for (const Row& rgb : weights) {
    display["red"].push_back(rgb[0]);
    display["green"].push_back(rgb[1]);
    display["blue"].push_back(rgb[2]);
  }
  b.set("camera", camera_fields(camera));
  b.set("observer", observer_fields(to_sun, s.altitude));
  b.set("sun_direction", sun_direction_fields(to_sun));
  b.set("display", std::move(display));
  const PassInfo& pass = kernel_pass(model->picture(s));
  const std::vector<Table> inputs = b.inputs(pass);
  std::vector<Draw> frames;
  for (int earlier = gathering().frames - 1; earlier >= 0; --earlier) {
    b.set_earlier(earlier);
    frames.push_back({&pass, b.parameters(pass, {camera.width, camera.height, 1}), inputs});
  }
  return frames;
}

void Sky::Impl::for_each_quad(std::size_t wavelengths, const std::function<void(std::size_t)>& make) const {
  const Stage whole(*engine, 0.0, 1.0);
  for (std::size_t w = 0; w < wavelengths; w += 4) {
    const Stage stage(*engine, w / 4, (wavelengths + 3) / 4);
    make(w);
  }
}

bool Sky::Impl::draw_strips(const Camera& camera, std::span<const Draw> draws, std::size_t channels,
                            const std::function<void(std::size_t, std::span<const float>)>& drawn,
                            const std::function<bool(int, int)>& strip) {
  // A strip of 4 MB stays in the cache until it is written; one that takes long is halved, so that a person can watch and stop.
  int rows = std::max(1, int((std::size_t(1) << 20) / (channels * std::size_t(camera.width))));
  constexpr auto patience = std::chrono::milliseconds(200);
  std::vector<float> rgba;
  for (int begin = 0, next = 0; begin < camera.height; begin = next) {
    const auto start = std::chrono::steady_clock::now();
    const int end = std::min(begin + rows, camera.height);
    rgba.resize(4 * std::size_t(end - begin) * std::size_t(camera.width));
    for (std::size_t d = 0; d < draws.size(); ++d) {
      engine->draw(*draws[d].pass, draws[d].parameters, draws[d].inputs, {camera.width, camera.height, 1}, begin, end,
                   rgba);
      drawn(d, rgba);
    }
    if (!strip(begin, end)) return false;
    next = end;
    if (std::chrono::steady_clock::now() - start > patience) rows = std::max(1, rows / 2);
  }
  return true;
}

bool Sky::render(const Camera& camera, Direction sun, const PictureOptions& options,
                 const std::function<bool(int, int, std::span<const float>)>& strip) const {
  check_picture(camera, impl_->atmosphere.planet.ground_radius);
  const Direction to_sun = checked_unit(sun, {nullptr, "sun"});
  const std::optional<ColourModel>& colours = impl_->model->colours;
  no_wavelengths_for_colours(*impl_->model, options.wavelengths.size());
  std::vector<double> wavelengths = options.wavelengths;
  if (wavelengths.empty()) wavelengths.assign(realtime_quad.begin(), realtime_quad.end());
  const std::vector<Row> weights =
      colours ? primaries(colours->luminance) : srgb_weights(impl_->atmosphere, wavelengths);

  std::vector<Impl::Draw> draws;
  impl_->for_each_quad(wavelengths.size(), [&](std::size_t w) {
    for (Impl::Draw& draw :
         impl_->draws_for(camera, to_sun, options.sun_disc, quad_at(wavelengths, w), four_at(weights, w)))
      draws.push_back(std::move(draw));
  });
  const Gathering gathering = impl_->gathering();
  std::optional<FrameBlend> blend;
  std::vector<float> sum;
  std::span<const float> picture;
  const auto gathered = [&](std::size_t d, std::span<const float> rgba) {
    if (d == 0) blend.emplace(gathering);
    blend->add(rgba);
    if (d + 1 < draws.size()) return;
    sum.resize(rgba.size());
    blend->read(sum);
    picture = sum;
  };
  const auto drawn = [&](std::size_t d, std::span<const float> rgba) {
    if (gathering.frames > 1) return gathered(d, rgba);
    picture = rgba;  // most pictures are one draw, and need no sum
    if (draws.size() == 1) return;
    if (d == 0) sum.assign(rgba.size(), 0);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      for (std::size_t c = 0; c < 3; ++c) sum[i + c] += rgba[i + c];
      sum[i + 3] = 1;
    }
    picture = sum;
  };
  return impl_->draw_strips(camera, draws, 4, drawn, [&](int begin, int end) { return strip(begin, end, picture); });
}

bool Sky::render_spectral(const Camera& camera, Direction sun, const PictureOptions& options,
                          const std::function<bool(int, int, std::span<const float>)>& strip) const {
  check_picture(camera, impl_->atmosphere.planet.ground_radius);
  const Direction to_sun = checked_unit(sun, {nullptr, "sun"});
  if (impl_->model->colours)
    throw InputError("a spectral picture: model " + std::string(impl_->model->name) + " draws in red, green and blue");
  std::vector<double> wavelengths = options.wavelengths;
  if (wavelengths.empty()) wavelengths.assign(realtime_quad.begin(), realtime_quad.end());
  const std::size_t W = wavelengths.size();

  // A picture has three channels: each four wavelengths are drawn twice, for the first three and for the last.
  std::vector<Impl::Draw> draws;
  std::vector<std::size_t> first;  // wavelength in a draw's red
  impl_->for_each_quad(W, [&](std::size_t w) {
    const Quad quad = quad_at(wavelengths, w);
    draws.push_back(
        impl_->draws_for(camera, to_sun, options.sun_disc, quad, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}})
            .front());
    first.push_back(w);
    if (w + 3 >= W) return;
    draws.push_back(
        impl_->draws_for(camera, to_sun, options.sun_disc, quad, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}})
            .front());
    first.push_back(w + 3);
  });
  std::vector<float> values;
  const auto drawn = [&](std::size_t d, std::span<const float> rgba) {
    values.resize(rgba.size() / 4 * W);
    const std::size_t channels = std::min(d % 2 == 0 ? std::size_t(3) : std::size_t(1), W - first[d]);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i)
      for (std::size_t c = 0; c < channels; ++c) values[i * W + first[d] + c] = rgba[4 * i + c];
  };
  return impl_->draw_strips(camera, draws, std::max<std::size_t>(W, 4), drawn,
                            [&](int begin, int end) { return strip(begin, end, values); });
}

}  // namespace airlight
