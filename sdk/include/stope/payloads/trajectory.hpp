#pragma once

#include <string_view>
#include <vector>

#include "stope/payloads/stamped_pose.hpp"

namespace stope {

/// Where the sensor was over time.
struct Trajectory {
  static constexpr std::string_view kType = "stope/Trajectory@1";
  std::vector<StampedPose> poses;  ///< strictly increasing stamps
  static constexpr void fields(auto& s, auto&& visit) { visit("poses", s.poses); }
};

/// The pose at `stamp`, interpolated between its neighbours; beyond the ends the first or last
/// pose. Throws Error if the trajectory is empty.
STOPE_API Pose pose_at(const Trajectory& trajectory, Stamp stamp);

}  // namespace stope
