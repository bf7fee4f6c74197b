// What is asked on the command line, and who answers: the one place that turns a model's name into answers. Every model
// and solver is an Answerer in a file of its own (answers_*.cpp), known to this registry and to nobody else.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/sky.h"
#include "question.h"

namespace airlight::cli {

/// What one question is answered with.
struct Answer {
  std::vector<double> value;
  nlohmann::ordered_json more = nlohmann::ordered_json::object();  ///< further keys of the answer's line
};

/// Answers questions under one model's name. Lives as long as the command and keeps what is costly to make.
class Answerer {
 public:
  virtual ~Answerer() = default;

  virtual bool has(const Asked& asked) const = 0;

  /// Answers to questions of one topic that differ only in their rays, in their order.
  /// @param topic  has(*topic.asked) holds
  /// @throws InputError naming the value that is out of range or cannot be answered; WorkError; Interrupted, which work
  /// of more than a second must look out for.
  virtual std::vector<Answer> answer(const Topic& topic, std::span<const Ray> rays) = 0;

  /// What computes: "simd (avx512, 2 threads)".
  virtual std::string engine() const = 0;
};

/// What answerers are made from.
struct Workshop {
  std::shared_ptr<Engine> engine;
  std::function<Atmosphere(const std::string& name)> atmosphere;  ///< throws InputError
  std::string model = {};                                         ///< whose parameters these are
  Parameters parameters = {};
};

/// Answerers by model name, made when first asked for.
class Answerers {
 public:
  explicit Answerers(Workshop workshop) : workshop_(std::move(workshop)) {}

  /// @throws InputError for a name that is unknown, or that this program was built without.
  Answerer& named(const std::string& model);

  /// Answers through the model that the topic names. @throws as Answerer::answer does, also for a quantity that the
  /// model does not have.
  std::vector<Answer> answer(const Topic& topic, std::span<const Ray> rays);

 private:
  Workshop workshop_;
  std::map<std::string, std::unique_ptr<Answerer>> made_;
};

/// The names that answer: the models of the sky, and the solvers that they are judged by.
std::vector<std::string_view> answering_models();

/// Spectral values in, what was asked out: the eye's weight on photometric questions, and the sun where it belongs to
/// them.
/// @param ask  N x W spectral values for N rays and W wavelengths [nm], ray slowest
std::vector<Answer> as_asked(
    const Topic& topic, std::span<const Ray> rays,
    const std::function<std::vector<double>(Quantity, std::span<const double> wavelengths)>& ask);

// ---- one for each answers_*.cpp ----

std::unique_ptr<Answerer> make_sky_answerer(const std::string& model, const Workshop& workshop);
std::unique_ptr<Answerer> make_reference_answerer(const Workshop& workshop);
std::unique_ptr<Answerer> make_single_scattering_answerer(const Workshop& workshop);
std::unique_ptr<Answerer> make_plane_parallel_answerer(const Workshop& workshop);

}  // namespace airlight::cli
