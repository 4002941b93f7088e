#include "framework/pipeline/parameter_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/path_check.hpp"
#include "framework/pipeline/quantity.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

std::string with_unit(double number, const std::string& unit) {
  return unit.empty() ? number_text(number) : number_text(number) + " " + unit;
}

class ParameterCheck {
 public:
  ParameterCheck(const ParameterInfo& parameter, const std::string& owner, Diagnostics& diagnostics)
      : parameter_(parameter), owner_(owner), diagnostics_(diagnostics) {}

  std::optional<ParameterValue> check(const LocatedNode& node) {
    if (node.broken) return std::nullopt;
    if (node.is_empty()) return check_nothing(node);
    switch (parameter_.kind) {
      case ParameterKind::kBool:
        return lifted(boolean(node));
      case ParameterKind::kInteger:
        return lifted(integer(node));
      case ParameterKind::kReal:
        return lifted(real(node, ""));
      case ParameterKind::kText:
        return lifted(text(node, ""));
      case ParameterKind::kPath:
        return lifted(path(node));
      case ParameterKind::kReals:
        return list<double>(node,
                            [&](const auto& item, const auto& which) { return real(item, which); });
      case ParameterKind::kTexts:
        return list<std::string>(
            node, [&](const auto& item, const auto& which) { return text(item, which); });
    }
    return std::nullopt;
  }

 private:
  template <class T>
  static std::optional<ParameterValue> lifted(std::optional<T> value) {
    if (!value) return std::nullopt;
    return ParameterValue(std::move(*value));
  }

  std::nullopt_t report(const char* code, const LocatedNode& node, const std::string& what,
                        const std::string& which = "", const std::string& hint = "") {
    std::string origin;
    if (node.origin)
      origin = fmt::format(" (the variable '{}', from {})", node.origin->variable,
                           to_text(node.origin->place));
    diagnostics_.error(code, node.place,
                       fmt::format("{}'{}' of {} {}{}.", which.empty() ? "" : which,
                                   parameter_.name, owner_, what, origin),
                       hint);
    return std::nullopt;
  }

  std::string expected() const {
    const std::string unit = parameter_.unit.empty() ? "" : fmt::format(" in {}", parameter_.unit);
    switch (parameter_.kind) {
      case ParameterKind::kBool:
        return "true or false";
      case ParameterKind::kInteger:
        return "a whole number" + unit;
      case ParameterKind::kReal:
        return "a number" + unit;
      case ParameterKind::kText:
        return parameter_.limits.choices.empty()
                   ? "a text"
                   : "one of " + quoted_list(parameter_.limits.choices, "or", 20);
      case ParameterKind::kPath:
        return "a path";
      case ParameterKind::kReals:
        return "a list of numbers" + unit;
      default:
        return "a list of texts";
    }
  }

  // What each value of a list must be.
  std::string element() const {
    if (parameter_.kind == ParameterKind::kTexts) return "a text";
    return parameter_.unit.empty() ? "a number" : "a number in " + parameter_.unit;
  }

  std::optional<ParameterValue> check_nothing(const LocatedNode& node) {
    if (parameter_.optional) return ParameterValue{};
    return report(code::kNoValue, node, "has no value here; it must be " + expected(), "",
                  parameter_.limits.required
                      ? ""
                      : fmt::format("Leave it out to get its default, {}.",
                                    value_text(parameter_.default_value, parameter_.unit)));
  }

  std::nullopt_t wrong_kind(const LocatedNode& node, const std::string& which,
                            const std::string& hint = "") {
    return report(code::kWrongType, node,
                  fmt::format("must be {}, here stands {}", which.empty() ? expected() : element(),
                              node.is_scalar() ? fmt::format("'{}'", shown(node.text))
                                               : std::string(kind_name(node))),
                  which, hint);
  }

  std::optional<bool> boolean(const LocatedNode& node) {
    if (node.text == "true") return true;
    if (node.text == "false") return false;
    for (const char* word : {"yes", "on", "True", "TRUE", "1"})
      if (node.text == word) return wrong_kind(node, "", "Write true.");
    for (const char* word : {"no", "off", "False", "FALSE", "0"})
      if (node.text == word) return wrong_kind(node, "", "Write false.");
    return wrong_kind(node, "");
  }

  std::optional<double> real(const LocatedNode& node, const std::string& which) {
    if (node.broken) return std::nullopt;
    if (!node.is_scalar()) return wrong_kind(node, which);
    const std::optional<Quantity> quantity = parse_quantity(node.text);
    if (!quantity)
      return report(code::kWrongType, node,
                    fmt::format("must be {}, here stands '{}'",
                                which.empty() ? expected() : element(), shown(node.text)),
                    which);
    const Conversion converted = convert(*quantity, parameter_.unit);
    if (!converted.value)
      return report(code::kWrongUnit, node,
                    fmt::format("cannot be '{}', which {}", shown(node.text), converted.problem),
                    which, converted.hint);
    if (std::isnan(*converted.value)) return wrong_kind(node, which);
    if (!in_range(*converted.value, node, which)) return std::nullopt;
    return converted.value;
  }

  std::optional<std::int64_t> integer(const LocatedNode& node) {
    const std::optional<double> number = real(node, "");
    if (!number) return std::nullopt;
    constexpr double kLargest = 9007199254740992.0;  // 2^53: beyond it doubles skip integers
    const double whole = std::round(*number);
    if (std::abs(whole) > kLargest)
      return report(
          code::kOutOfRange, node,
          fmt::format("is {}, which is larger than a whole number can be", shown(node.text)));
    if (std::abs(whole - *number) > 1e-9 * std::max(1.0, std::abs(whole)))
      return report(code::kWrongType, node,
                    fmt::format("must be {}, and '{}' is not whole", expected(), shown(node.text)));
    return static_cast<std::int64_t>(whole);
  }

  bool in_range(double value, const LocatedNode& node, const std::string& which) {
    const Limits& limits = parameter_.limits;
    const auto refuse = [&](const std::string& bound) {
      report(code::kOutOfRange, node,
             fmt::format("must be {}, here stands '{}'", bound, shown(node.text)), which);
      return false;
    };
    const bool low = limits.least &&
                     (value < *limits.least || (limits.least_excluded && value == *limits.least));
    const bool high =
        limits.most && (value > *limits.most || (limits.most_excluded && value == *limits.most));
    if (!low && !high) return true;
    const std::string least =
        limits.least ? fmt::format("{} {}", limits.least_excluded ? "more than" : "at least",
                                   with_unit(*limits.least, parameter_.unit))
                     : "";
    const std::string most =
        limits.most ? fmt::format("{} {}", limits.most_excluded ? "less than" : "at most",
                                  with_unit(*limits.most, parameter_.unit))
                    : "";
    return refuse(least.empty() || most.empty() ? least + most : least + " and " + most);
  }

  std::optional<std::string> text(const LocatedNode& node, const std::string& which) {
    if (node.broken) return std::nullopt;
    if (!node.is_scalar()) return wrong_kind(node, which);
    const auto& choices = parameter_.limits.choices;
    if (choices.empty() || std::find(choices.begin(), choices.end(), node.text) != choices.end())
      return node.text;
    return report(code::kNotAChoice, node,
                  fmt::format("must be {}, here stands '{}'",
                              "one of " + quoted_list(choices, "or", 20), shown(node.text)),
                  which, did_you_mean(node.text, choices));
  }

  std::optional<std::string> path(const LocatedNode& node) {
    if (!node.is_scalar()) return wrong_kind(node, "");
    if (node.text.empty())
      return report(code::kNoValue, node, "is an empty path", "",
                    parameter_.limits.required || parameter_.limits.path != PathKind::kNone
                        ? ""
                        : "Leave it out if it is not needed.");
    const std::filesystem::path absolute = absolute_path(node.text, node.folder);
    const PathProblem problem = look_at_path(absolute, parameter_.limits.path);
    if (!problem.sentence.empty())
      return report(code::kMissingPath, node, problem.sentence, "", problem.hint);
    return absolute.string();
  }

  template <class T, class Read>
  std::optional<ParameterValue> list(const LocatedNode& node, const Read& read) {
    if (!node.is_sequence()) {
      report(code::kWrongType, node,
             fmt::format("must be {}, here stands {}", expected(),
                         node.is_scalar() ? fmt::format("'{}'", shown(node.text))
                                          : std::string(kind_name(node))),
             "", node.is_scalar() ? fmt::format("Write [{}].", shown(node.text)) : "");
      return std::nullopt;
    }
    check_count(node);
    std::vector<T> values;
    for (std::size_t i = 0; i < node.items.size(); ++i)
      if (auto value = read(node.items[i], fmt::format("Value {} of ", i + 1)))
        values.push_back(std::move(*value));
    if (values.size() != node.items.size() || wrong_count_) return std::nullopt;
    return ParameterValue(std::move(values));
  }

  void check_count(const LocatedNode& node) {
    const auto& least = parameter_.limits.count_least;
    const auto& most = parameter_.limits.count_most;
    const auto count = static_cast<std::int64_t>(node.items.size());
    if ((!least || count >= *least) && (!most || count <= *most)) return;
    wrong_count_ = true;
    std::string bound;
    if (least && most && *least == *most) {
      bound = fmt::format("exactly {}", *least);
    } else if (least && most) {
      bound = fmt::format("{} to {}", *least, *most);
    } else {
      bound = least ? fmt::format("at least {}", *least) : fmt::format("at most {}", *most);
    }
    report(code::kWrongCount, node, fmt::format("takes {} values, not {}", bound, count));
  }

  const ParameterInfo& parameter_;
  const std::string& owner_;
  Diagnostics& diagnostics_;
  bool wrong_count_ = false;
};

}  // namespace

std::optional<ParameterValue> check_parameter(const ParameterInfo& parameter,
                                              const LocatedNode& node, const std::string& owner,
                                              Diagnostics& diagnostics) {
  return ParameterCheck(parameter, owner, diagnostics).check(node);
}

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

}  // namespace stope
