#include "framework/pipeline/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "framework/diagnostics/diagnostic.hpp"
#include "framework/pipeline/unit.hpp"

namespace stope {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text.append(i + 1 == names.size() ? " or " : ", ");
    text.append(names[i]);
  }
  return text;
}

// The symbol of a unit that people write out.
std::string usual_symbol(const std::string& written) {
  struct Word {
    const char *word, *symbol;
  };
  for (const Word& known :
       {Word{"meter", "m"}, {"meters", "m"},    {"metre", "m"},    {"metres", "m"},
        {"sec", "s"},       {"secs", "s"},      {"second", "s"},   {"seconds", "s"},
        {"minute", "min"},  {"minutes", "min"}, {"mins", "min"},   {"hour", "h"},
        {"hours", "h"},     {"hr", "h"},        {"degree", "deg"}, {"degrees", "deg"},
        {"kmh", "km/h"},    {"kph", "km/h"},    {"kmph", "km/h"},  {"hertz", "Hz"},
        {"sqm", "m^2"},     {"m2", "m^2"},      {"m3", "m^3"},     {"bytes", "B"},
        {"KB", "kB"},       {"G", "GiB"},       {"M", "MiB"},      {"radians", "rad"}})
    if (written == known.word) return known.symbol;
  return {};
}

}  // namespace

std::optional<Quantity> parse_quantity(std::string_view text) {
  text = trimmed(text);
  bool negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    negative = text[0] == '-';
    text.remove_prefix(1);
  }
  Quantity quantity;
  std::string_view rest;
  if (text.starts_with(".inf") || text.starts_with("inf")) {
    quantity.number = std::numeric_limits<double>::infinity();
    rest = text.substr(text[0] == '.' ? 4 : 3);
    if (!rest.empty() && rest[0] != ' ') return std::nullopt;
  } else {
    if (text.empty() || !(text[0] == '.' || (text[0] >= '0' && text[0] <= '9')))
      return std::nullopt;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, quantity.number);
    if (result.ec != std::errc()) return std::nullopt;
    rest = std::string_view(result.ptr, static_cast<std::size_t>(end - result.ptr));
  }
  if (negative) quantity.number = -quantity.number;
  quantity.unit = std::string(trimmed(rest));
  return quantity;
}

Conversion convert(const Quantity& quantity, std::string_view wanted) {
  if (quantity.unit.empty() || quantity.unit == wanted) return {quantity.number, {}, {}};
  const std::optional<Unit> from = parse_unit(quantity.unit), to = parse_unit(wanted);
  const std::vector<std::string> accepted = units_like(wanted);
  const std::string expected =
      wanted.empty() ? "a plain number is expected"
                     : fmt::format("{} in {} is expected",
                                   to && !dimension_name(*to).empty() ? dimension_name(*to)
                                                                      : std::string("a quantity"),
                                   listed(accepted));
  if (!from) {
    if (quantity.unit[0] == ',')
      return {{}, "has a comma where a decimal point is expected", "Write it with a point."};
    std::string nearest = usual_symbol(quantity.unit);
    if (std::find(accepted.begin(), accepted.end(), nearest) == accepted.end())
      nearest = wanted.empty() ? "" : nearest_name(quantity.unit, accepted);
    return {{},
            fmt::format("has the unit '{}', which is not known; {}", quantity.unit, expected),
            nearest.empty() ? "" : fmt::format("Did you mean '{}'?", nearest)};
  }
  if (!to || from->dimension != to->dimension) {
    const std::string is = dimension_name(*from);
    return {{},
            is.empty() ? fmt::format("has the unit '{}', but {}", quantity.unit, expected)
                       : fmt::format("is {}, but {}", is, expected),
            {}};
  }
  return {
      quantity.number * (from->numerator * to->denominator) / (from->denominator * to->numerator),
      {},
      {}};
}

std::string number_text(double number) { return fmt::format("{}", number); }

}  // namespace stope
