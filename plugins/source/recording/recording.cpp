#include "plugins/source/recording/recording.hpp"

#include <fmt/format.h>

#include <utility>

#include "plugins/source/recording/pose_rows.hpp"
#include "stope/error.hpp"

namespace stope::source {
namespace {

void check_count(std::size_t rows, const char* what, const std::filesystem::path& file,
                 std::size_t scans, const std::filesystem::path& folder) {
  if (rows != scans)
    throw Error(fmt::format("{} has {} {}, but {} has {} scans: there must be one for each",
                            file.string(), rows, what, folder.string(), scans));
}

template <class T>
void keep(std::vector<T>& values, const ItemRange& range) {
  values = std::vector<T>(values.begin() + static_cast<std::ptrdiff_t>(range.first),
                          values.begin() + static_cast<std::ptrdiff_t>(range.end));
}

}  // namespace

Recording open_recording(const RecordingFiles& files) {
  Recording recording;
  recording.files = list_scan_files(files.scans, files.extension);
  const std::size_t count = recording.files.size();
  if (files.poses && files.trajectory)
    throw Error("both poses and trajectory are given: give the one that holds the true motion");
  if (files.trajectory) recording.trajectory = read_tum_trajectory(*files.trajectory);
  if (files.times) {
    recording.stamps = read_times(*files.times);
    check_count(recording.stamps.size(), "times", *files.times, count, files.scans);
  } else if (files.trajectory) {
    check_count(recording.trajectory.poses.size(), "poses", *files.trajectory, count, files.scans);
    for (const StampedPose& pose : recording.trajectory.poses)
      recording.stamps.push_back(pose.stamp);
  } else {
    for (std::size_t i = 0; i < count; ++i)
      recording.stamps.push_back(stamp_from_seconds(static_cast<double>(i) / files.rate));
  }
  if (files.poses) {
    const std::vector<Pose> poses = read_kitti_poses(*files.poses);
    check_count(poses.size(), "poses", *files.poses, count, files.scans);
    for (std::size_t i = 0; i < count; ++i)
      recording.trajectory.poses.push_back({recording.stamps[i], poses[i]});
  }
  const ItemRange range = choose_items(count, files.first, files.last, files.limit);
  keep(recording.files, range);
  keep(recording.stamps, range);
  // A trajectory with times of its own stays whole: it may be denser than the scans.
  const bool by_scan = files.poses || (files.trajectory && !files.times);
  if (by_scan) keep(recording.trajectory.poses, range);
  return recording;
}

LidarScan load_scan(const std::filesystem::path& file,
                    ReadScan (*read)(const std::filesystem::path&), Context& context) {
  ReadScan result = read(file);
  if (result.dropped > 0)
    context.warn(fmt::format("left out {} of the {} points of {}: they are not finite",
                             result.dropped, result.dropped + result.scan.points.size(),
                             file.string()));
  return std::move(result.scan);
}

}  // namespace stope::source
