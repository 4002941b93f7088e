#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stope {

/// A number as a person writes it, with or without a unit: `8 m`, `1.5e3`, `.5`, `-30deg`, `inf`.
struct Quantity {
  double number = 0;
  std::string unit;  ///< as written; empty for a bare number
};

/// Splits a text into number and unit. Nothing if it does not begin with a number; the unit is not
/// looked at.
std::optional<Quantity> parse_quantity(std::string_view text);

/// What came of converting a quantity.
struct Conversion {
  std::optional<double> value;  ///< in the wanted unit, if the units agree
  std::string problem;          ///< else what is wrong, as the end of a sentence about the quantity
  std::string hint;
};

/// The quantity in `wanted`, the parameter's own unit; a bare number is in that unit already.
Conversion convert(const Quantity& quantity, std::string_view wanted);

/// The shortest decimal text that reads back as the same number.
std::string number_text(double number);

}  // namespace stope
