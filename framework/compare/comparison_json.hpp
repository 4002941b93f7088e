#pragma once

#include <string>
#include <string_view>

#include "framework/compare/comparison.hpp"

namespace stope {

/// comparison.json: all of a Comparison but the folder it is in. docs/comparing.md describes each
/// field. Keys stand in a fixed order; what is not finite is null.
std::string comparison_json(const Comparison& comparison);

/// Reads it back; the folder is left to the caller. Throws Error with a sentence if it is not one
/// that this Stope wrote.
Comparison read_comparison_json(std::string_view text);

}  // namespace stope
