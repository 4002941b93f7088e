// Problem: a spinning LiDAR takes a tenth of a second for a sweep, in which a truck drives a metre.
// Idea: the few poses round the sweep are cut out of the trajectory once; each point is placed by
// the pose interpolated at its own time. Points of one firing share a time, and so their pose.
// Cost: O(1) a point.
#include "plugins/map/motion_compensation.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "stope/error.hpp"

namespace stope::map {
namespace {

void check_length(std::size_t length, std::size_t points, const char* what, Stamp stamp) {
  if (length == 0 || length == points) return;
  throw Error(
      fmt::format("the scan at {:.3f} s has {} points but {} {}: its source gave it wrongly",
                  seconds_from_stamp(stamp), points, length, what));
}

/// The poses that surround the times from `first` to `last`.
Trajectory poses_around(const Trajectory& trajectory, Stamp first, Stamp last) {
  const auto earlier = [](const StampedPose& pose, Stamp time) { return pose.stamp < time; };
  const auto& poses = trajectory.poses;
  auto begin = std::lower_bound(poses.begin(), poses.end(), first, earlier);
  auto end = std::lower_bound(begin, poses.end(), last, earlier);
  if (begin != poses.begin()) --begin;
  if (end != poses.end()) ++end;
  return {{begin, end}};
}

}  // namespace

ScanCount place_scan(const LidarScan& scan, Stamp stamp, const Trajectory& trajectory,
                     const ScanRules& rules, std::vector<VoxelPoint>& placed) {
  const std::size_t count = scan.points.size();
  check_length(scan.intensity.size(), count, "intensities", stamp);
  check_length(scan.time_offset.size(), count, "times", stamp);
  check_length(scan.label.size(), count, "labels", stamp);
  const bool timed = rules.compensate && !scan.time_offset.empty();
  const Stamp first =
      timed ? stamp + *std::min_element(scan.time_offset.begin(), scan.time_offset.end()) : stamp;
  const Trajectory around = poses_around(trajectory, first, stamp);
  const Pose at_end = pose_at(around, stamp);

  placed.assign(count, {});
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const auto& range) {
    Pose pose = at_end;
    std::int32_t pose_offset = 0;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Vector3 point(scan.points[i].x, scan.points[i].y, scan.points[i].z);
      const double distance = point.norm();
      if (!(distance >= rules.min_range && distance <= rules.max_range)) continue;
      if (timed && scan.time_offset[i] != pose_offset) {
        pose_offset = scan.time_offset[i];
        pose = pose_at(around, stamp + pose_offset);
      }
      const Vector3 at = pose * point - rules.origin;
      VoxelPoint& result = placed[i];
      result.position = {static_cast<float>(at.x()), static_cast<float>(at.y()),
                         static_cast<float>(at.z())};
      if (!scan.intensity.empty()) result.intensity = scan.intensity[i];
      if (!scan.label.empty()) result.label = scan.label[i];
      result.used = true;
    }
  });

  ScanCount counts;
  counts.points = count;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3f& point = scan.points[i];
    if (placed[i].used) {
      ++counts.kept;
    } else if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) {
      ++counts.out_of_range;
    } else {
      ++counts.not_finite;
    }
  }
  return counts;
}

}  // namespace stope::map
