// The part of `airlight validate` that asks models and writes the ledger.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "airlight/error.h"
#include "commands.h"
#include "interrupt.h"
#include "options.h"
#include "progress.h"
#include "text_output.h"
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

std::optional<Json> read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) return {};
  try {
    return Json::parse(file);
  } catch (const Json::exception&) {
    return {};
  }
}

std::vector<std::string> chosen_models(const ValidateOptions& options) {
  std::vector<std::string> names;
  for (const std::string& name : options.models) {
    check_model_name(name, "--model", model_names());
    if (name == without_sky) throw InputError(fmt::format("--model = {}: has no sky above a planet", name));
    names.push_back(name);
  }
  if (names.empty())
    for (const std::string_view name : model_names())
      if (name != without_sky) names.emplace_back(name);
  return names;
}

/// What is done is kept in files of its own until all is, so that an interrupted run goes on.
class Unfinished {
 public:
  Unfinished(const std::string& folder, const Yardstick& yardstick)
      : folder_(folder + "/unfinished"),
        key_{{"version", version()}, {"solved", yardstick.rays.size()}, {"wavelengths", yardstick.wavelengths}} {}

  std::optional<ModelAnswers> find(const std::string& model, const std::string& atmosphere) const {
    const auto json = read_json(path(model, atmosphere));
    if (!json || json->value("key", Json()) != key_) return {};
    return model_answers_from(json->at("answers"));
  }
  void keep(const ModelAnswers& answers) const {
    std::error_code error;
    fs::create_directories(folder_, error);  // one that cannot be made, the file complains of
    write_text(path(answers.model, answers.atmosphere), Json{{"key", key_}, {"answers", to_json(answers)}}.dump());
  }
  void remove() const {
    std::error_code error;
    fs::remove_all(folder_, error);
  }

 private:
  std::string path(const std::string& model, const std::string& atmosphere) const {
    return fmt::format("{}/{}.{}.json", folder_, model, atmosphere);
  }
  std::string folder_;
  Json key_;
};

Ledger make_ledger(const ValidateOptions& options, const Yardstick& yardstick, const Unfinished& unfinished) {
  std::vector<std::string> atmospheres;
  for (const YardstickRay& ray : yardstick.rays)
    if (std::ranges::find(atmospheres, ray.atmosphere) == atmospheres.end()) atmospheres.push_back(ray.atmosphere);
  std::ranges::sort(atmospheres);
  Ledger ledger{yardstick.wavelengths, yardstick.rays.size(), {}, {}};
  const std::vector<std::string> models = chosen_models(options);
  Progress progress("validate");
  double done = 0;
  for (const std::string& model : models) {
    const bool published = model_info(model).colours != nullptr;
    const double scale = published ? zenith_scale(model) : 1;
    for (const std::string& atmosphere : atmospheres) {
      check_interrupt();
      progress.show(done / double(models.size() * atmospheres.size()));
      ++done;
      if (published && atmosphere != air_of_published) continue;
      auto answers = unfinished.find(model, atmosphere);
      if (!answers) unfinished.keep(*(answers = ask_model(model, atmosphere, yardstick)));
      add_rows(ledger, yardstick, *answers, scale);
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
  Yardstick yardstick =
      read_yardstick(options.data + "/yardstick", before ? std::optional(before->solved) : std::nullopt);
  if (options.quick)
    yardstick = at_wavelengths(yardstick, {1, 3, 4, 6});  // over the visible, in and out of ozone's band
  if (before && before->wavelengths != yardstick.wavelengths)
    throw InputError(fmt::format("--against = {}: was made at other wavelengths; expected one made {} --quick",
                                 options.against, options.quick ? "with" : "without"));

  std::error_code error;
  fs::create_directories(options.folder, error);  // one that cannot be made, the first file complains of
  const Unfinished unfinished(options.folder, yardstick);
  const Ledger ledger = make_ledger(options, yardstick, unfinished);
  const std::string name = options.quick ? "quick" : "ledger", path = options.folder + '/' + name;
  write_text(path + ".json", as_json(ledger).dump(1) + '\n');
  write_text(path + ".csv", as_csv(ledger));
  write_text(path + ".svg", as_svg(ledger));
  if (options.page.empty()) {
    write_text(path + ".md", as_markdown(ledger, name));
  } else {
    const fs::path folder = fs::relative(options.folder, fs::absolute(options.page).parent_path(), error);
    write_into_page(options.page, "ledger", as_markdown(ledger, (folder / name).string()));
  }
  unfinished.remove();
  fmt::print(stderr, "{}: {} rays, {} figures\n", options.folder, ledger.solved, ledger.rows.size());
  if (!before) return ok;
  const std::vector<std::string> worse = worse_than(ledger, *before);
  for (const std::string& line : worse) fmt::print(stderr, "worse: {}\n", line);
  return worse.empty() ? ok : failed;
}

}  // namespace airlight::cli
