#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stope {

/// A unit of measure as a number of base units: value * numerator / denominator. Two numbers rather
/// than one factor keep decimal units exact: 57 cm is 0.57 m to the last bit.
struct Unit {
  /// Powers of metre, second, kilogram, radian and byte.
  std::array<int, 5> dimension{};
  double numerator = 1, denominator = 1;
};

/// Reads `m`, `km/h`, `m/s^2`, `m²`, `1/m`, `%`, `GiB`…; an empty text is a plain number. Nothing
/// if a symbol is not known.
std::optional<Unit> parse_unit(std::string_view text);

/// "a length", "an angle", "a speed"…; for a dimension without a name of its own, nothing.
std::string dimension_name(const Unit& unit);

/// The units people may write where `unit` is wanted, the wanted one first.
std::vector<std::string> units_like(std::string_view unit);

}  // namespace stope
