// `airlight realworldz-table`: painted tables of RealWorldz' skies, generated, from photographs and rendered panoramas; tools of their
// painters.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "image/picture_reader.h"
#include "lens.h"
#include "model/realworldz_paint.h"
#include "model_options.h"
#include "number.h"
#include "parameter_pictures.h"
#include "picture_outputs.h"
#include "sky/binder.h"

namespace airlight::cli {
namespace {

struct TableOptions {
  std::string size = "256";
  std::vector<std::string> outputs;
  std::string from, table, sun, sun_pixel, projection = "equirectangular", pixel, cell, highlight, discontinuities;
  std::optional<double> elevation, field_of_view, white;
  double altitude = 2, azimuth = 0, horizon = 0, halo = 0, hue = 0;
  Adjustment adjustment;
  ModelOptions planet;
};

std::array<double, 2> parse_pair(const std::string& text, const char* option, const Interval& first,
                                 const Interval& second) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw InputError(fmt::format("{} = {}: expected two numbers, A,B", option, text));
  return {parse_number(std::string_view(text).substr(0, comma), option, first),
          parse_number(std::string_view(text).substr(comma + 1), option, second)};
}

/// A picture with its camera, and the sky that it shows.
struct Photograph {
  ColourPicture picture;
  Camera camera;
  SkyGeometry sky;

  Direction view(double x, double y) const { return view_direction(camera, x / camera.width, y / camera.height); }
  Interval columns() const { return {0, camera.width - 1.0, "pixels"}; }
  Interval rows() const { return {0, camera.height - 1.0, "pixels"}; }
};

Camera camera_of(const TableOptions& options, const ColourPicture& picture) {
  const Lens& lens = lens_named("--projection", options.projection);
  if (lens.projection == Projection::cube)
    throw InputError("--projection = cube: expected equirectangular, fisheye or perspective");
  const double field_of_view = options.field_of_view.value_or(lens.field_of_view);
  check_field_of_view(lens, field_of_view);
  Camera camera;
  camera.projection = lens.projection;
  camera.width = picture.width;
  camera.height = picture.height;
  camera.altitude = options.altitude;
  camera.azimuth = options.azimuth * degree;
  camera.elevation = options.elevation.value_or(lens.elevation) * degree;
  camera.field_of_view = field_of_view * degree;
  return camera;
}

/// What the planet's air lets through on the 65 rings around a viewer.
std::vector<double> rings_of(Parameters planet, double altitude) {
  const Model& model = find_model("realworldz");
  read_pictures("realworldz", planet);
  const Values values = model_parameters(model, planet, "realworldz.");
  Situation situation{};
  situation.parameters = &values;
  const auto engine = make_engine("double");
  Binder passes(*engine, model, situation);
  passes.set("observer", airlight::Fields{{"sun", {0, 0, 1, 0}}, {"altitude", {altitude}}});
  constexpr Shape shape{65, 1};
  std::vector<double> rgba(4 * shape.texels()), rings;
  engine->read(passes.run_once("realworldz.rings", shape)[0], rgba);
  for (std::size_t i = 0; i < rgba.size(); i += 4) rings.push_back(rgba[i]);
  return rings;
}

Photograph photograph_of(const TableOptions& options) {
  Photograph shot{read_colours(options.from), {}, {}};
  shot.camera = camera_of(options, shot.picture);
  if (options.sun.empty() == options.sun_pixel.empty())
    throw InputError("--from needs to know where the sun stands: expected either --sun or --sun-pixel");
  Direction sun;
  if (!options.sun.empty()) {
    const auto [azimuth, elevation] = parse_pair(options.sun, "--sun", {-360, 360, "degrees"}, {-90, 90, "degrees"});
    sun = direction(azimuth * degree, elevation * degree);
  } else {
    const auto [x, y] = parse_pair(options.sun_pixel, "--sun-pixel", shot.columns(), shot.rows());
    sun = shot.view(x + 0.5, y + 0.5);
  }
  shot.sky = ring_geometry(sun, rings_of(options.planet.parameters(), options.altitude));
  return shot;
}

/// The picture's colours in the table's light.
std::vector<float> light_of(const TableOptions& options, const ColourPicture& picture) {
  // Pictures of floats are in cd/m2, of which a model's 1 is this many.
  const double otherwise = picture.encoded ? 1 : model_info("realworldz").colours->luminance;
  const double white = options.white.value_or(otherwise);
  std::vector<float> rgb;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) {
      const double v = double(picture.rgba[i + c]) / white;
      rgb.push_back(std::isfinite(v) ? float(std::max(v, 0.0)) : 0.0f);
    }
  return rgb;
}

void write_grey(const std::string& path, int width, int height, std::span<const float> values) {
  ParameterPicture picture{path, width, height, {}};
  for (const float v : values) picture.rgba.insert(picture.rgba.end(), {v, v, v, 1});
  write_painted(path, picture);
}

/// Which cell colours a pixel, and which pixels a cell colours; rows count from the table's top, as a painter sees it.
void pick(const TableOptions& options, const SkyTable& table, const Photograph& shot) {
  if (!options.pixel.empty()) {
    const auto [x, y] = parse_pair(options.pixel, "--pixel", shot.columns(), shot.rows());
    const TablePlace place = place_of(shot.sky, shot.view(x + 0.5, y + 0.5));
    const auto colour = colour_at(table, place);
    fmt::print(
        "column {}, row {}: {:.2f} degrees from the sun, exp(-optical depth) {:.4f}; colour {:.4f} {:.4f} {:.4f} "
        "{:.4f}\n",
        std::min(int(place.x * table.width), table.width - 1),
        std::min(int((1 - place.y) * table.height), table.height - 1), 180 * place.x, place.y, colour[0], colour[1],
        colour[2], colour[3]);
  }
  if (!options.cell.empty()) {
    const auto [column, row] =
        parse_pair(options.cell, "--cell", {0, table.width - 1.0, "cells"}, {0, table.height - 1.0, "cells"});
    const auto seen = highlight(table, int(column), table.height - 1 - int(row), shot.sky, shot.camera);
    write_grey(options.highlight, shot.camera.width, shot.camera.height, seen);
    fmt::print("{}: {} pixels are coloured by column {}, row {}\n", options.highlight, std::ranges::count(seen, 1.0f),
               int(column), int(row));
  }
}

SkyTable new_table(const std::string& text) {
  const Size size = parse_size(text, "--size", {2, 4096, "cells"});
  return realworldz_starter(size.width, size.height.value_or(size.width));
}

void check(const TableOptions& options) {
  const bool picks = !options.pixel.empty() || !options.cell.empty();
  if (options.outputs.empty() && options.discontinuities.empty() && !picks)
    throw InputError("nothing to do: expected -o, --discontinuities, --pixel or --cell");
  if (options.cell.empty() != options.highlight.empty())
    throw InputError("--cell and --highlight: expected both, or neither");
  if (options.from.empty() && (picks || !options.sun.empty() || !options.sun_pixel.empty()))
    throw InputError("--sun, --sun-pixel, --pixel and --cell are of a picture: expected --from");
  for (const std::string& path : options.outputs)
    if (!path.ends_with(".png") && !path.ends_with(".exr"))
      throw InputError(fmt::format("-o {}: expected .png or .exr", path));
}

int run_table(const TableOptions& options) {
  check(options);
  SkyTable table = options.table.empty() ? new_table(options.size) : table_of(read_painted(options.table));
  std::optional<Photograph> shot;
  std::string seen;
  if (!options.from.empty()) {
    shot = photograph_of(options);
    if (options.table.empty()) {
      const double horizon = std::sin(options.horizon * degree);
      Projected projected = back_projected(light_of(options, shot->picture), shot->camera, shot->sky, table.width,
                                           table.height, [&](const Direction& view) { return view[2] > horizon; });
      const auto covered = std::ranges::count(projected.covered, true);
      if (covered == 0) throw InputError("--from " + options.from + ": shows no sky above --horizon");
      seen = fmt::format(", {:.1f} % of it seen in {}", 100.0 * double(covered) / double(projected.covered.size()),
                         options.from);
      table = std::move(projected.table);
    }
  }
  Adjustment adjustment = options.adjustment;
  adjustment.hue = options.hue * degree;
  adjust(table, adjustment);
  if (options.halo > 0) paint_halo(table, 8, 10, options.halo);
  if (shot) pick(options, table, *shot);
  if (!options.discontinuities.empty()) {
    std::vector<float> steps;
    const std::vector<double> map = discontinuities(table);
    for (int row = table.height; row-- > 0;)
      for (int i = 0; i < table.width; ++i) steps.push_back(float(map[std::size_t(row * table.width + i)]));
    write_grey(options.discontinuities, table.width, table.height, steps);
  }
  for (const std::string& path : options.outputs) {
    write_painted(path, picture_of(table, path));
    fmt::print(stderr, "{}: {} x {}{}\n", path, table.width, table.height, seen);
  }
  return ok;
}

}  // namespace

void add_realworldz_table(CommandLine& line) {
  const auto options = std::make_shared<TableOptions>();
  const Verb verb = line.verb(
      "realworldz-table", "Painted sky tables of the model realworldz: generated, from a photograph; painters' tools");
  const char* const camera = "The picture that --from names";
  const char* const paint = "Changes to the whole table";
  const char* const tools = "Painters' tools";
  verb.option("-o,--output", options->outputs, "table to write: .png (8 bits) or .exr (floats); may be repeated")
      .one_value_each()
      .type_name("FILE");
  verb.option("--from", options->from,
              "photograph or panorama to project back; what it does not show is filled smoothly")
      .type_name("FILE");
  const Option table = verb.option("--table", options->table, "painted table to begin with (default: a generated one)")
                           .type_name("FILE");
  verb.option(
          "--size", options->size,
          "cells of a new table, 2 .. 4096 a side, or one number for both (default 256); what is narrow, as a halo, "
          "needs a wide one")
      .excludes(table)
      .type_name("WxH");
  verb.option("--sun", options->sun, "where the sun stands: azimuth, elevation [degrees]")
      .group(camera)
      .type_name("A,E");
  verb.option("--sun-pixel", options->sun_pixel, "or the pixel that shows it, from the left and from the top")
      .group(camera)
      .type_name("X,Y");
  verb.option("--projection", options->projection, "equirectangular, fisheye or perspective (default equirectangular)")
      .group(camera)
      .type_name("NAME");
  verb.number("--altitude", options->altitude, {0, 1e7, "m"}, "camera above the planet's lowest ground").group(camera);
  verb.number("--camera-azimuth", options->azimuth, {-360, 360, "degrees"},
              "middle of the picture, from north, clockwise")
      .group(camera);
  verb.number("--camera-elevation", options->elevation, {-90, 90, "degrees"},
              "of its axis above the horizon (default 0, fisheye 90)")
      .group(camera);
  verb.number("--field-of-view", options->field_of_view, {0.1, 360, "degrees"},
              "perspective: horizontal (default 90); fisheye: across the circle (default 180)")
      .group(camera);
  verb.number("--horizon", options->horizon, {-90, 90, "degrees"}, "elevation above which the picture shows sky")
      .group(camera);
  verb.number("--white", options->white, {1e-12, 1e12, ""},
              "light of the picture that the table takes as 1 (default: 10000 cd/m2 of pictures of floats, a display's "
              "white of others)")
      .group(camera);
  verb.number("--halo", options->halo, {0, 10, ""},
              "paints a rainbow halo of that strength, 8 to 10 degrees from the sun")
      .group(paint);
  verb.number("--redden", options->adjustment.redden, {-1, 1, ""}, "more red, less blue").group(paint);
  verb.number("--lighten", options->adjustment.lighten, {0, 1000, ""}, "factor").group(paint);
  verb.number("--contrast", options->adjustment.contrast, {0, 10, ""}, "power about the mean luminance").group(paint);
  verb.number("--hue", options->hue, {-180, 180, "degrees"}, "turn about the grey axis").group(paint);
  verb.option("--pixel", options->pixel, "prints which cell colours this pixel of the picture")
      .group(tools)
      .type_name("X,Y");
  verb.option("--cell", options->cell, "the cell, column and row from the top, whose pixels --highlight shows")
      .group(tools)
      .type_name("I,J");
  verb.option("--highlight", options->highlight, "picture, .png or .exr: white where that cell colours it")
      .group(tools)
      .type_name("FILE");
  verb.option("--discontinuities", options->discontinuities,
              "map of the table, .png or .exr: bright at edges that would show as lines in the sky")
      .group(tools)
      .type_name("FILE");
  options->planet.add_to(verb);
  verb.runs([options] { return run_table(*options); });
}

}  // namespace airlight::cli
