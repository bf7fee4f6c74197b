// `airlight probe`: the numbers of the sky for one view, or for a file of questions.
#include <fmt/core.h>

#include <memory>

#include "airlight/error.h"
#include "answers.h"
#include "batch.h"
#include "command_line.h"
#include "commands.h"
#include "json_line.h"
#include "model_of_sky.h"
#include "model_options.h"
#include "number.h"
#include "options.h"
#include "probe_colours.h"
#include "scenefile/atmosphere_file.h"
#include "text_output.h"

namespace airlight::cli {
namespace {

struct ProbeOptions {
  ModelOptions own;
  AirOptions air;
  SunOptions sun;
  MachineOptions machine;
  double altitude = 0, view_zenith = 0, view_azimuth = 0;
  int max_order = 0;
  std::optional<double> distance;
  std::string wavelengths, batch, output = "-";
  bool json = false;
};

/// Everything there is to know about one view.
struct Report {
  std::string atmosphere, model, engine;
  SunPlace sun;
  std::vector<double> wavelengths;
  struct Row {
    const Asked* asked;
    std::vector<double> values;  ///< one for each wavelength; one alone for photometric quantities
  };
  std::vector<Row> rows;
  std::array<double, 3> xyz;  ///< of the radiance [cd m-2]
};

Report make_report(const ProbeOptions& options) {
  Report report;
  report.sun = options.sun.resolve();
  report.wavelengths =
      parse_wavelengths(options.wavelengths.empty() ? "400:700:50" : options.wavelengths, "--wavelengths");
  Atmosphere atmosphere = options.air.load();
  report.sun.apply_distance(atmosphere);
  Answerers answerers({options.machine.make(), [&](const std::string&) { return atmosphere; }, options.machine.model,
                       options.own.parameters()});
  Answerer& answerer = answerers.named(options.machine.model);
  report.atmosphere = atmosphere.name;
  report.model = options.machine.model;
  report.engine = answerer.engine();
  if (!answerer.has(asked("luminance")))
    throw InputError(
        fmt::format("--model = {}: answers batches only (--batch FILE), whose lines hold its air", report.model));

  Ray ray;
  ray.altitude = options.altitude;
  ray.view = direction(options.view_azimuth * degree, (90 - options.view_zenith) * degree);
  ray.sun = report.sun.direction();
  if (options.distance) ray.distance = *options.distance;
  const std::span rays(&ray, 1);
  const auto ask = [&](const Asked& asked, const std::vector<double>& wavelengths) {
    return answerer.answer({options.air.planet, options.machine.model, &asked, wavelengths, options.max_order}, rays)
        .front()
        .value;
  };
  for (const Asked& asked : all_asked())
    if (answerer.has(asked))
      report.rows.push_back({&asked, ask(asked, asked.photometric ? std::vector<double>() : report.wavelengths)});
  const auto eye = photometric_wavelengths();
  report.xyz = spectrum_to_xyz(eye, ask(asked("radiance"), eye));
  return report;
}

std::array<double, 2> chromaticity(const std::array<double, 3>& xyz) {
  const double sum = xyz[0] + xyz[1] + xyz[2];
  return sum > 0 ? std::array{xyz[0] / sum, xyz[1] / sum} : std::array{0.0, 0.0};
}

std::string as_table(const Report& report, const ProbeOptions& options) {
  std::string text = fmt::format("atmosphere  {}\nmodel       {} on {}\nobserver    {:g} m above the ground\n",
                                 report.atmosphere, report.model, report.engine, options.altitude);
  text += fmt::format("view        zenith {:g} degrees, azimuth {:g} degrees, {}\n", options.view_zenith,
                      options.view_azimuth,
                      options.distance ? fmt::format("up to {:g} m", *options.distance) : "to space or the ground");
  Metadata sun;
  report.sun.describe(sun);
  for (const auto& [name, value] : sun)
    text += std::visit([&name = name](const auto& said) { return fmt::format("{:<24}{}\n", name, said); }, value);

  constexpr int column = 17;
  std::string heads = fmt::format("\n{:<12}", "wavelength"), units = fmt::format("\n{:<12}", "nm");
  for (const auto& [asked, values] : report.rows) {
    if (asked->photometric) continue;
    heads += fmt::format("{:>{}}", asked->name, column);
    units += fmt::format("{:>{}}", asked->unit, column);
  }
  text += heads + units + '\n';
  for (std::size_t i = 0; i < report.wavelengths.size(); ++i) {
    text += fmt::format("{:<12g}", report.wavelengths[i]);
    for (const auto& [asked, values] : report.rows)
      if (!asked->photometric) text += fmt::format("{:>{}.6g}", values[i], column);
    text += '\n';
  }
  text += '\n';
  for (const auto& [asked, values] : report.rows)
    if (asked->photometric) text += fmt::format("{:<24}{:.6g} {}\n", asked->name, values[0], asked->unit);
  const auto [x, y] = chromaticity(report.xyz);
  text += fmt::format("{:<24}{:.6g} {:.6g} {:.6g} cd m-2\n{:<24}{:.4f} {:.4f}\n", "XYZ (CIE 1931)", report.xyz[0],
                      report.xyz[1], report.xyz[2], "chromaticity x y", x, y);
  return text;
}

std::string as_json(const Report& report, const ProbeOptions& options) {
  nlohmann::ordered_json json{{"version", version()},
                              {"atmosphere", report.atmosphere},
                              {"model", report.model},
                              {"engine", report.engine},
                              {"altitude", options.altitude},
                              {"view_zenith", options.view_zenith},
                              {"view_azimuth", options.view_azimuth},
                              {"distance", nullptr},
                              {"max_order", options.max_order}};
  if (options.distance) json["distance"] = *options.distance;
  json["sun_azimuth"] = report.sun.azimuth;
  json["sun_elevation"] = report.sun.elevation;
  json["refraction"] = report.sun.refraction;
  if (!report.sun.place.empty()) {
    json["place"] = report.sun.place;
    json["time"] = report.sun.time;
    json["sun_distance"] = report.sun.distance;
  }
  json["wavelengths"] = report.wavelengths;
  nlohmann::ordered_json units{{"altitude", "m"},      {"view_zenith", "degrees"}, {"view_azimuth", "degrees"},
                               {"distance", "m"},      {"sun_azimuth", "degrees"}, {"sun_elevation", "degrees"},
                               {"sun_distance", "au"}, {"wavelengths", "nm"}};
  for (const auto& [asked, values] : report.rows) {
    if (asked->photometric)
      json[asked->name] = values[0];
    else
      json[asked->name] = values;
    units[asked->name] = asked->unit;
  }
  json["xyz"] = report.xyz;
  units["xyz"] = "cd m-2";
  json["units"] = units;
  return json.dump(2) + '\n';
}

/// The same view asked of a published system that answers in colours.
ColourQuestion colour_question(const ProbeOptions& options) {
  ColourQuestion question{.model = options.machine.model,
                          .parameters = options.own.parameters(),
                          .engine = options.machine.make(),
                          .sun = options.sun.resolve(options.own.sun_elevation(options.machine.model)),
                          .atmosphere = options.air.load(),
                          .ray = {}};
  question.ray.altitude = options.altitude;
  question.ray.view = direction(options.view_azimuth * degree, (90 - options.view_zenith) * degree);
  question.ray.sun = question.sun.direction();
  if (options.distance) question.ray.distance = *options.distance;
  if (!options.wavelengths.empty())
    throw InputError(
        fmt::format("--wavelengths: expected none: model {} answers in red, green and blue", options.machine.model));
  if (options.max_order != 0)
    throw InputError(fmt::format("--max-order = {}: expected 0: model {} has no orders of scattering",
                                 options.max_order, options.machine.model));
  return question;
}

int run_probe(const ProbeOptions& options) {
  const std::string& model = options.machine.model;
  check_model_name(model, "--model", answering_models());
  const Parameters own = options.own.parameters();
  const std::optional<ModelInfo> info = model_of_sky(model);
  if (!own.empty() && (!info || info->parameters.empty()))
    throw InputError(fmt::format("--set, --preset: expected none: model {} has no parameters", model));
  const bool in_colours = info && info->colours;
  if (!options.batch.empty()) {
    if (in_colours && !own.empty())
      throw InputError(
          fmt::format("--set, --preset: expected none with --batch: model {} answers in red, green and blue", model));
    const std::shared_ptr<Engine> engine = options.machine.make();
    if (!own.empty()) Sky(options.air.load(), model, engine, own);  // a bad parameter is told before any line
    Answerers answerers(
        {engine, [&](const std::string& name) { return with_overrides(load_atmosphere(name), options.air.overrides); },
         model, own});
    return answer_batch(options.batch, options.output, answerers, {options.air.planet, model});
  }
  if (in_colours) {
    write_text(options.output, probe_colours(colour_question(options), options.json));
    return ok;
  }
  const Report report = make_report(options);
  write_text(options.output, options.json ? as_json(report, options) : as_table(report, options));
  return ok;
}

}  // namespace

void add_probe(CommandLine& line) {
  const auto options = std::make_shared<ProbeOptions>();
  const Verb probe = line.verb(
      "probe", "Numbers for one view, or for a file of questions (--batch); of published systems in red, green, blue");
  const Option batch =
      probe.option("--batch", options->batch, "answer a file of JSON lines; - reads standard input").type_name("FILE");
  probe.option("-o,--output", options->output, "where the answers go; - is standard output (default -)")
      .type_name("FILE");
  probe.flag("--json", options->json, "JSON in place of a table").excludes(batch);
  probe.number("--altitude", options->altitude, {lowest_altitude, highest_altitude, "m"}, "observer above the ground")
      .excludes(batch);
  probe.number("--view-zenith", options->view_zenith, {0, 180, "degrees"}, "view, from straight up").excludes(batch);
  probe.number("--view-azimuth", options->view_azimuth, {-360, 360, "degrees"}, "view, from north, clockwise")
      .excludes(batch);
  probe
      .number("--distance", options->distance, {0, highest_altitude, "m"},
              "length of the view ray (default: to space or the ground)")
      .excludes(batch);
  probe.number("--max-order", options->max_order, {0, 1000, ""}, "orders of scattering, 1 single; 0 all")
      .excludes(batch);
  probe
      .option("--wavelengths", options->wavelengths,
              "nm, inside the atmosphere's data: 440,550,680 or first:last:step (default 400:700:50); luminances "
              "always use 40")
      .type_name("LIST")
      .excludes(batch);
  options->sun.add_to(probe);
  options->air.add_to(probe);
  options->machine.add_to(probe, answering_models());
  options->own.add_to(probe);
  probe.runs([options] { return run_probe(*options); });
}

}  // namespace airlight::cli
