#pragma once

#include <string_view>

#include "stope/geometry.hpp"
#include "stope/time.hpp"
#include "stope/visibility.hpp"

namespace stope {

/// The sensor's pose in the map frame at a time.
struct StampedPose {
  static constexpr std::string_view kType = "stope/StampedPose@1";
  Stamp stamp = 0;  ///< nanoseconds
  Pose T_map_lidar;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("stamp", s.stamp);
    visit("T_map_lidar", s.T_map_lidar);
  }
};

}  // namespace stope
