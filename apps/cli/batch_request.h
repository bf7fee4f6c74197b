// One line of `airlight probe --batch`: text in, question or error out. No state, no files: fuzzed by
// tests/fuzz/fuzz_jsonl.cpp.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "question.h"

namespace airlight::cli {

struct BatchRequest {
  nlohmann::json id;  ///< echoed; null where the line has none
  Topic topic;
  Ray ray;
  std::string error;  ///< not empty: the line cannot be answered, and why
};

/// @param otherwise  atmosphere and model of lines that name none
/// Never throws for what the text holds.
BatchRequest parse_batch_request(std::string_view text, const Topic& otherwise);

}  // namespace airlight::cli
