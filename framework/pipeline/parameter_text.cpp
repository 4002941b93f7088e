#include "framework/pipeline/parameter_text.hpp"

#include <fmt/format.h>

#include "framework/pipeline/quantity.hpp"

namespace stope {
namespace {

std::string with_unit(double number, const std::string& unit) {
  return unit.empty() ? number_text(number) : number_text(number) + " " + unit;
}

}  // namespace

std::string value_text(const ParameterValue& value, const std::string& unit) {
  struct Text {
    const std::string& unit;
    std::string operator()(std::monostate) const { return "nothing"; }
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const {
      return unit.empty() ? fmt::format("{}", i) : fmt::format("{} {}", i, unit);
    }
    std::string operator()(double d) const { return with_unit(d, unit); }
    std::string operator()(const std::string& s) const { return "'" + s + "'"; }
    std::string operator()(const std::vector<double>& list) const {
      std::string text;
      for (const double d : list) text.append(text.empty() ? "" : ", ").append(with_unit(d, unit));
      return std::string("[").append(text).append("]");
    }
    std::string operator()(const std::vector<std::string>& list) const {
      std::string text;
      for (const std::string& s : list) text.append(text.empty() ? "" : ", ").append(s);
      return std::string("[").append(text).append("]");
    }
  };
  return std::visit(Text{unit}, value);
}

bool within(double value, const Limits& limits) {
  const bool low =
      limits.least && (value < *limits.least || (limits.least_excluded && value == *limits.least));
  const bool high =
      limits.most && (value > *limits.most || (limits.most_excluded && value == *limits.most));
  return !low && !high;
}

std::string range_text(const Limits& limits, const std::string& unit) {
  std::string text;
  if (limits.least)
    text = fmt::format("{} {}", limits.least_excluded ? "more than" : "at least",
                       with_unit(*limits.least, unit));
  if (limits.least && limits.most) text.append(" and ");
  if (limits.most)
    text.append(fmt::format("{} {}", limits.most_excluded ? "less than" : "at most",
                            with_unit(*limits.most, unit)));
  return text;
}

std::string count_text(const Limits& limits) {
  const auto &least = limits.count_least, &most = limits.count_most;
  if (least && most && *least == *most) return fmt::format("exactly {}", *least);
  if (least && most) return fmt::format("{} to {}", *least, *most);
  if (least) return fmt::format("at least {}", *least);
  return most ? fmt::format("at most {}", *most) : std::string("any number of");
}

}  // namespace stope
