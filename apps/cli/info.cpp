// `airlight models`, `planets`, `doctor`: what there is, and what this machine can run.
#include <fmt/core.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "command_line.h"
#include "commands.h"
#include "options.h"
#include "parameter_json.h"
#include "scenefile/atmosphere_file.h"
#include "text_output.h"

namespace airlight::cli {
namespace {

using nlohmann::ordered_json;

struct Entry {
  std::string_view name, summary;
};

void print_entries(std::span<const Entry> entries, bool json) {
  std::string text;
  auto list = ordered_json::array();
  for (const auto& [name, summary] : entries) {
    text += fmt::format("{:<18}{}\n", name, summary);
    list.push_back({{"name", name}, {"summary", summary}});
  }
  write_text("-", json ? list.dump(2) + '\n' : text);
}

// ---- models ----

ordered_json described(const ModelInfo& model) {
  ordered_json json{{"name", model.name}, {"summary", model.summary}};
  if (model.colours) {
    json["answers"] = "red, green, blue";
    json["wavelengths"] = model.colours->wavelengths;
    json["luminance"] = model.colours->luminance;
    json["tone"] = model.colours->tone;
  }
  if (!model.parameters.empty()) json["parameters"] = ordered_json::array();
  for (const ParameterInfo& key : model.parameters) json["parameters"].push_back(parameter_json(key));
  for (const Preset& preset : model.presets) {
    ordered_json entry{{"name", preset.name}, {"text", preset.text}, {"values", ordered_json::object()}};
    for (const auto& [name, value] : preset.values) entry["values"][name] = value_json(value);
    if (preset.sun_elevation) entry["sun_elevation"] = *preset.sun_elevation;
    json["presets"].push_back(std::move(entry));
  }
  return json;
}

std::string models_as_json() {
  auto list = ordered_json::array();
  for (const ModelInfo& model : models()) list.push_back(described(model));
  return list.dump(2) + '\n';
}

std::string models_as_text() {
  std::string text;
  for (const ModelInfo& model : models()) {
    text += fmt::format("{:<18}{}\n", model.name, model.summary);
    for (const ParameterInfo& key : model.parameters) text += "    " + parameter_line(key) + '\n';
    for (const Preset& preset : model.presets) text += fmt::format("    preset {}: {}\n", preset.name, preset.text);
  }
  return text;
}

// ---- doctor ----

ordered_json examine_engine(const char* name) {
  try {
    return {{"name", name}, {"works", true}, {"device", make_engine(name)->device()}};
  } catch (const std::runtime_error& error) {
    return {{"name", name}, {"works", false}, {"problem", error.what()}};
  }
}

ordered_json examine() {
  ordered_json report{{"version", version()}, {"threads", std::thread::hardware_concurrency()}};
  const char* const chosen = std::getenv("AIRLIGHT_ISA");
  report["AIRLIGHT_ISA"] = chosen ? ordered_json(chosen) : ordered_json(nullptr);
  for (const InstructionSet& set : instruction_sets())
    report["instruction_sets"].push_back({{"name", set.name}, {"lanes", set.lanes}, {"available", set.available}});
  for (const char* engine : {"double", "simd", "gl"}) report["engines"].push_back(examine_engine(engine));
  for (const char* file : {"solar_irradiance.csv", "ozone_cross_section_233K.csv"}) {
    ordered_json data{{"file", file}, {"found", false}};
    if (const auto table = shipped_spectrum(file, Sampling::bins)) {
      const auto range = Spectrum(*table).range();
      data["found"] = true;
      data["nm"] = {range->first, range->last};
    }
    report["data"].push_back(data);
  }
  report["planets"] = built_in_atmospheres();
  for (const ModelInfo& model : models()) report["models"].push_back(model.name);
  return report;
}

std::string as_text(const ordered_json& report) {
  std::string text = fmt::format(
      "{}\nthreads          {}\nAIRLIGHT_ISA     {}\n", report["version"].get<std::string>(),
      report["threads"].get<int>(),
      report["AIRLIGHT_ISA"].is_null() ? "not set: the widest is taken" : report["AIRLIGHT_ISA"].get<std::string>());
  for (const auto& set : report["instruction_sets"])
    text += fmt::format("instruction set  {:<8} {:>2} floats at once, {}\n", set["name"].get<std::string>(),
                        set["lanes"].get<int>(), set["available"].get<bool>() ? "available" : "not on this processor");
  for (const auto& engine : report["engines"])
    text += fmt::format("engine           {:<8} {}\n", engine["name"].get<std::string>(),
                        engine["works"].get<bool>() ? engine["device"].get<std::string>()
                                                    : "does not work: " + engine["problem"].get<std::string>());
  for (const auto& data : report["data"])
    text += fmt::format("data             {}: {}\n", data["file"].get<std::string>(),
                        data["found"].get<bool>()
                            ? fmt::format("{:g} .. {:g} nm", data["nm"][0].get<double>(), data["nm"][1].get<double>())
                            : "missing");
  for (const char* kind : {"planets", "models"}) {
    text += fmt::format("{:<17}", kind);
    for (const auto& name : report[kind]) text += name.get<std::string>() + ' ';
    text.back() = '\n';
  }
  return text;
}

}  // namespace

const char* version() { return "airlight " AIRLIGHT_VERSION; }

void add_models(CommandLine& line) {
  const auto json = std::make_shared<bool>(false);
  const Verb command = line.verb("models", "The models of the sky");
  command.flag("--json", *json, "for scripts");
  command.runs([json] {
    write_text("-", *json ? models_as_json() : models_as_text());
    return ok;
  });
}

void add_planets(CommandLine& line) {
  struct Options {
    std::string name;
    AirOverrides overrides;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  const Verb command = line.verb("planets", "The atmospheres built in; with a name, its TOML");
  const Option name =
      command.option("name", options->name, "a built-in atmosphere or a file.toml, to be printed as TOML")
          .type_name("NAME");
  command.flag("--json", options->json, "the list as JSON").excludes(name);
  add_air_overrides(command, options->overrides);
  command.runs([options] {
    if (!options->name.empty()) {
      write_text("-", to_toml(with_overrides(load_atmosphere(options->name), options->overrides)));
      return ok;
    }
    std::vector<Entry> entries;
    for (const std::string_view planet : built_in_atmospheres())
      entries.push_back({planet, describe_atmosphere(planet)});
    print_entries(entries, options->json);
    return ok;
  });
}

void add_doctor(CommandLine& line) {
  const auto json = std::make_shared<bool>(false);
  const Verb command = line.verb("doctor", "What this machine can run: instruction sets, engines, threads, data");
  command.flag("--json", *json, "for scripts");
  command.runs([json] {
    const ordered_json report = examine();
    write_text("-", *json ? report.dump(2) + '\n' : as_text(report));
    // Without its two processor engines the program is broken; without a graphics driver it is not.
    for (const auto& engine : report["engines"])
      if (engine["name"] != "gl" && !engine["works"].get<bool>()) return int{failed};
    return int{ok};
  });
}

}  // namespace airlight::cli
