#pragma once

#include <filesystem>
#include <vector>

#include "stope/geometry.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::source {

/// Reads poses in KITTI's form, one a line: the 12 numbers of the 3x4 matrix T_map_lidar, row by
/// row. Rotations may be off by rounding and are made exact. Throws Error that names file and line
/// if a row is not twelve finite numbers or its left part is not a rotation.
std::vector<Pose> read_kitti_poses(const std::filesystem::path& file);

/// Reads a trajectory in TUM's form, one pose a line: `t x y z qx qy qz qw`, seconds and metres.
/// Throws Error that names file and line if a row is not eight finite numbers, times do not
/// increase, or a quaternion is not of unit length.
Trajectory read_tum_trajectory(const std::filesystem::path& file);

/// Reads one time in seconds a line. Throws Error that names file and line if a row is not one
/// finite number or times do not increase.
std::vector<Stamp> read_times(const std::filesystem::path& file);

}  // namespace stope::source
