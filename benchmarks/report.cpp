#include "report.h"

#include <fmt/core.h>

#include <fstream>

#include "airlight/error.h"

namespace airlight::bench {

void Report::describe(const std::string& key, const std::string& value) {
  fmt::print("{:<14} {}\n", key, value);
  json_["machine"][key] = value;
}

void Report::section(const std::string& title) {
  section_ = title;
  fmt::print("\n{}\n", title);
}

void Report::add(const Measured& m) {
  std::string line = fmt::format("  {:<56}{:>10.4g} {:<9}", m.name, m.value, m.unit);
  nlohmann::ordered_json entry{{"section", section_}, {"name", m.name}, {"value", m.value}, {"unit", m.unit}};
  if (m.limit) {
    line += fmt::format(" {:5.2f} x limit", m.value / *m.limit);
    entry["times_limit"] = m.value / *m.limit;
  }
  const auto require = [&](const char* words, double figure, bool met) {
    line += fmt::format("  required: {} {:g}{}", words, figure, met ? "" : "  MISSED");
    entry["required"] = fmt::format("{} {:g}", words, figure);
    entry["met"] = met;
    if (!met)
      missed_.push_back(
          fmt::format("{}, {}: {:.4g} {}, required {} {:g}", section_, m.name, m.value, m.unit, words, figure));
  };
  if (m.at_most) require("at most", *m.at_most, m.value <= *m.at_most);
  if (m.at_least) require("at least", *m.at_least, m.value >= *m.at_least);
  fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  std::fflush(stdout);
  json_["measured"].push_back(entry);
}

void Report::check(const std::string& what, double difference, double bound) {
  const bool good = difference <= bound;  // false for NaN
  fmt::print("  {:<56}{:>10.1e} {:<9} bound: {:.0e}{}\n", what, difference, "differs", bound, good ? "" : "  WRONG");
  std::fflush(stdout);
  json_["checked"].push_back(
      {{"section", section_}, {"name", what}, {"difference", difference}, {"bound", bound}, {"good", good}});
  if (!good)
    wrong_.push_back(fmt::format("{}, {}: differs by {:.2e}, bound {:.0e}", section_, what, difference, bound));
}

void Report::skip(const std::string& what, const std::string& why) {
  fmt::print("  {:<56}  SKIPPED: {}\n", what, why);
  json_["skipped"].push_back({{"section", section_}, {"name", what}, {"why", why}});
}

int Report::verdict() const {
  fmt::print("\n");
  for (const std::string& w : wrong_) fmt::print("wrong answer: {}\n", w);
  for (const std::string& m : missed_) fmt::print("missed: {}\n", m);
  if (wrong_.empty() && missed_.empty())
    fmt::print("{}\n", timing_ ? "all answers right, all required figures met" : "all answers right");
  return wrong_.empty() && missed_.empty() ? 0 : 1;
}

void Report::write_json(const std::string& path) const {
  std::ofstream file(path);
  file << json_.dump(2) << "\n";
  if (!file.flush()) throw WorkError(path + ": cannot be written");
}

}  // namespace airlight::bench
