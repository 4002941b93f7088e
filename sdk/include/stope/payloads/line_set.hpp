#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "stope/geometry.hpp"

namespace stope {

/// Polylines in the map frame, such as mountain edges. Line i runs over vertices begin[i] to
/// begin[i + 1] - 1.
struct LineSet {
  static constexpr std::string_view kType = "stope/LineSet@1";
  std::vector<Vector3> vertices;     ///< metres
  std::vector<std::uint64_t> begin;  ///< one more than there are lines; empty if there are none
  std::vector<std::uint8_t> closed;  ///< by line: 1 if the last vertex joins the first
  std::vector<std::string> kind;     ///< by line, or empty
  static constexpr void fields(auto& s, auto&& visit) {
    visit("vertices", s.vertices);
    visit("begin", s.begin);
    visit("closed", s.closed);
    visit("kind", s.kind);
  }
};

}  // namespace stope
