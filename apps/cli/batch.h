// `airlight probe --batch`: many questions, one JSON object a line, answered together where they differ only in their
// rays.
#pragma once
#include <string>

#include "answers.h"

namespace airlight::cli {

/// @param otherwise  atmosphere and model of lines that name none
/// @returns          exit code: 0, or 1 when a line could not be answered
int answer_batch(const std::string& input, const std::string& output, Answerers& answerers, const Topic& otherwise);

}  // namespace airlight::cli
