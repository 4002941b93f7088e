#pragma once

#include <string>

#include "stope/digest.hpp"

namespace stope {

/// The layout of a type as text, such as `{x:f8,y:f8,names:[text]}`: kinds and names of all fields,
/// nested. Two sides that agree on it can exchange payloads.
template <class T>
std::string layout_text() {
  if constexpr (std::is_same_v<T, bool>) {
    return "bool";
  } else if constexpr (std::is_enum_v<T>) {
    return layout_text<std::underlying_type_t<T>>();
  } else if constexpr (std::is_arithmetic_v<T>) {
    const char kind = std::is_floating_point_v<T> ? 'f' : (std::is_signed_v<T> ? 'i' : 'u');
    return kind + std::to_string(sizeof(T));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return "text";
  } else if constexpr (traits::IsVector<T>::value) {
    return "[" + layout_text<typename T::value_type>() + "]";
  } else if constexpr (traits::IsArray<T>::value) {
    return layout_text<typename T::value_type>() + "*" + std::to_string(std::tuple_size_v<T>);
  } else if constexpr (traits::IsOptional<T>::value) {
    return layout_text<typename T::value_type>() + "?";
  } else if constexpr (traits::IsFixedEigen<T>::value) {
    return layout_text<typename T::Scalar>() + "*" +
           std::to_string(sizeof(T) / sizeof(typename T::Scalar));
  } else {
    static_assert(HasFields<T>, "a field must be a kind that stope/fields.hpp lists");
    std::string text = "{";
    T probe{};
    T::fields(probe, [&text]<class Member>(const char* name, Member&) {
      text += std::string(name) + ":" + layout_text<Member>() + ",";
    });
    // The size tells apart structs whose listed fields agree but whose memory does not.
    return text + "#" + std::to_string(sizeof(T)) + "}";
  }
}

/// A hash of layout_text(). Compared between plugin and host, per payload type, before they
/// exchange any.
template <class T>
std::uint64_t layout_hash() {
  return digest_of(layout_text<T>()).low;
}

}  // namespace stope
