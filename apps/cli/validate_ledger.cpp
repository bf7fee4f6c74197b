// The part of `airlight validate` that asks models and writes the ledger.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "airlight/error.h"
#include "commands.h"
#include "digest.h"
#include "interrupt.h"
#include "model/model.h"
#include "model_options.h"
#include "options.h"
#include "progress.h"
#include "scenefile/atmosphere_file.h"
#include "text_output.h"
#include "unfinished.h"
#include "validate.h"
#include "validate/ledger_text.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;
using namespace validation;
using Json = nlohmann::ordered_json;

/// Rays of a planet's sky mean nothing inside a cylinder.
constexpr std::string_view without_sky = "rama";
/// A published system's air is its own, made for a clear day on Earth.
constexpr std::string_view air_of_published = "earth";
constexpr std::string_view air_of_cost = "earth";

/// Models with parameters that are judged beside the defaults. The draft is what CI has the time for.
constexpr std::string_view variants[] = {"precomputed:first_order=tables", "precomputed:detail=draft"};

/// "MODEL" or "MODEL:NAME=VALUE,NAME=VALUE"; numbers that follow a value belong to it: "MODEL:NAME=1,2,3".
Contestant contestant_named(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  Contestant contestant{text, text.substr(0, colon), {}};
  check_model_name(contestant.model, "--model", model_names());
  if (contestant.model == without_sky)
    throw InputError(fmt::format("--model = {}: has no sky above a planet", contestant.model));
  ModelOptions own;
  if (colon < text.size()) {
    for (const std::string_view piece : comma_separated(std::string_view(text).substr(colon + 1))) {
      const std::size_t equals = piece.find('=');
      const bool number = std::holds_alternative<std::vector<double>>(parse_parameter(piece));
      if (equals != std::string_view::npos && equals > 0)
        own.set.emplace_back(piece);
      else if (equals == std::string_view::npos && number && !own.set.empty())
        own.set.back().append(",").append(piece);
      else
        throw InputError(fmt::format("--model = {}: \"{}\": expected NAME, or NAME:KEY=VALUE,KEY=VALUE", text, piece));
    }
  }
  contestant.parameters = own.parameters();
  model_parameters(find_model(contestant.model), contestant.parameters, contestant.model + ".");  // complains
  return contestant;
}

std::vector<Contestant> contestants(const ValidateOptions& options) {
  std::vector<Contestant> list;
  for (const std::string& name : options.models) list.push_back(contestant_named(name));
  if (!list.empty()) return list;
  for (const std::string_view name : model_names()) {
    if (name == without_sky) continue;
    list.push_back(contestant_named(std::string(name)));
    for (const std::string_view variant : variants)
      if (variant.starts_with(std::string(name) + ':')) list.push_back(contestant_named(std::string(variant)));
  }
  return list;
}

/// Nothing is kept from earlier runs: what is to be timed is made.
std::shared_ptr<Engine> watched_engine() {
  auto engine = make_engine("simd");
  engine->watch(watch_tables());
  return engine;
}

std::vector<std::string> atmospheres_of(const Yardstick& yardstick) {
  std::vector<std::string> atmospheres;
  for (const YardstickRay& ray : yardstick.rays)
    if (std::ranges::find(atmospheres, ray.atmosphere) == atmospheres.end()) atmospheres.push_back(ray.atmosphere);
  std::ranges::sort(atmospheres);
  return atmospheres;
}

/// Names all that the answers depend on beside what computes them.
Json key_of(const Yardstick& yardstick, const std::string& folder, bool costs) {
  Digest text;
  for (const char* file : {"rays", "values", "irradiance_rays", "irradiance_values"})
    text.add_file(fmt::format("{}/{}.jsonl", folder, file));
  for (const std::string& name : atmospheres_of(yardstick)) text.add(to_toml(built_in_atmosphere(name)));
  return {
      {"text", text.text()}, {"rays", yardstick.rays.size()}, {"wavelengths", yardstick.wavelengths}, {"costs", costs}};
}

Ledger make_ledger(const std::vector<Contestant>& judged, bool costs, const Yardstick& yardstick,
                   const Unfinished& unfinished) {
  const std::vector<std::string> atmospheres = atmospheres_of(yardstick);
  Ledger ledger{yardstick.wavelengths, yardstick.solved, yardstick.irradiances, {}, {}};
  Progress progress("validate");
  double done = 0;
  for (const Contestant& contestant : judged) {
    const bool published = model_info(contestant.model).colours != nullptr;
    const double scale = published ? zenith_scale(contestant) : 1;
    for (const std::string& atmosphere : atmospheres) {
      check_interrupt();
      progress.show(done / double(judged.size() * atmospheres.size()));
      ++done;
      if (published && atmosphere != air_of_published) continue;
      const std::string part = contestant.name + '.' + atmosphere;
      ModelAnswers answers;
      if (const auto done_before = unfinished.find(part)) {
        answers = model_answers_from(*done_before);
      } else {
        answers = ask_model(contestant, atmosphere, yardstick, engine_named("simd"));
        // One air is enough to say what a model costs.
        if (atmosphere == air_of_cost && costs)
          answers.cost = cost_of(contestant, answers, yardstick, watched_engine());
        unfinished.keep(part, to_json(answers));
      }
      add_rows(ledger, yardstick, answers, scale);
    }
  }
  return ledger;
}

}  // namespace

int validate_ledger(const ValidateOptions& options) {
  std::optional<Ledger> before;
  if (!options.against.empty()) {
    const auto json = read_json(options.against);
    if (!json) throw InputError(fmt::format("--against = {}: cannot be read as JSON", options.against));
    try {
      before = ledger_from(*json);
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("--against = {}: {}", options.against, error.what()));
    }
  }
  const std::string folder = options.data + "/yardstick";
  Yardstick yardstick = read_yardstick(folder, before ? std::optional(before->solved) : std::nullopt);
  if (options.quick)
    yardstick = at_wavelengths(yardstick, {1, 3, 4, 6});  // over the visible, in and out of ozone's band
  if (before && before->wavelengths != yardstick.wavelengths)
    throw InputError(fmt::format("--against = {}: was made at other wavelengths; expected one made {} --quick",
                                 options.against, options.quick ? "with" : "without"));

  const PagePart page(options.page, "ledger");
  const std::vector<Contestant> judged = contestants(options);
  make_report_folder(options.folder);
  const bool costs = options.against.empty();  // whoever looks for what became worse does not ask
  const Unfinished unfinished(options.folder + "/unfinished", key_of(yardstick, folder, costs));
  const Ledger ledger = make_ledger(judged, costs, yardstick, unfinished);
  const std::string name = options.quick ? "quick" : "ledger", path = options.folder + '/' + name;
  write_text(path + ".json", as_json(ledger).dump(1) + '\n');
  write_text(path + ".csv", as_csv(ledger));
  write_text(path + ".svg", as_svg(ledger));
  if (options.page.empty()) {
    write_text(path + ".md", as_markdown(ledger, name));
  } else {
    const fs::path from_page = fs::relative(options.folder, fs::absolute(options.page).parent_path());
    page.write(as_markdown(ledger, (from_page / name).string()));
  }
  unfinished.remove();
  fmt::print(stderr, "{}: {} rays, {} irradiances, {} figures\n", options.folder, ledger.solved, ledger.irradiances,
             ledger.rows.size());
  if (!before) return ok;
  const std::vector<std::string> worse = worse_than(ledger, *before);
  for (const std::string& line : worse) fmt::print(stderr, "worse: {}\n", line);
  return worse.empty() ? ok : failed;
}

}  // namespace airlight::cli
