#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "plugins/map/motion_compensation.hpp"
#include "plugins/map/voxel_filter.hpp"
#include "stope/stope.hpp"

namespace stope::map {
namespace {

/// A round place near the first pose, so that single precision suffices for the points; zero where
/// the map's own frame is near enough.
Vector3 origin_for(const Trajectory& trajectory) {
  constexpr double kRound = 1000;  // metres
  Vector3 origin = trajectory.poses.front().T_map_lidar.translation;
  for (int axis = 0; axis < 3; ++axis) origin[axis] = kRound * std::round(origin[axis] / kRound);
  return origin;
}

/// What happened to all scans.
struct Tally {
  std::size_t scans = 0, empty = 0, untimely = 0;
  ScanCount points;

  void add(const ScanCount& scan) {
    points.points += scan.points;
    points.not_finite += scan.not_finite;
    points.out_of_range += scan.out_of_range;
    points.kept += scan.kept;
  }
  void warn(Context& context) const {
    if (empty > 0) context.warn(fmt::format("{} of {} scans have no points", empty, scans));
    if (points.not_finite > 0) {
      context.warn(fmt::format("{} of {} points are not finite and are left out", points.not_finite,
                               points.points));
    }
    if (untimely > 0) {
      context.warn(fmt::format("{} of {} scans lie outside the trajectory's time and are left out",
                               untimely, scans));
    }
  }
  [[noreturn]] void refuse() const {
    if (scans == 0) throw Error("there was no scan, so there is no map");
    throw Error(fmt::format(
        "no point of the {} scans can be used: {} scans are empty, {} lie outside the trajectory's "
        "time, {} points are not finite, {} are nearer than min_range or farther than max_range",
        scans, empty, untimely, points.not_finite, points.out_of_range));
  }
};

}  // namespace

class PointCloud final : public Stage {
 public:
  struct Params {
    double voxel = 0.2;
    double min_range = 1.5;
    double max_range = 100;
    double time_tolerance = 0.2;
    bool compensate = true;
  } params;
  In<LidarScan> scans;
  InValue<Trajectory> trajectory;
  OutValue<stope::PointCloud> cloud;

  static void describe(About<PointCloud>& about) {
    about.summary("Joins all scans into one cloud in the map frame, one point a voxel.")
        .notes(
            "Each point is placed by the sensor's pose at its own time, where the scans carry "
            "times. A voxel's point is the mean of those in it; its label the most frequent. "
            "Waits for the whole trajectory before it reads the first scan.")
        .input("scans", &PointCloud::scans, "Sweeps in the sensor's frame.")
        .input("trajectory", &PointCloud::trajectory, "Where the sensor was.")
        .output("cloud", &PointCloud::cloud, "The map.")
        .param("voxel", &Params::voxel, "m", more_than(0.0), "Edge of a voxel.")
        .param("min_range", &Params::min_range, "m", at_least(0.0),
               "Nearer points (the vehicle itself) are left out.")
        .param("max_range", &Params::max_range, "m", more_than(0.0), "Farther points are left out.")
        .param("time_tolerance", &Params::time_tolerance, "s", at_least(0.0),
               "How far before or after the trajectory a scan may lie.")
        .param("compensate", &Params::compensate,
               "Whether points are placed by their own times, or all by the scan's.");
  }

  void run(Context& context) override {
    const Trajectory& track = trajectory.get();
    if (track.poses.empty()) throw Error("the trajectory has no poses, so no scan can be placed");
    const ScanRules rules{params.min_range, params.max_range, origin_for(track), params.compensate};
    const Stamp tolerance = stamp_from_seconds(params.time_tolerance);
    VoxelFilter filter(params.voxel);
    Tally tally;
    bool with_intensity = true, with_label = true;
    std::vector<VoxelPoint> placed;
    while (auto scan = scans.next()) {
      context.stop_if_cancelled();
      ++tally.scans;
      const bool timely = scan.stamp() >= track.poses.front().stamp - tolerance &&
                          scan.stamp() <= track.poses.back().stamp + tolerance;
      if (scan->points.empty()) {
        ++tally.empty;
      } else if (!timely) {
        ++tally.untimely;
      } else {
        ScanCount counts = place_scan(*scan, scan.stamp(), track, rules, placed);
        const std::size_t outside = filter.add(placed);
        counts.kept -= outside, counts.out_of_range += outside;
        tally.add(counts);
        with_intensity = with_intensity && !scan->intensity.empty();
        with_label = with_label && !scan->label.empty();
      }
    }
    tally.warn(context);
    if (tally.points.kept == 0) tally.refuse();
    stope::PointCloud result = filter.finish(rules.origin, with_intensity, with_label);
    context.info(fmt::format("{} points of {} scans became {} voxels", tally.points.kept,
                             tally.scans, result.points.size()));
    cloud.set(std::move(result), track.poses.back().stamp);
  }
};

STOPE_STAGE(PointCloud, "map/point_cloud")

}  // namespace stope::map
