#include "plugins/source/recording/pose_rows.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <cmath>

#include "plugins/source/recording/number_rows.hpp"
#include "stope/error.hpp"

namespace stope::source {
namespace {

constexpr double kRounding = 1e-3;    // how far a printed rotation may be from an exact one
constexpr double kLargestTime = 9e9;  // seconds: as nanoseconds it still fits 64 bits

Stamp stamp_of(const std::filesystem::path& file, const NumberRow& row) {
  if (std::abs(row.values[0]) > kLargestTime)
    throw Error(
        fmt::format("{}:{}: {} is no time in seconds; if the file counts nanoseconds, "
                    "divide them by 1e9",
                    file.string(), row.line, row.values[0]));
  return stamp_from_seconds(row.values[0]);
}

[[noreturn]] void fail_order(const std::filesystem::path& file, const NumberRow& row) {
  throw Error(fmt::format("{}:{}: the time {} s is not after the one before; times must increase",
                          file.string(), row.line, row.values[0]));
}

}  // namespace

std::vector<Pose> read_kitti_poses(const std::filesystem::path& file) {
  std::vector<Pose> poses;
  for (const NumberRow& row :
       read_number_rows(file, 12, "a pose, the 12 numbers of a 3x4 matrix")) {
    const auto& v = row.values;
    Eigen::Matrix3d rotation;
    rotation << v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10];
    const double error = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
    if (!(error < kRounding) || rotation.determinant() < 0)
      throw Error(fmt::format(
          "{}:{}: the left 3x3 part of the pose is not a rotation (determinant {:.4g}, R R^T is "
          "off by {:.2g}); expected rows of T_map_lidar",
          file.string(), row.line, rotation.determinant(), error));
    Pose pose;
    pose.translation = {v[3], v[7], v[11]};
    const Eigen::JacobiSVD<Eigen::Matrix3d> parts(rotation,
                                                  Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d nearest = parts.matrixU() * parts.matrixV().transpose();
    pose.rotation = Quaternion(nearest).normalized();
    poses.push_back(pose);
  }
  return poses;
}

Trajectory read_tum_trajectory(const std::filesystem::path& file) {
  Trajectory trajectory;
  for (const NumberRow& row :
       read_number_rows(file, 8, "a pose, the 8 numbers t x y z qx qy qz qw")) {
    const auto& v = row.values;
    StampedPose pose;
    pose.stamp = stamp_of(file, row);
    if (!trajectory.poses.empty() && pose.stamp <= trajectory.poses.back().stamp)
      fail_order(file, row);
    const Quaternion rotation(v[7], v[4], v[5], v[6]);
    if (!(std::abs(rotation.norm() - 1) < 1e-2))
      throw Error(
          fmt::format("{}:{}: the quaternion's length is {:.4g}; expected 1, in the order "
                      "qx qy qz qw",
                      file.string(), row.line, rotation.norm()));
    pose.T_map_lidar.translation = {v[1], v[2], v[3]};
    pose.T_map_lidar.rotation = rotation.normalized();
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

std::vector<Stamp> read_times(const std::filesystem::path& file) {
  std::vector<Stamp> times;
  for (const NumberRow& row : read_number_rows(file, 1, "one time in seconds")) {
    times.push_back(stamp_of(file, row));
    if (times.size() > 1 && times.back() <= times[times.size() - 2]) fail_order(file, row);
  }
  return times;
}

}  // namespace stope::source
