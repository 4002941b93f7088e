#pragma once

#include <string>

#include "stope/parameter.hpp"

namespace stope {

/// A value of a parameter as people write it: `3 m`, `[0, 1]`, `trinary`; "nothing" for a
/// monostate.
std::string value_text(const ParameterValue& value, const std::string& unit);

/// Whether a number keeps the limits.
bool within(double value, const Limits& limits);

/// "at least 0 m and at most 8 m".
std::string range_text(const Limits& limits, const std::string& unit);

/// "exactly 2", "1 to 4": how many values a list takes.
std::string count_text(const Limits& limits);

}  // namespace stope
