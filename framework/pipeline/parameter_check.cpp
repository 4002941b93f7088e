#include "framework/pipeline/parameter_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/parameter_text.hpp"
#include "framework/pipeline/path_check.hpp"
#include "framework/pipeline/quantity.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

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
    if (within(value, parameter_.limits)) return true;
    report(code::kOutOfRange, node,
           fmt::format("must be {}, here stands '{}'",
                       range_text(parameter_.limits, parameter_.unit), shown(node.text)),
           which);
    return false;
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
    const auto count = static_cast<std::int64_t>(node.items.size());
    const Limits& limits = parameter_.limits;
    wrong_count_ = (limits.count_least && count < *limits.count_least) ||
                   (limits.count_most && count > *limits.count_most);
    if (wrong_count_)
      report(code::kWrongCount, node,
             fmt::format("takes {} values, not {}", count_text(limits), count));
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

}  // namespace stope
