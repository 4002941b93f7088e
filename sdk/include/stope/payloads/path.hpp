#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace stope {

/// A place along a path.
struct PathPoint {
  double x = 0, y = 0, z = 0;  ///< metres, map frame; z is NaN where there is no elevation
  double yaw = 0;              ///< radians, heading of the vehicle
  double clearance = 0;        ///< metres to the nearest obstacle; NaN: not known
  double curvature = 0;        ///< 1/m, positive to the left
  double speed = 0;            ///< m/s, negative backwards, 0: not planned
  static constexpr void fields(auto& s, auto&& visit) {
    visit("x", s.x);
    visit("y", s.y);
    visit("z", s.z);
    visit("yaw", s.yaw);
    visit("clearance", s.clearance);
    visit("curvature", s.curvature);
    visit("speed", s.speed);
  }
};

/// A way to drive from start to goal.
struct Path {
  static constexpr std::string_view kType = "stope/Path@1";
  std::vector<PathPoint> points;
  std::vector<std::uint64_t> edges;  ///< ids of the road graph's edges it follows, in order
  double length = 0;                 ///< metres
  static constexpr void fields(auto& s, auto&& visit) {
    visit("points", s.points);
    visit("edges", s.edges);
    visit("length", s.length);
  }
};

}  // namespace stope
