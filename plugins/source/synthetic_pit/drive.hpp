#pragma once

#include <span>
#include <vector>

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/pit_parameters.hpp"
#include "plugins/source/synthetic_pit/terrain.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::source {

/// A truck on its way along a line: where its LiDAR is at any time.
class Drive {
 public:
  Drive(const std::vector<Vector2>& line, const Terrain& terrain, const PitParameters& parameters,
        const Checkpoint& checkpoint = never_stop);
  /// Seconds from start to end.
  double duration() const { return time_.back(); }
  /// Metres driven after a time.
  double distance_at(double time) const;
  /// T_map_lidar at a time within the drive.
  Pose lidar_at(double time) const;

 private:
  std::vector<double> time_;                            ///< by step of the line
  std::vector<double> x_, y_, z_, yaw_, pitch_, roll_;  ///< of the truck on the road
  double sensor_height_;
};

/// The sweeps a drive is recorded in.
struct Sweeps {
  std::size_t count = 0;
  std::int64_t stride = 1;
  double rate = 10;
  /// When the last and (nominally) the first firing of sweep k happen.
  Stamp end(std::size_t k) const { return turn_end(static_cast<std::int64_t>(k) * stride + 1); }
  Stamp begin(std::size_t k) const { return turn_end(static_cast<std::int64_t>(k) * stride); }

 private:
  Stamp turn_end(std::int64_t turn) const {
    return stamp_from_seconds(static_cast<double>(turn) / rate);
  }
};
Sweeps plan_sweeps(const Drive& drive, const PitParameters& parameters);

/// The true trajectory: every 10 ms during a sweep and at its ends, every 50 ms between sweeps. It
/// *is* the motion: scans are made of it by pose_at(), so undoing the motion with it is exact.
Trajectory true_trajectory(const Drive& drive, const Sweeps& sweeps,
                           const Checkpoint& checkpoint = never_stop);

}  // namespace stope::source
