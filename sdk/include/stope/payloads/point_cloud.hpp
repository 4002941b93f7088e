#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/geometry.hpp"

namespace stope {

/// Points in the map frame, stored relative to `origin` so that single precision suffices far from
/// zero (UTM). Each array but `points` is either empty (not known) or as long as `points`.
struct PointCloud {
  static constexpr std::string_view kType = "stope/PointCloud@1";
  Vector3 origin = Vector3::Zero();  ///< metres, map frame; add it to every point
  std::vector<Point3f> points;       ///< metres, relative to origin
  std::vector<float> intensity;
  std::vector<std::uint8_t> label;  ///< a PointLabel
  static constexpr void fields(auto& s, auto&& visit) {
    visit("origin", s.origin);
    visit("points", s.points);
    visit("intensity", s.intensity);
    visit("label", s.label);
  }
};

}  // namespace stope
