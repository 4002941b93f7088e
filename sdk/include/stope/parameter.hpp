#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "stope/fields.hpp"

namespace stope {

/// A parameter's value as it travels from a pipeline file to a stage, in the parameter's own unit
/// (SI). An empty one (monostate) means that an optional parameter is not given. Paths travel as
/// absolute text.
using ParameterValue = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                                    std::vector<double>, std::vector<std::string>>;

enum class ParameterKind : int { kBool, kInteger, kReal, kText, kPath, kReals, kTexts };

/// What a path parameter must name when the pipeline is checked.
enum class PathKind : int { kNone, kFile, kFolder, kFileOrFolder };

/// The values a parameter accepts. Combine with `+`: `at_least(0.0) + at_most(1.0)`.
struct Limits {
  std::optional<double> least, most;  ///< of a number, or of each number of a list
  bool least_excluded = false;
  bool most_excluded = false;
  std::vector<std::string> choices;                     ///< of a text, or of each text of a list
  std::optional<std::int64_t> count_least, count_most;  ///< of a list's length
  PathKind path = PathKind::kNone;
  bool required = false;  ///< has no usable default
};

inline Limits any() { return {}; }
inline Limits at_least(double least) {
  Limits limits;
  limits.least = least;
  return limits;
}
inline Limits more_than(double least) {
  Limits limits = at_least(least);
  limits.least_excluded = true;
  return limits;
}
inline Limits at_most(double most) {
  Limits limits;
  limits.most = most;
  return limits;
}
inline Limits less_than(double most) {
  Limits limits = at_most(most);
  limits.most_excluded = true;
  return limits;
}
inline Limits between(double least, double most) {
  Limits limits = at_least(least);
  limits.most = most;
  return limits;
}
inline Limits one_of(std::vector<std::string> choices) {
  Limits limits;
  limits.choices = std::move(choices);
  return limits;
}
inline Limits count(std::int64_t least, std::int64_t most) {
  Limits limits;
  limits.count_least = least;
  limits.count_most = most;
  return limits;
}
inline Limits required() {
  Limits limits;
  limits.required = true;
  return limits;
}
inline Limits existing(PathKind kind) {
  Limits limits;
  limits.path = kind;
  return limits;
}

inline Limits operator+(Limits a, const Limits& b) {
  if (b.least) a.least = b.least, a.least_excluded = b.least_excluded;
  if (b.most) a.most = b.most, a.most_excluded = b.most_excluded;
  if (!b.choices.empty()) a.choices = b.choices;
  if (b.count_least) a.count_least = b.count_least;
  if (b.count_most) a.count_most = b.count_most;
  if (b.path != PathKind::kNone) a.path = b.path;
  a.required = a.required || b.required;
  return a;
}

/// A parameter as a stage declares it.
struct ParameterInfo {
  std::string name;
  ParameterKind kind = ParameterKind::kReal;
  bool optional = false;  ///< may be left out without a default (std::optional in Params)
  ParameterValue default_value;
  std::string unit;  ///< SI: m, m^2, s, rad, Hz, m/s, B, or empty for a plain number
  Limits limits;
  std::string doc;  ///< one sentence
};

/// How a C++ type stands as a parameter. Params members may be bool, integers, floating point,
/// std::string, std::filesystem::path, std::vector or std::array of double, std::vector of
/// std::string, and std::optional of these.
template <class T>
struct ParameterTraits {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kind() {
    if constexpr (std::is_same_v<T, bool>) {
      return ParameterKind::kBool;
    } else if constexpr (std::is_integral_v<T>) {
      return ParameterKind::kInteger;
    } else if constexpr (std::is_floating_point_v<T>) {
      return ParameterKind::kReal;
    } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
      return ParameterKind::kPath;
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      return ParameterKind::kTexts;
    } else if constexpr (std::is_same_v<T, std::vector<double>> || traits::IsArray<T>::value) {
      return ParameterKind::kReals;
    } else {
      static_assert(std::is_same_v<T, std::string>, "this type cannot be a parameter");
      return ParameterKind::kText;
    }
  }
  static ParameterValue to_value(const T& member) {
    if constexpr (std::is_same_v<T, bool>) {
      return member;
    } else if constexpr (std::is_integral_v<T>) {
      return static_cast<std::int64_t>(member);
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<double>(member);
    } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
      return member.string();
    } else if constexpr (traits::IsArray<T>::value) {
      return std::vector<double>(member.begin(), member.end());
    } else {
      return member;
    }
  }
  static void assign(T& member, const ParameterValue& value) {
    if constexpr (std::is_same_v<T, bool>) {
      member = std::get<bool>(value);
    } else if constexpr (std::is_integral_v<T>) {
      member = static_cast<T>(std::get<std::int64_t>(value));
    } else if constexpr (std::is_floating_point_v<T>) {
      member = static_cast<T>(std::get<double>(value));
    } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
      member = std::get<std::string>(value);
    } else if constexpr (traits::IsArray<T>::value) {
      const auto& list = std::get<std::vector<double>>(value);
      for (std::size_t i = 0; i < member.size() && i < list.size(); ++i) member[i] = list[i];
    } else {
      member = std::get<T>(value);
    }
  }
  static Limits implied_limits() {
    if constexpr (traits::IsArray<T>::value) {
      return count(std::tuple_size_v<T>, std::tuple_size_v<T>);
    } else if constexpr (std::is_same_v<T, bool>) {
      return {};
    } else if constexpr (std::is_integral_v<T> && sizeof(T) < sizeof(std::int64_t)) {
      // What does not fit the member is refused by the check, never cut off.
      return between(std::numeric_limits<T>::min(), std::numeric_limits<T>::max());
    } else if constexpr (std::is_unsigned_v<T>) {
      return at_least(0);
    } else {
      return {};
    }
  }
};

template <class T>
struct ParameterTraits<std::optional<T>> {
  static constexpr bool kOptional = true;
  static constexpr ParameterKind kind() { return ParameterTraits<T>::kind(); }
  static ParameterValue to_value(const std::optional<T>& member) {
    return member ? ParameterTraits<T>::to_value(*member) : ParameterValue{};
  }
  static void assign(std::optional<T>& member, const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
      member.reset();
    } else {
      ParameterTraits<T>::assign(member.emplace(), value);
    }
  }
  static Limits implied_limits() { return ParameterTraits<T>::implied_limits(); }
};

}  // namespace stope
