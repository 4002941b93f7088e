#include "stope/payloads/trajectory.hpp"

#include <algorithm>

#include "stope/error.hpp"

namespace stope {

Pose pose_at(const Trajectory& trajectory, Stamp stamp) {
  const auto& poses = trajectory.poses;
  if (poses.empty()) throw Error("the trajectory has no poses");
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp,
                       [](const StampedPose& pose, Stamp time) { return pose.stamp < time; });
  if (after == poses.begin()) return poses.front().T_map_lidar;
  if (after == poses.end()) return poses.back().T_map_lidar;
  const auto before = after - 1;
  const double fraction = static_cast<double>(stamp - before->stamp) /
                          static_cast<double>(after->stamp - before->stamp);
  return interpolate(before->T_map_lidar, after->T_map_lidar, fraction);
}

}  // namespace stope
