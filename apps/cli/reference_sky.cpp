#include "reference_sky.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "airlight/error.h"
#include "commands.h"
#include "image/output_file.h"
#include "interrupt.h"
#include "optics/colour.h"
#include "reference/random_picture.h"

namespace airlight::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// All that the picture depends on, as text: sums of another picture are not to be added to.
std::string fingerprint(const ReferenceSky& sky) {
  nlohmann::ordered_json text;
  for (const auto& [name, value] : sky.metadata)
    std::visit([&, &key = name](const auto& said) { text[key] = said; }, value);
  text["width"] = sky.camera.width;
  text["walks in a pass"] = reference::RandomPicture::walks_in_a_pass;
  text["height"] = sky.camera.height;
  text["sun"] = sky.sun;
  text["planet"] = {sky.atmosphere.planet.ground_radius, sky.atmosphere.planet.top_altitude,
                    sky.atmosphere.sun.angular_radius};
  auto& air = text["air"];
  for (const double wavelength : sky.wavelengths)
    air.push_back({sky.atmosphere.planet.albedo.at(wavelength), sky.atmosphere.sun.irradiance.at(wavelength)});
  for (const Constituent& constituent : sky.atmosphere.constituents) {
    for (const double wavelength : sky.wavelengths)
      air.push_back({constituent.scattering.at(wavelength), constituent.absorption.at(wavelength)});
    for (const double altitude : {0.0, 1e3, 3e3, 1e4, 3e4, 1e5}) air.push_back(density(constituent.profile, altitude));
    for (const double one_minus_cos : {0.0, 0.01, 0.3, 1.0, 2.0})
      air.push_back(phase_function(constituent.phase, one_minus_cos));
  }
  return text.dump();
}

reference::PictureQuestion question(const ReferenceSky& sky) {
  reference::PictureQuestion question{sky.atmosphere,    sky.width(),
                                      sky.camera.height, {},
                                      sky.wavelengths,   colour_weights(sky.atmosphere, sky.wavelengths)};
  question.ray = [base = sky.camera, sun = sky.sun](int column, int y) -> std::optional<Ray> {
    Camera camera = base;  // several threads ask
    camera.face = column / camera.width;
    const int x = column % camera.width;
    const double u = (x + 0.5) / camera.width, v = (y + 0.5) / camera.height;
    if (camera.projection == Projection::fisheye && std::hypot(u - 0.5, v - 0.5) > 0.5) return std::nullopt;
    return Ray{.altitude = camera.altitude, .view = view_direction(camera, u, v), .sun = sun};
  };
  return question;
}

/// One line on the terminal, rewritten; nothing where standard error is no terminal.
class Status {
 public:
  ~Status() {
    if (visible_) fmt::print(stderr, "\r\033[K");
  }
  void show(const std::string& text) {
    const auto now = Clock::now();
    if (!terminal_ || now - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = now;
    visible_ = true;
    fmt::print(stderr, "\r{}\033[K", text);
    std::fflush(stderr);
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) == 1, visible_ = false;
  Clock::time_point shown_{};
};

template <class Pixel>
void write(const std::string& path, const ReferenceSky& sky, const PictureFormat& format, const Metadata& metadata,
           Pixel pixel) {
  PictureFile file(path, sky.width(), sky.camera.height, format, metadata);
  std::vector<float> row(std::size_t(sky.width()) * 4);
  for (int y = 0; y < sky.camera.height; ++y) {
    for (int x = 0; x < sky.width(); ++x) {
      const std::array<double, 3> rgb = pixel(x, y);
      for (int c = 0; c < 3; ++c) row[4 * x + c] = float(rgb[c]);
      row[4 * x + 3] = 1;
    }
    file.write_rows(y, y + 1, row);
  }
  file.finish();
}

void write_pictures(const ReferenceSky& sky, const reference::RandomPicture& picture, const std::string& error_file) {
  Metadata metadata = sky.metadata;
  metadata.push_back({"walks a pixel", double(picture.passes()) * reference::RandomPicture::walks_in_a_pass});
  // Before there are enough passes, no error is known.
  if (std::isfinite(picture.median_error()))
    metadata.push_back({"standard error / luminance, median", picture.median_error()});
  for (const std::string& path : sky.outputs)
    write(path, sky, sky.format, metadata, [&](int x, int y) { return xyz_to_srgb(picture.xyz(x, y)); });
  metadata.push_back({"content", "standard error / luminance"});
  PictureFormat full;
  full.half = false;
  write(error_file, sky, full, metadata, [&](int x, int y) {
    const double error = picture.error(x, y);
    return std::array{error, error, error};
  });
}

void save(const std::string& path, const std::string& header, const reference::RandomPicture& picture) {
  std::ostringstream text;
  text << header << '\n';
  picture.save(text);
  OutputFile file(path);
  file.write(text.str());
  file.commit();
}

void resume(const std::string& path, const std::string& header, reference::RandomPicture& picture) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) return;
  if (line != header || !picture.load(file))
    throw InputError(fmt::format("{}: holds the walks of another picture; remove it, or name another output", path));
  fmt::print(stderr, "{}: going on after {} passes\n", path, picture.passes());
}

}  // namespace

int render_reference_sky(ReferenceSky sky) {
  if (sky.wavelengths.empty()) sky.wavelengths.assign(realtime_quad.begin(), realtime_quad.end());
  const std::string& name = sky.outputs.front();
  const std::string base = name.substr(0, name.rfind('.')), walks_file = base + ".walks",
                    error_file = base + ".error.exr";
  const std::string header = fingerprint(sky);
  reference::RandomPicture picture(question(sky));
  resume(walks_file, header, picture);

  const auto started = Clock::now();
  const int before = picture.passes();
  constexpr int least_passes = 4;
  {
    Status status;
    double error = picture.median_error();
    while (error > sky.target_error) {
      const double wanted =
          std::isinf(error)
              ? least_passes
              : std::max(picture.passes() + 1.0, std::ceil(picture.passes() * std::pow(error / sky.target_error, 2)));
      const auto look = [&](double done) {
        check_interrupt();
        const double passes = picture.passes() + done,
                     spent = std::chrono::duration<double>(Clock::now() - started).count();
        status.show(fmt::format("sky: pass {} of {}{:.0f}, {}about {:.0f} s left", picture.passes() + 1,
                                std::isinf(error) ? "at least " : "about ", wanted,
                                std::isinf(error) ? std::string() : fmt::format("median error {:.2f} %, ", 100 * error),
                                spent / std::max(passes - before, 1e-3) * (wanted - passes)));
      };
      try {
        picture.add_pass(look);
      } catch (const Interrupted&) {
        if (picture.passes() == 0) throw;
        throw Interrupted(fmt::format("{} holds {} passes; start again to go on", walks_file, picture.passes()));
      }
      save(walks_file, header, picture);
      write_pictures(sky, picture, error_file);
      error = picture.median_error();
    }
    if (picture.passes() == before) write_pictures(sky, picture, error_file);
  }
  std::remove(walks_file.c_str());
  fmt::print(stderr, "{}: {} x {}, {}, reference, {} walks a pixel, median error {:.2f} % (each in {}); {:.1f} s\n",
             name, sky.width(), sky.camera.height, sky.atmosphere.name,
             picture.passes() * reference::RandomPicture::walks_in_a_pass, 100 * picture.median_error(), error_file,
             std::chrono::duration<double>(Clock::now() - started).count());
  return ok;
}

}  // namespace airlight::cli
