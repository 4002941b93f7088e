#pragma once

#include <vector>

#include "plugins/map/voxel_filter.hpp"
#include "stope/payloads/lidar_scan.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::map {

/// Which points of a scan to keep, and where the cloud they go to has its origin.
struct ScanRules {
  double min_range = 0, max_range = 0;  ///< metres from the sensor
  Vector3 origin = Vector3::Zero();     ///< metres, map frame
  bool compensate = true;               ///< place each point by its own time
};

/// What became of a scan's points.
struct ScanCount {
  std::size_t points = 0, not_finite = 0, out_of_range = 0, kept = 0;
};

/// Places a scan's points in the map: each by the sensor's pose at its own time, if the scan has
/// times. `stamp` is the scan's. Fills `placed` with one entry a point, in order, in parallel.
/// Throws Error if an array of the scan has the wrong length.
ScanCount place_scan(const LidarScan& scan, Stamp stamp, const Trajectory& trajectory,
                     const ScanRules& rules, std::vector<VoxelPoint>& placed);

}  // namespace stope::map
