#pragma once

#include <cstdint>
#include <vector>

#include "plugins/source/synthetic_pit/height_pyramid.hpp"
#include "plugins/source/synthetic_pit/machines.hpp"
#include "plugins/source/synthetic_pit/pit_parameters.hpp"
#include "stope/payloads/lidar_scan.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::source {

/// A spinning LiDAR: a column of lasers fires at once, the columns go round counter-clockwise from
/// straight back. Elevations are those of a VLP-16, an HDL-32E or an HDL-64E by number of rings.
class SpinningLidar {
 public:
  explicit SpinningLidar(const PitParameters& parameters);

  /// The sweep that begins and ends at these stamps, seen from the moving sensor. A function of its
  /// arguments only. Points that meet nothing, or are lost, are left out.
  LidarScan sweep(const Terrain& terrain, const HeightPyramid& pyramid,
                  const std::vector<Box>& boxes, const Trajectory& trajectory, Stamp begin,
                  Stamp end, std::uint64_t seed) const;
  /// Angles of the lasers over the sensor's horizon, lowest first, radians.
  const std::vector<double>& elevations() const { return elevations_; }

 private:
  std::vector<double> elevations_;
  std::vector<double> cosine_, sine_;  ///< of the elevations
  std::int64_t azimuths_;
  double noise_, dropout_, max_range_;
};

}  // namespace stope::source
