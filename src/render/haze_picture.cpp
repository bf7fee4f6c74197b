#include "render/haze_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optics/light_lift.h"
#include "render/air_shadows.h"
#include "render/light_disc.h"

namespace airlight {
namespace {

template <class Work>
void in_parallel(std::size_t count, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
  });
}

}  // namespace

struct HazePicture::Impl {
  const Sky& sky;
  HazeView view;
  HazeSettings settings;
  std::array<double, 4> wavelengths;
  LightLift lift;
  std::vector<LightDisc> discs;

  Impl(const Sky& s, HazeView v, const HazeSettings& how)
      : sky(s),
        view(std::move(v)),
        settings(how),
        wavelengths(s.realtime_wavelengths()),
        lift(light_lift(s.atmosphere(), wavelengths)) {
    if (!settings.sun_disc || !settings.fill_sky) return;
    discs.emplace_back(view.camera, view.faces, settings.sun, sky.atmosphere().sun, wavelengths);
    for (const AirLight& light : settings.more_lights)
      discs.emplace_back(view.camera, view.faces, light.direction, light.sky->atmosphere().sun, wavelengths);
  }

  /// The air before one point; which pixel it is for.
  struct Question {
    std::size_t pixel;
    Sight sight;
  };

  void put(const Question& q, const double* inscatter, const double* transmittance, std::span<float> rgba) const {
    float* pixel = &rgba[4 * q.pixel];
    const bool is_sky = std::isinf(q.sight.distance);
    std::array<double, 4> light{};
    if (is_sky) {
      for (const LightDisc& disc : discs) {
        const auto more = disc.radiance(q.sight.view);
        for (std::size_t k = 0; k < 4; ++k) light[k] += more[k];
      }
    } else {
      light = lift.spectrum({pixel[0], pixel[1], pixel[2]});
    }
    const double covered = std::clamp(double(pixel[3]), 0.0, 1.0), part = is_sky ? 1 - covered : covered;
    for (std::size_t k = 0; k < 4; ++k)
      light[k] = (is_sky ? part : 1) * light[k] * transmittance[k] + part * inscatter[k];
    const auto rgb = lift.srgb(light);
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = float(is_sky ? double(pixel[c]) + rgb[c] : rgb[c]);
    if (is_sky) pixel[3] = 1;
  }

  void rows(int begin, std::span<const float> distance, std::span<float> rgba) const {
    const int width = view.camera.width * view.faces, height = view.camera.height;
    std::vector<Question> objects, skies;
    for (std::size_t i = 0; i < distance.size(); ++i) {
      const double x = double(i % std::size_t(width)), y = begin + double(i / std::size_t(width));
      const auto line = view.look((x + 0.5) / width, (y + 0.5) / height);
      if (!line) continue;
      Sight sight{line->view, double(distance[i]), shadow_offset(x, y, 0)};
      const bool empty = std::isinf(distance[i]);
      if (!empty) objects.push_back({i, sight});
      if (!settings.fill_sky || (!empty && rgba[4 * i + 3] >= 1)) continue;
      if (empty) std::fill_n(&rgba[4 * i], 4, 0.0f);
      sight.distance = std::numeric_limits<double>::infinity();
      skies.push_back({i, sight});
    }
    // Objects first: they are under the sky that is added to their pixels.
    for (const auto* questions : {&objects, &skies}) answer(*questions, rgba);
  }

  void answer(const std::vector<Question>& questions, std::span<float> rgba) const {
    if (questions.empty()) return;
    std::vector<Sight> sights;
    for (const Question& q : questions) sights.push_back(q.sight);
    std::vector<double> inscatter(4 * sights.size()), transmittance(inscatter.size());
    sky.haze(settings.altitude, settings.sun, sights, wavelengths, settings.shadows, inscatter, transmittance);
    add_haze(settings.more_lights, settings.altitude, sights, wavelengths, inscatter);
    in_parallel(questions.size(),
                [&](std::size_t i) { put(questions[i], &inscatter[4 * i], &transmittance[4 * i], rgba); });
  }
};

HazePicture::HazePicture(const Sky& sky, HazeView view, const HazeSettings& settings)
    : impl_(std::make_unique<Impl>(sky, std::move(view), settings)) {}
HazePicture::~HazePicture() = default;

void HazePicture::rows(int begin, std::span<const float> distance, std::span<float> rgba) const {
  impl_->rows(begin, distance, rgba);
}

void mend_edges(int width, int height, std::span<float> distance, std::span<const float> rgba) {
  const std::vector<float> given(distance.begin(), distance.end());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
      const float alpha = rgba[4 * i + 3];
      if (std::isfinite(given[i]) || !(alpha > 0) || alpha >= 1) continue;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
          distance[i] = std::min(distance[i], given[std::size_t(v) * std::size_t(width) + std::size_t(u)]);
    }
  }
}

}  // namespace airlight
