#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// How a payload names its parts. One `fields` list gives codec, digest, size and layout hash:
///
///     struct Sector {
///       static constexpr std::string_view kType = "acme/Sector@1";
///       std::int64_t cells = 0;
///       std::string name;
///       static constexpr void fields(auto& s, auto&& visit) { visit("cells", s.cells);
///       visit("name", s.name); }
///     };
///
/// A field is a number, bool, enum, std::string, std::vector, std::array, std::optional, a
/// fixed-size Eigen type with DontAlign, LabelCells, or a struct with a `fields` list of its own.
/// List every member, once, in the order of declaration.
namespace stope {

struct AnyVisitor {
  template <class T>
  constexpr void operator()(const char*, T&) const {}
};

/// A struct with a `fields` list.
template <class T>
concept HasFields = requires(T& value) {
  T::fields(value, AnyVisitor{});
};

/// A struct that can travel between stages: it has fields, a name with a version, and a default
/// value.
template <class T>
concept PayloadStruct = HasFields<T> && std::default_initializable<T> && requires {
  { T::kType } -> std::convertible_to<std::string_view>;
};

namespace traits {

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
struct IsFixedEigen : std::false_type {};
template <class S, int R, int C, int O>
requires(R > 0 && C > 0) struct IsFixedEigen<Eigen::Matrix<S, R, C, O>>
    : std::bool_constant<(O & Eigen::DontAlign) != 0> {
};
template <class S>
struct IsFixedEigen<Eigen::Quaternion<S, Eigen::DontAlign>> : std::true_type {};

template <class T>
concept Number = (std::is_arithmetic_v<T> || std::is_enum_v<T>)&&!std::is_same_v<T, bool>;

}  // namespace traits

/// Whether every byte of a T is data: no padding, no pointers. Vectors of such elements are written
/// in one piece.
template <class T>
bool is_flat() {
  if constexpr (traits::Number<T> || traits::IsFixedEigen<T>::value) {
    return true;
  } else if constexpr (traits::IsArray<T>::value) {
    return is_flat<typename T::value_type>();
  } else if constexpr (HasFields<T>) {
    std::size_t sum = 0;
    bool flat = true;
    T probe{};
    T::fields(probe, [&]<class Member>(const char*, Member&) {
      flat = flat && is_flat<Member>();
      sum += sizeof(Member);
    });
    return flat && sum == sizeof(T);
  } else {
    return false;
  }
}

}  // namespace stope
