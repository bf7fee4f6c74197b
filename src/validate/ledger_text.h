// The ledger for people and for programs.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validate/ledger.h"

namespace airlight::validation {

std::string as_csv(const Ledger& ledger);
nlohmann::ordered_json as_json(const Ledger& ledger);
/// @throws nlohmann's exceptions
Ledger ledger_from(const nlohmann::ordered_json& json);

/// The part of docs/accuracy.md that the command writes.
/// @param name  of the chart and the table beside it, from the page, without ".svg" and ".csv"
std::string as_markdown(const Ledger& ledger, const std::string& name);

/// Error (90th percentile of all rays under a sun of -2 degrees or higher, air `earth`) against the time of a ray, both logarithmic.
std::string as_svg(const Ledger& ledger);

/// Lines on what is worse in `now` than in `before` by more than engines, compilers and instruction sets may differ.
std::vector<std::string> worse_than(const Ledger& now, const Ledger& before);

}  // namespace airlight::validation
