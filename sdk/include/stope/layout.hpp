#pragma once

#include <string>

#include "stope/digest.hpp"

namespace stope {

// Texts are appended rather than added: g++ 12 warns of `"[" + text` for no reason (its bug
// 105651).

/// The layout of a type as text, such as `{x:f8,y:f8,names:[text]}`: kinds and names of all fields,
/// nested. Two sides that agree on it can exchange payloads.
template <class T>
std::string layout_text() {
  if constexpr (std::is_same_v<T, bool>) {
    return "bool";
  } else if constexpr (std::is_enum_v<T>) {
    return layout_text<std::underlying_type_t<T>>();
  } else if constexpr (std::is_arithmetic_v<T>) {
    std::string text(1, std::is_floating_point_v<T> ? 'f' : (std::is_signed_v<T> ? 'i' : 'u'));
    return text.append(std::to_string(sizeof(T)));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return "text";
  } else if constexpr (traits::IsVector<T>::value) {
    return std::string("[").append(layout_text<typename T::value_type>()).append("]");
  } else if constexpr (traits::IsArray<T>::value) {
    return layout_text<typename T::value_type>() + "*" + std::to_string(std::tuple_size_v<T>);
  } else if constexpr (traits::IsOptional<T>::value) {
    return layout_text<typename T::value_type>() + "?";
  } else if constexpr (traits::IsFixedEigen<T>::value) {
    return layout_text<typename T::Scalar>() + "*" +
           std::to_string(sizeof(T) / sizeof(typename T::Scalar));
  } else if constexpr (std::is_same_v<T, LabelCells>) {
    return "labels#" + std::to_string(sizeof(T)) + "/" + std::to_string(LabelCells::kTileSide) +
           "/" + std::to_string(LabelCells::kTilesAcrossBlock);
  } else {
    static_assert(HasFields<T>, "a field must be a kind that stope/fields.hpp lists");
    std::string text = "{";
    T probe{};
    T::fields(probe, [&text]<class Member>(const char* name, Member&) {
      text.append(name).append(":").append(layout_text<Member>()).append(",");
    });
    // The size tells apart structs whose listed fields agree but whose memory does not.
    return text.append("#").append(std::to_string(sizeof(T))).append("}");
  }
}

/// A hash of layout_text(). Compared between plugin and host, per payload type, before they
/// exchange any.
template <class T>
std::uint64_t layout_hash() {
  return digest_of(layout_text<T>()).low;
}

}  // namespace stope
