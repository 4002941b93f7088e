#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/geometry.hpp"

namespace stope {

/// One sweep of a LiDAR, in the sensor's frame, not motion-compensated. The item's stamp is the
/// time of its last point. Each array but `points` is either empty (not known) or as long as
/// `points`.
struct LidarScan {
  static constexpr std::string_view kType = "stope/LidarScan@1";
  std::vector<Point3f> points;            ///< metres, sensor frame
  std::vector<float> intensity;           ///< as the sensor gives it
  std::vector<std::uint16_t> ring;        ///< laser number, lowest elevation first
  std::vector<std::int32_t> time_offset;  ///< nanoseconds before the item's stamp, <= 0
  std::vector<std::uint8_t> label;  ///< a PointLabel, where the truth or a classifier gives one
  static constexpr void fields(auto& s, auto&& visit) {
    visit("points", s.points);
    visit("intensity", s.intensity);
    visit("ring", s.ring);
    visit("time_offset", s.time_offset);
    visit("label", s.label);
  }
};

}  // namespace stope
