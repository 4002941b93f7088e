#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "framework/compare/comparison.hpp"

namespace stope {

/// What a comparison says, for a person at a terminal: for each arm what may be said of it beside
/// the baseline, what was left out, and how long arms take.
std::string comparison_text(const Comparison& comparison);

/// How a comparison ended, for a program.
nlohmann::ordered_json comparison_end_json(const Comparison& comparison);

}  // namespace stope
