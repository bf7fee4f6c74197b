// What a model says on the yardstick's rays, and what that costs.
#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "validate/yardstick.h"

namespace airlight::validation {

struct Cost {
  double tables_seconds = 0;   ///< processor time for the tables of four wavelengths, all threads
  double tables_bytes = 0;     ///< of those tables, the ones that only make others included
  double ray_nanoseconds = 0;  ///< processor time of one of many rays at four wavelengths, from kept tables
};

/// A model with parameters of its own.
struct Contestant {
  std::string name;  ///< "precomputed", "precomputed:detail=draft"
  std::string model;
  Parameters parameters;
};

/// Answers to the rays of one atmosphere, by their places in the yardstick.
struct ModelAnswers {
  std::string model, atmosphere;  ///< the contestant's name
  bool colours = false;           ///< a published system: values are red, green and blue, in its own unit
  struct Ray {
    std::size_t place;
    std::vector<double> value;          ///< for each wavelength, or colour; empty: the model does not answer
    std::vector<double> transmittance;  ///< the same
  };
  std::vector<Ray> rays;
  Cost cost;
};

/// Published systems are asked for the sky from the ground alone: they were made for that.
ModelAnswers ask_model(const Contestant& contestant, const std::string& atmosphere, const Yardstick& yardstick,
                       std::shared_ptr<Engine> engine);

/// What answers to rays of the yardstick cost that the model has answered.
/// @param engine  holds no tables yet
Cost cost_of(const Contestant& contestant, const ModelAnswers& answers, const Yardstick& yardstick,
             std::shared_ptr<Engine> engine);

// To go on after an interruption.
nlohmann::ordered_json to_json(const ModelAnswers& answers);
ModelAnswers model_answers_from(const nlohmann::ordered_json& json);  ///< @throws nlohmann's exceptions

}  // namespace airlight::validation
