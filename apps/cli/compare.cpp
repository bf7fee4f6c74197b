// `airlight compare`: one view by several models, how far they are from one of them, and what they cost.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "image/contact_sheet.h"
#include "image/tone.h"
#include "interrupt.h"
#include "model/model.h"
#include "number.h"
#include "optics/colour.h"
#include "processor_time.h"
#include "progress.h"
#include "scene_render.h"
#include "text_output.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
  std::string scene, models = "all", yardstick = "single", folder;
  std::optional<double> scale;
  ScenePictureOptions picture;
};

/// What one model made of the scene.
struct Result {
  std::string model;
  int width = 0, height = 0;
  std::vector<float> rgb;       ///< linear sRGB [cd/m^2]
  double ready = 0, drawn = 0;  ///< processor time until the first pixel, land included, and for the pixels [s]
  double scale = 1;             ///< that brought a published system's relative colours to the yardstick's sky
  Metadata metadata;
  struct Error {
    double median = 0, mean = 0, most = 0, worst = 0;  ///< of luminance, relative: most is the 95th percentile
    double colour = 0;                                 ///< median distance in the CIE 1976 (u', v') diagram
  } error;
};

std::array<double, 3> pixel(const Result& result, std::size_t i) {
  return {double(result.rgb[3 * i]), double(result.rgb[3 * i + 1]), double(result.rgb[3 * i + 2])};
}

/// CIE 1976 chromaticity of linear sRGB.
std::array<double, 2> chromaticity(const std::array<double, 3>& rgb) {
  const auto [x, y, z] = srgb_to_xyz(rgb);
  const double sum = x + 15 * y + 3 * z;
  return {4 * x / sum, 9 * y / sum};
}

/// (value - yardstick) / yardstick of each pixel's luminance; what is a ten-thousandth of the brightest and less counts as that.
std::vector<double> differences(const Result& result, const Result& yardstick) {
  std::vector<double> out(result.rgb.size() / 3);
  double brightest = 0;
  for (std::size_t i = 0; i < out.size(); ++i) brightest = std::max(brightest, luminance(pixel(yardstick, i)));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double b = luminance(pixel(yardstick, i));
    out[i] = brightest > 0 ? (luminance(pixel(result, i)) - b) / std::max(b, 1e-4 * brightest) : 0;
  }
  return out;
}

double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + std::ptrdiff_t(part * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// @param counted  the pixels that errors are of
Result::Error error_of(const Result& result, const Result& yardstick, const std::vector<double>& difference,
                       const std::vector<char>& counted) {
  std::vector<double> size, colour;
  double sum = 0;
  for (std::size_t i = 0; i < difference.size(); ++i) {
    if (!counted[i]) continue;
    sum += difference[i];
    size.push_back(std::abs(difference[i]));
    const auto a = pixel(result, i), b = pixel(yardstick, i);
    if (!(luminance(a) > 0 && luminance(b) > 0)) continue;
    const auto p = chromaticity(a), q = chromaticity(b);
    colour.push_back(std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  return {quantile(size, 0.5), sum / double(size.size()), quantile(size, 0.95), quantile(size, 1),
          colour.empty() ? 0 : quantile(colour, 0.5)};
}

/// Brings a picture in relative colours to the yardstick's brightness: the geometric mean of the sky's luminance, which the Sun's disc hardly
/// moves, becomes the same. A black sky stays as it is.
void scale_to(const Result& yardstick, const std::vector<char>& sky, Result& result) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < sky.size(); ++i) {
    const double a = luminance(pixel(result, i)), b = luminance(pixel(yardstick, i));
    if (!(sky[i] && a > 0 && b > 0)) continue;
    sum += std::log(b / a);
    ++count;
  }
  if (count == 0) return;
  result.scale = std::exp(sum / count);
  for (float& v : result.rgb) v = float(double(v) * result.scale);
  result.metadata.push_back({"scaled to the yardstick's sky by", result.scale});
}

BytePicture developed(const Result& result, double exposure_ev, ToneCurve curve) {
  BytePicture picture{result.width, result.height, std::vector<std::uint8_t>(result.rgb.size())};
  const auto row = 3 * std::size_t(result.width);
  for (int y = 0; y < result.height; ++y)
    encode_row(std::span(result.rgb).subspan(std::size_t(y) * row, row), y, exposure_ev, curve,
               std::span(picture.rgb).subspan(std::size_t(y) * row, row));
  return picture;
}

/// White: equal; red: brighter than the yardstick, full at `scale`; blue: darker; grey: not counted.
BytePicture difference_map(const Result& result, const std::vector<double>& difference,
                           const std::vector<char>& counted, double scale) {
  BytePicture picture{result.width, result.height, {}};
  for (std::size_t i = 0; i < difference.size(); ++i) {
    if (!counted[i]) {
      picture.rgb.insert(picture.rgb.end(), 3, 160);
      continue;
    }
    const double t = std::clamp(difference[i] / scale, -1.0, 1.0);
    const auto fade = std::uint8_t(std::lround(255 * (1 - std::abs(t))));
    const std::uint8_t red = t >= 0 ? 255 : fade, blue = t >= 0 ? fade : 255;
    picture.rgb.insert(picture.rgb.end(), {red, fade, blue});
  }
  return picture;
}

/// @param sky  which pixels are sky: found for the first model, the yardstick
/// @throws InputError where the model cannot draw the scene
Result draw(const Scene& scene, const std::string& model, const std::shared_ptr<const Land>& land,
            const std::string& engine, bool sun_disc, std::vector<char>& sky, Progress& progress, double from,
            double to) {
  Scene own = scene;
  own.picture.model = model;
  Result result;
  result.model = model;
  const double start = processor_time();
  // An engine of its own: nobody finds the tables that another has made.
  const SceneShot shot(own, land, engine_named(engine), sun_disc);
  result.width = shot.width(), result.height = shot.height();
  result.metadata = shot.metadata();
  result.ready = processor_time() - start;
  const bool whole = shot.rows([&](int end, std::span<const float> rgb) {
    result.rgb.insert(result.rgb.end(), rgb.begin(), rgb.end());
    progress.show(from + (to - from) * end / shot.height());
    return !interrupted();
  });
  if (!whole) throw Interrupted{};
  result.drawn = processor_time() - start - result.ready;
  if (sky.empty()) sky = shot.sky_pixels();
  return result;
}

struct Chosen {
  std::vector<std::string> names;  ///< the yardstick first
  bool all = false;                ///< those that cannot draw the scene are left out
};

Chosen chosen_models(const CompareOptions& options) {
  Chosen chosen;
  chosen.all = options.models == "all";
  check_model_name(options.yardstick, "--yardstick", model_names());
  chosen.names.push_back(options.yardstick);
  std::vector<std::string> named;
  if (chosen.all) {
    for (const Model& model : all_models())
      if (model.under_the_sun) named.emplace_back(model.name);
  } else {
    for (const std::string_view name : comma_separated(options.models)) named.emplace_back(name);
  }
  for (const std::string& name : named) {
    if (!chosen.all) check_model_name(name, "--models", model_names());
    if (name != options.yardstick) {
      if (std::ranges::find(chosen.names, name) != chosen.names.end())
        throw InputError("--models: " + name + " is named twice");
      chosen.names.push_back(name);
    }
  }
  return chosen;
}

std::string percent(double part) { return fmt::format("{:.2f}", 100 * part); }

/// The same table for people and for programs.
void write_tables(const std::string& folder, const std::vector<Result>& results) {
  const std::vector<std::string> head{"model",          "median error [%]",    "95 % of pixels within [%]",
                                      "worst [%]",      "mean difference [%]", "median colour difference [u'v']",
                                      "ready [CPU-ms]", "picture [CPU-ms]",    "a pixel [CPU-ns]",
                                      "scaled by"};
  std::string csv, markdown, rule;
  for (std::size_t i = 0; i < head.size(); ++i) {
    csv += (i ? "," : "") + head[i];
    markdown += "| " + head[i] + ' ';
    rule += i ? "| ---: " : "| --- ";
  }
  csv += '\n';
  markdown += "|\n" + rule + "|\n";
  for (const Result& r : results) {
    const std::vector<std::string> row{r.model,
                                       percent(r.error.median),
                                       percent(r.error.most),
                                       percent(r.error.worst),
                                       percent(r.error.mean),
                                       fmt::format("{:.4f}", r.error.colour),
                                       fmt::format("{:.0f}", 1e3 * r.ready),
                                       fmt::format("{:.0f}", 1e3 * r.drawn),
                                       fmt::format("{:.0f}", 1e9 * r.drawn / (double(r.width) * r.height)),
                                       fmt::format("{:.4g}", r.scale)};
    for (std::size_t i = 0; i < row.size(); ++i) {
      csv += (i ? "," : "") + row[i];
      markdown += "| " + row[i] + ' ';
    }
    csv += '\n';
    markdown += "|\n";
  }
  write_text(folder + "/compare.csv", csv);
  write_text(folder + "/compare.md", markdown);
}

/// A round number that most pixels of most models lie within.
double scale_for(const std::vector<Result>& results) {
  std::vector<double> most;
  for (std::size_t i = 1; i < results.size(); ++i) most.push_back(results[i].error.most);
  const double wanted = most.empty() ? 0 : quantile(most, 0.5);
  for (const double round : {0.01, 0.02, 0.05, 0.1, 0.25, 0.5})
    if (wanted <= round) return round;
  return 1;
}

void write_pictures(const CompareOptions& options, const PictureFormat& format, const std::vector<Result>& results,
                    const std::vector<char>& counted) {
  const double ev = format.exposure_ev.value_or(automatic_exposure(results.front().rgb));
  const double scale = options.scale.value_or(scale_for(results));
  std::vector<LabelledPicture> sheet;
  for (const Result& r : results) {
    check_interrupt();
    const std::string path = options.folder + '/' + r.model;
    std::vector<float> rgba;
    for (std::size_t i = 0; i < r.rgb.size(); i += 3)
      rgba.insert(rgba.end(), {r.rgb[i], r.rgb[i + 1], r.rgb[i + 2], 1});
    PictureFormat same = format;
    same.exposure_ev = ev;
    PictureOutputs files({path + ".exr", path + ".png"}, r.width, r.height, same, r.metadata);
    files.write(0, r.height, rgba);
    files.finish();
    sheet.push_back({developed(r, ev, format.tone_curve),
                     {r.model, fmt::format("{:.0f} ns a pixel", 1e9 * r.drawn / (double(r.width) * r.height))}});
    if (&r == &results.front()) {
      sheet.back().lines[0] += " (yardstick)";
      continue;
    }
    const BytePicture map = difference_map(r, differences(r, results.front()), counted, scale);
    write_png(path + "_difference.png", map, r.metadata);
    sheet.push_back({map,
                     {fmt::format("against {}: median {} %", results.front().model, percent(r.error.median)),
                      fmt::format("95 % of pixels within {} %", percent(r.error.most)),
                      fmt::format("full red, blue: {:.0f} % brighter, darker", 100 * scale)}});
  }
  // The yardstick by itself, then a model and its difference in each row.
  std::vector<LabelledPicture> pairs;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    pairs.push_back(sheet[i]);
    if (i == 0) pairs.push_back({{0, 0, {}}, {}});
  }
  write_png(options.folder + "/contact_sheet.png", contact_sheet(pairs, 2), results.front().metadata);
}

int run_compare(const CompareOptions& options) {
  Scene scene = load_scene(options.scene);
  options.picture.apply(scene);
  scene.picture.air_shadows = false;  // few models have them: all are asked for the same
  const PictureFormat format = options.picture.format(scene);
  const Chosen chosen = chosen_models(options);
  const auto land = std::make_shared<const Land>(scene.land);
  std::vector<Result> results;
  std::vector<char> sky;
  {
    Progress progress("compare");
    for (std::size_t i = 0; i < chosen.names.size(); ++i) {
      const double from = double(i) / double(chosen.names.size()), to = double(i + 1) / double(chosen.names.size());
      try {
        results.push_back(draw(scene, chosen.names[i], land, options.picture.engine, !options.picture.no_sun, sky,
                               progress, from, to));
        if (i > 0 && model_info(chosen.names[i]).colours) scale_to(results.front(), sky, results.back());
      } catch (const InputError& error) {
        if (!chosen.all || i == 0) throw;
        fmt::print(stderr, "{} is left out: {}\n", chosen.names[i], error.what());
      }
    }
  }
  // What lies below the horizon of a scene without land, each system has its own notion of, or none: errors are of the sky.
  const bool all = scene.has_land || std::ranges::none_of(sky, [](char s) { return s; });
  const std::vector<char> counted = all ? std::vector<char>(sky.size(), 1) : sky;
  for (Result& r : results) r.error = error_of(r, results.front(), differences(r, results.front()), counted);
  std::error_code error;
  fs::create_directories(options.folder, error);  // one that cannot be made, the first file complains of
  write_pictures(options, format, results, counted);
  write_tables(options.folder, results);
  fmt::print(stderr, "{}: {} models, {} x {}\n", options.folder, results.size(), results.front().width,
             results.front().height);
  return ok;
}

}  // namespace

void add_compare(CommandLine& line) {
  const auto options = std::make_shared<CompareOptions>();
  const Verb compare =
      line.verb("compare",
                "One scene by several models: pictures, differences, errors, cost (no shadows in the air; relative "
                "colours scaled to the yardstick's sky)");
  compare.option("scene", options->scene, "scene to render, TOML (docs/scene_file.md)").required().type_name("FILE");
  compare.option("-o,--output", options->folder, "folder for the pictures and tables").required().type_name("DIR");
  compare.option("--models", options->models, "names with commas between, or all that can draw the scene (default)")
      .type_name("LIST");
  compare.option("--yardstick", options->yardstick, "the model that the others are measured by (default single)")
      .type_name("NAME");
  compare.number("--scale", options->scale, {1e-6, 1e6, ""},
                 "difference shown in full colour, relative (default: one that suits)");
  options->picture.add_picture_to(compare);
  compare.runs([options] { return run_compare(*options); });
}

}  // namespace airlight::cli
