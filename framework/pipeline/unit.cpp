#include "framework/pipeline/unit.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

namespace stope {
namespace {

struct Symbol {
  std::string_view name;
  std::array<int, 5> dimension;  // m, s, kg, rad, B
  double numerator, denominator;
};

constexpr double kPi = std::numbers::pi;

// "m", "s" and the like first: units_like() lists them in this order.
constexpr Symbol kSymbols[] = {
    {"m", {1, 0, 0, 0, 0}, 1, 1},
    {"km", {1, 0, 0, 0, 0}, 1000, 1},
    {"cm", {1, 0, 0, 0, 0}, 1, 100},
    {"mm", {1, 0, 0, 0, 0}, 1, 1000},
    {"um", {1, 0, 0, 0, 0}, 1, 1e6},
    {"µm", {1, 0, 0, 0, 0}, 1, 1e6},
    {"ha", {2, 0, 0, 0, 0}, 10000, 1},
    {"s", {0, 1, 0, 0, 0}, 1, 1},
    {"ms", {0, 1, 0, 0, 0}, 1, 1000},
    {"us", {0, 1, 0, 0, 0}, 1, 1e6},
    {"µs", {0, 1, 0, 0, 0}, 1, 1e6},
    {"ns", {0, 1, 0, 0, 0}, 1, 1e9},
    {"min", {0, 1, 0, 0, 0}, 60, 1},
    {"h", {0, 1, 0, 0, 0}, 3600, 1},
    {"d", {0, 1, 0, 0, 0}, 86400, 1},
    {"Hz", {0, -1, 0, 0, 0}, 1, 1},
    {"kHz", {0, -1, 0, 0, 0}, 1000, 1},
    {"MHz", {0, -1, 0, 0, 0}, 1e6, 1},
    {"rpm", {0, -1, 0, 0, 0}, 1, 60},
    {"rad", {0, 0, 0, 1, 0}, 1, 1},
    {"mrad", {0, 0, 0, 1, 0}, 1, 1000},
    {"deg", {0, 0, 0, 1, 0}, kPi, 180},
    {"°", {0, 0, 0, 1, 0}, kPi, 180},
    {"kg", {0, 0, 1, 0, 0}, 1, 1},
    {"g", {0, 0, 1, 0, 0}, 1, 1000},
    {"t", {0, 0, 1, 0, 0}, 1000, 1},
    {"N", {1, -2, 1, 0, 0}, 1, 1},
    {"kN", {1, -2, 1, 0, 0}, 1000, 1},
    {"W", {2, -3, 1, 0, 0}, 1, 1},
    {"kW", {2, -3, 1, 0, 0}, 1000, 1},
    {"B", {0, 0, 0, 0, 1}, 1, 1},
    {"KiB", {0, 0, 0, 0, 1}, 1024, 1},
    {"MiB", {0, 0, 0, 0, 1}, 1048576, 1},
    {"GiB", {0, 0, 0, 0, 1}, 1073741824, 1},
    {"TiB", {0, 0, 0, 0, 1}, 1099511627776, 1},
    {"kB", {0, 0, 0, 0, 1}, 1e3, 1},
    {"MB", {0, 0, 0, 0, 1}, 1e6, 1},
    {"GB", {0, 0, 0, 0, 1}, 1e9, 1},
    {"TB", {0, 0, 0, 0, 1}, 1e12, 1},
    {"%", {0, 0, 0, 0, 0}, 1, 100},
};

// The compound units people write, for units_like().
constexpr std::string_view kCompounds[] = {"m^2",  "km^2",  "m^3",   "m/s",
                                           "km/h", "m/s^2", "rad/s", "deg/s"};

struct NamedDimension {
  std::array<int, 5> dimension;
  std::string_view name;
};
constexpr NamedDimension kDimensions[] = {
    {{0, 0, 0, 0, 0}, "a plain number"}, {{1, 0, 0, 0, 0}, "a length"},
    {{2, 0, 0, 0, 0}, "an area"},        {{3, 0, 0, 0, 0}, "a volume"},
    {{0, 1, 0, 0, 0}, "a time"},         {{0, -1, 0, 0, 0}, "a frequency"},
    {{1, -1, 0, 0, 0}, "a speed"},       {{1, -2, 0, 0, 0}, "an acceleration"},
    {{0, 0, 0, 1, 0}, "an angle"},       {{0, -1, 0, 1, 0}, "a turning rate"},
    {{0, 0, 1, 0, 0}, "a mass"},         {{0, 0, 0, 0, 1}, "a number of bytes"},
    {{1, -2, 1, 0, 0}, "a force"},       {{2, -3, 1, 0, 0}, "a power"},
    {{-1, 0, 0, 0, 0}, "a curvature"},   {{-1, 0, 0, 1, 0}, "an angle per length"},
};

// A power at the end of a factor: `^2`, `^-1`, `²`, `³`. False if it is not one.
bool take_power(std::string_view& factor, int& power) {
  constexpr std::string_view kSquare = "²", kCube = "³";
  power = 1;
  if (factor.ends_with(kSquare)) {
    power = 2;
    factor.remove_suffix(kSquare.size());
  } else if (factor.ends_with(kCube)) {
    power = 3;
    factor.remove_suffix(kCube.size());
  } else if (const auto caret = factor.find('^'); caret != std::string_view::npos) {
    const std::string_view digits = factor.substr(caret + 1);
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), power);
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size()) return false;
    if (power < -4 || power > 4) return false;
    factor = factor.substr(0, caret);
  }
  return true;
}

const Symbol* find_symbol(std::string_view name) {
  for (const Symbol& symbol : kSymbols)
    if (symbol.name == name) return &symbol;
  return nullptr;
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  Unit unit;
  bool divided = false;
  while (!text.empty()) {
    const auto end = text.find_first_of("*/");
    std::string_view factor = text.substr(0, end);
    int power = 1;
    if (!take_power(factor, power)) return std::nullopt;
    if (factor != "1") {
      const Symbol* symbol = find_symbol(factor);
      if (!symbol) return std::nullopt;
      if (divided) power = -power;
      for (std::size_t i = 0; i < unit.dimension.size(); ++i)
        unit.dimension[i] += symbol->dimension[i] * power;
      for (int i = 0; i < std::abs(power); ++i) {
        unit.numerator *= power > 0 ? symbol->numerator : symbol->denominator;
        unit.denominator *= power > 0 ? symbol->denominator : symbol->numerator;
      }
    }
    if (end == std::string_view::npos) return unit;
    divided = text[end] == '/';
    text.remove_prefix(end + 1);
    if (text.empty()) return std::nullopt;
  }
  return unit;
}

std::string dimension_name(const Unit& unit) {
  for (const NamedDimension& known : kDimensions)
    if (known.dimension == unit.dimension) return std::string(known.name);
  return {};
}

std::vector<std::string> units_like(std::string_view wanted) {
  std::vector<std::string> result{std::string(wanted)};
  const std::optional<Unit> unit = parse_unit(wanted);
  const auto consider = [&](std::string_view name) {
    const std::optional<Unit> other = parse_unit(name);
    const bool ascii = static_cast<unsigned char>(name.front()) < 0x80;
    if (unit && other && ascii && other->dimension == unit->dimension && name != wanted)
      result.emplace_back(name);
  };
  for (const Symbol& symbol : kSymbols) consider(symbol.name);
  for (const std::string_view compound : kCompounds) consider(compound);
  return result;
}

}  // namespace stope
