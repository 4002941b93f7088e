#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "plugins/source/recording/kitti_scan.hpp"
#include "plugins/source/recording/pose_rows.hpp"
#include "plugins/source/recording/scan_files.hpp"
#include "stope/stope.hpp"

namespace stope::source {
namespace {

class Kitti final : public Stage {
 public:
  struct Params {
    std::filesystem::path scans;
    std::optional<std::filesystem::path> poses, times;
    double rate = 10.0;
    std::int64_t first = 0, last = -1, limit = 0;
  } params;
  Out<LidarScan> scans;
  Out<StampedPose> poses;
  OutValue<Trajectory> trajectory;

  static void describe(About<Kitti>& about);
  void run(Context& context) override;

 private:
  std::vector<Stamp> stamps(std::size_t count) const;
};

void Kitti::describe(About<Kitti>& about) {
  about
      .summary("A recording in KITTI's form: a folder of scans, and poses in rows of 3x4 matrices.")
      .from(
          "Geiger, Lenz and Urtasun, Are we ready for autonomous driving? The KITTI vision "
          "benchmark suite, CVPR 2012")
      .notes(
          "Points without a finite place are left out and counted in the log. Poses must be those "
          "of the LiDAR (T_map_lidar): KITTI's own odometry poses are the camera's.")
      .output("scans", &Kitti::scans, "Sweeps with intensity; no ring, no time of the points.")
      .output("poses", &Kitti::poses, "The pose of each scan; none without a file of poses.")
      .output("trajectory", &Kitti::trajectory, "All poses; asks for a file of poses.")
      .param("scans", &Params::scans, required() + existing(PathKind::kFolder),
             "Folder of NNNNNN.bin, float32 x y z intensity.")
      .param("poses", &Params::poses, existing(PathKind::kFile),
             "Text file of poses, a row of 12 numbers for each scan in the folder.")
      .param("times", &Params::times, existing(PathKind::kFile),
             "Text file of times in seconds, one for each scan; instead of rate.")
      .param("rate", &Params::rate, "Hz", more_than(0), "Scans a second, where times is not given.")
      .param("first", &Params::first, at_least(0), "The first scan to take, counted from 0.")
      .param("last", &Params::last, at_least(-1), "The last scan to take; -1 is the folder's last.")
      .param("limit", &Params::limit, at_least(0), "Take at most this many; 0 takes all.");
}

std::vector<Stamp> Kitti::stamps(std::size_t count) const {
  if (params.times) {
    std::vector<Stamp> times = read_times(*params.times);
    if (times.size() != count)
      throw Error(fmt::format("{} has {} times, but {} has {} scans: there must be one for each",
                              params.times->string(), times.size(), params.scans.string(), count));
    return times;
  }
  std::vector<Stamp> times(count);
  for (std::size_t i = 0; i < count; ++i)
    times[i] = stamp_from_seconds(static_cast<double>(i) / params.rate);
  return times;
}

void Kitti::run(Context& context) {
  const auto files = list_scan_files(params.scans, ".bin");
  const std::vector<Stamp> times = stamps(files.size());
  const ItemRange range = choose_items(files.size(), params.first, params.last, params.limit);
  Trajectory path;
  if (params.poses) {
    const std::vector<Pose> rows = read_kitti_poses(*params.poses);
    if (rows.size() != files.size())
      throw Error(fmt::format("{} has {} poses, but {} has {} scans: there must be one for each",
                              params.poses->string(), rows.size(), params.scans.string(),
                              files.size()));
    for (std::size_t i = range.first; i < range.end; ++i) path.poses.push_back({times[i], rows[i]});
  } else if (trajectory.wanted() || poses.wanted()) {
    throw Error(
        "the trajectory or the poses of this recording are used, but it has none: give the "
        "parameter poses, a file with a row of 12 numbers for each scan");
  }
  trajectory.set(path);
  // Sizes are looked at now, so that a truncated file is known before hours of work, not after.
  std::vector<std::size_t> sizes;
  for (std::size_t i = range.first; i < range.end; ++i)
    sizes.push_back(count_kitti_points(files[i]));

  for (std::size_t i = range.first; i < range.end; ++i) {
    context.stop_if_cancelled();
    const std::size_t place = i - range.first;
    if (params.poses) poses.put(times[i], path.poses[place]);
    const auto load = [file = files[i], &context] {
      ReadScan read = read_kitti_scan(file);
      if (read.dropped > 0)
        context.warn(fmt::format("left out {} of the {} points of {}: they are not finite",
                                 read.dropped, read.dropped + read.scan.points.size(),
                                 file.string()));
      return std::move(read.scan);
    };
    scans.put_lazy(times[i], load, sizes[place] * 16);
    context.progress(static_cast<double>(place + 1) / static_cast<double>(sizes.size()));
  }
}

}  // namespace

STOPE_STAGE(Kitti, "source/kitti");

}  // namespace stope::source
