// The table that is printed while the benchmarks run, the same as JSON, and the verdict.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace airlight::bench {

/// One line of the table.
struct Measured {
  std::string name;
  double value = 0;
  std::string unit;                  ///< "ns/pixel", "CPU-ms", "x"
  std::optional<double> at_most{};   ///< required, in the same unit
  std::optional<double> at_least{};  ///< required
  std::optional<double>
      limit{};  ///< what its exps and texels alone would take at the machine's measured rates, in the same unit
};

class Report {
 public:
  /// @param timing  false: answers are checked, nothing is timed
  explicit Report(bool timing) : timing_(timing) {}
  bool timing() const { return timing_; }

  void describe(const std::string& key, const std::string& value);
  void section(const std::string& title);
  void add(const Measured& line);
  /// An answer's largest difference from the truth, and what it may be.
  void check(const std::string& what, double difference, double bound);
  void skip(const std::string& what, const std::string& why);

  /// Says which required figures were missed and which answers were wrong.
  int verdict() const;
  void write_json(const std::string& path) const;

 private:
  bool timing_;
  std::string section_;
  std::vector<std::string> missed_, wrong_;
  nlohmann::ordered_json json_;
};

}  // namespace airlight::bench
