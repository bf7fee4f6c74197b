// The part of `airlight validate` that compares with what was measured and published.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "airlight/error.h"
#include "answers.h"
#include "commands.h"
#include "digest.h"
#include "interrupt.h"
#include "model/model.h"
#include "number.h"
#include "optics/colour.h"
#include "options.h"
#include "progress.h"
#include "scenefile/atmosphere_file.h"
#include "text_output.h"
#include "unfinished.h"
#include "validate.h"
#include "validate/air_mass.h"
#include "validate/direct_spectrum.h"
#include "validate/illuminance.h"
#include "validate/measured_sky.h"

namespace airlight::cli {
namespace {

using namespace validation;
using Json = nlohmann::ordered_json;

/// The issue of what was asked of whom.
struct Report {
  Json json;
  std::string text;
};

/// Models that know any wavelength. Random walks where they are asked for.
std::vector<std::string> judged(const ValidateOptions& options) {
  if (!options.models.empty()) {
    for (const std::string& name : options.models) check_model_name(name, "--model", answering_models());
    return options.models;
  }
  std::vector<std::string> names;
  for (const ModelInfo& model : models())
    if (!model.colours) names.emplace_back(model.name);
  return names;
}

/// Where there is no time, models whose tables take long are asked at fewer wavelengths.
bool at_few_wavelengths(const ValidateOptions& options, const std::string& name) {
  const auto known = model_names();
  return options.quick && std::ranges::find(known, name) != known.end() && find_model(name).orders;
}

std::vector<double> flat(const std::vector<Answer>& answers) {
  std::vector<double> values;
  for (const Answer& answer : answers) values.insert(values.end(), answer.value.begin(), answer.value.end());
  return values;
}

/// Of random walks: far below what instruments are worth.
const char* const effort = R"({"target_error":0.01})";

Answerers answerers_for(const Atmosphere& air) {
  return Answerers({engine_named("simd"), [air](const std::string&) { return air; }});
}

/// What a part of the work gave before, or gives now.
std::vector<double> once(const Unfinished& unfinished, const std::string& part,
                         const std::function<std::vector<double>()>& make) {
  if (const auto done = unfinished.find(part)) return done->get<std::vector<double>>();
  check_interrupt();
  std::vector<double> values = make();
  unfinished.keep(part, values);
  return values;
}

std::string sky_file(const ValidateOptions& options) { return options.data + "/measured/measured_sky_20130527.json"; }
std::string standard_file(const ValidateOptions& options) { return options.data + "/measured/astm_g173.csv"; }

/// Names all that the answers depend on beside what computes them.
Json key_of(const ValidateOptions& options) {
  Digest text;
  text.add_file(sky_file(options));
  text.add_file(standard_file(options));
  text.add(to_toml(built_in_atmosphere("earth")));
  return {{"text", text.text()}, {"quick", options.quick}};
}

void add_measured_sky(Report& report, const ValidateOptions& options, const std::vector<std::string>& names,
                      const Unfinished& unfinished) {
  const MeasuredSky sky = read_measured_sky(sky_file(options));
  Answerers answerers = answerers_for(air_of_measured_sky(sky, read_standard_spectrum(standard_file(options))));
  report.text +=
      "\nMeasured clear sky (Kider et al. 2014; air and error: data/measured/README.md), relative root mean square "
      "error; five scans,\n"
      "the sun from 44 to 69 degrees high. Correct scalar theory with this air: 12.6 %.\n\n"
      "| model | all [%] | bias [%] | scan by scan [%] |\n|---|---|---|---|\n";
  for (const std::string& name : names) {
    int number = 0;
    const auto radiance = [&](std::span<const Ray> rays, const std::vector<double>& wavelengths) {
      const std::string own = name == "reference" ? effort : "";
      return once(unfinished, fmt::format("measured_sky.{}.{}", name, ++number), [&] {
        return flat(answerers.answer({"measured", name, &asked("radiance"), wavelengths, 0, own}, rays));
      });
    };
    const bool few = at_few_wavelengths(options, name);
    const MeasuredSkyError error = compare_with_measured_sky(few ? at_every(sky, 4) : sky, radiance);
    std::string scans;
    for (const double scan : error.scans) scans += fmt::format("{}{:.1f}", scans.empty() ? "" : ", ", 100 * scan);
    report.text += fmt::format("| {}{} | {:.2f} | {:+.1f} | {} |\n", name, few ? ", every fourth wavelength" : "",
                               100 * error.all, 100 * error.bias, scans);
    report.json["measured_sky"].push_back(
        {{"model", name}, {"relative_rmse", error.all}, {"bias", error.bias}, {"scans", error.scans}});
  }
}

void add_direct_spectrum(Report& report, const ValidateOptions& options) {
  const DirectSpectrumError error = compare_with_g173(standard_file(options));
  report.text += fmt::format(
      "\nDirect sunlight of ASTM G173-03: `earth` with {:g} Dobson units of ozone and an aerosol of optical depth {:g} "
      "at 500 nm and\n"
      "exponent {:g}, {:g} air masses, times the standard's own sunlight above the air; {} wavelengths of 400 to 680 "
      "nm without 585-600 and\n"
      "625-635 nm (water, oxygen), the sun's surroundings not added: root mean square {:.2f} %, mean {:+.2f} %, worst "
      "{:+.1f} % at {:g} nm.\n",
      g173_ozone, g173_aerosol, g173_angstrom, g173_air_mass, error.count, 100 * error.rms, 100 * error.bias,
      100 * error.worst, error.worst_wavelength);
  report.json["direct_spectrum"] = {{"ozone", g173_ozone},
                                    {"aerosol_optical_depth_500", g173_aerosol},
                                    {"angstrom", g173_angstrom},
                                    {"rms", error.rms},
                                    {"mean", error.bias},
                                    {"worst", error.worst},
                                    {"worst_wavelength", error.worst_wavelength}};
}

/// "103000", "27.4", "0.000854": three digits.
std::string lux(double value) {
  return value < 1000 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}00", value / 100);
}

void add_illuminance(Report& report, const ValidateOptions& options, const std::vector<std::string>& names,
                     const Unfinished& unfinished) {
  report.text +=
      "\nIlluminance of level ground [lx], sunlight and skylight, clear `earth`, against Janiczek & DeYoung 1987 (U.S. "
      "Naval Observatory\n"
      "Circular 171): a mean over clear skies, with refraction, which here there is none of.\n\n| sun [degrees] | "
      "published |";
  std::string rule = "\n|---|---|";
  std::vector<std::vector<double>> columns;
  for (const std::string& name : names) {
    const Atmosphere earth = built_in_atmosphere("earth");
    Answerers answerers = answerers_for(earth);
    const bool few = at_few_wavelengths(options, name);
    const std::vector<double> asked_at =
        few ? std::vector<double>(realtime_quad.begin(), realtime_quad.end()) : photometric_wavelengths();
    const auto level = [&](double elevation, const std::vector<double>& wavelengths) {
      const Ray ray{.sun = direction(0, elevation * degree)};
      const std::string own = name == "reference" ? effort : "";
      // Few wavelengths share walks well: the eye's forty are asked together.
      auto sky = once(unfinished, fmt::format("illuminance.{}.{}", name, elevation), [&] {
        return flat(answerers.answer({"earth", name, &asked("sky_irradiance"), wavelengths, 0, own}, {&ray, 1}));
      });
      const auto sun = flat(answerers.answer({"earth", name, &asked("sun_irradiance"), wavelengths, 0}, {&ray, 1}));
      for (std::size_t w = 0; w < sky.size(); ++w) sky[w] += sun[w] * std::max(ray.sun[2], 0.0);
      return sky;
    };
    columns.push_back(illuminances(level, asked_at, earth));
    report.text += fmt::format(" {}{} |", name, few ? ", 4 wavelengths" : "");
    rule += "---|";
    report.json["illuminance"].push_back(
        {{"model", name}, {"elevation", illuminance_elevations()}, {"lux", columns.back()}});
  }
  report.text += rule + '\n';
  const std::vector<double> elevations = illuminance_elevations();
  for (std::size_t i = 0; i < elevations.size(); ++i) {
    const double published = published_illuminance(elevations[i]);
    report.text += fmt::format("| {:g} | {} |", elevations[i], lux(published));
    for (const auto& column : columns)
      report.text += fmt::format(" {} ({:+.0f} %) |", lux(column[i]), 100 * (column[i] / published - 1));
    report.text += '\n';
  }
}

void add_air_mass(Report& report) {
  report.text +=
      "\nAir mass of the molecules of `earth`, straight rays, against formulae for light that refraction bends: Kasten "
      "& Young 1989\n"
      "(Applied Optics 28, 4735; the sun's elevation as seen) and Young 1994 (Applied Optics 33, 1108; without the "
      "lift).\n\n"
      "| elevation [degrees] | here | Kasten & Young | | Young | |\n|---|---|---|---|---|---|\n";
  for (const AirMass& mass : air_masses()) {
    report.text += fmt::format("| {:g} | {:.4g} | {:.4g} | {:+.2f} % | {:.4g} | {:+.2f} % |\n", mass.elevation,
                               mass.here, mass.kasten_young, 100 * (mass.here / mass.kasten_young - 1), mass.young,
                               100 * (mass.here / mass.young - 1));
    report.json["air_mass"].push_back({{"elevation", mass.elevation},
                                       {"here", mass.here},
                                       {"kasten_young", mass.kasten_young},
                                       {"young", mass.young}});
  }
}

}  // namespace

int validate_measured(const ValidateOptions& options) {
  const std::vector<std::string> names = judged(options);
  const PagePart page(options.page, "measured");
  make_report_folder(options.folder);
  const Unfinished unfinished(options.folder + "/unfinished-measured", key_of(options));
  Report report;
  add_measured_sky(report, options, names, unfinished);
  add_direct_spectrum(report, options);
  add_illuminance(report, options, names, unfinished);
  add_air_mass(report);
  write_text(options.folder + "/measured.json", report.json.dump(1) + '\n');
  write_text(options.folder + "/measured.md", report.text);
  unfinished.remove();
  page.write(report.text);
  return ok;
}

}  // namespace airlight::cli
