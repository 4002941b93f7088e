#pragma once

#include <utility>

#include "plugins/source/recording/recording.hpp"
#include "stope/stope.hpp"

namespace stope::source {

/// The outputs that every recording has.
struct RecordingOutputs {
  Out<LidarScan>& scans;
  Out<StampedPose>& poses;
  OutValue<Trajectory>& trajectory;
};

/// Writes a recording to the outputs, scans lazily. `measure` gives the bytes a scan file will
/// about take in memory, and refuses files that cannot be scans: it is asked for all of them first,
/// so that a truncated file is known before hours of work, not after. Throws Error if a motion is
/// wanted that the recording does not have.
inline void play(const Recording& recording, const RecordingOutputs& outputs,
                 std::size_t (*measure)(const std::filesystem::path&),
                 ReadScan (*read)(const std::filesystem::path&), Context& context) {
  const bool moved = !recording.trajectory.poses.empty();
  if (!moved && (outputs.trajectory.wanted() || outputs.poses.wanted()))
    throw Error(
        "the trajectory or the poses of this recording are used, but it has none: give the "
        "parameter poses, a file with a row of 12 numbers for each scan");
  outputs.trajectory.set(recording.trajectory);
  std::vector<std::size_t> bytes;
  for (const auto& file : recording.files) bytes.push_back(measure(file));
  for (std::size_t i = 0; i < recording.files.size(); ++i) {
    context.stop_if_cancelled();
    const Stamp stamp = recording.stamps[i];
    if (moved && outputs.poses.wanted())
      outputs.poses.put(stamp, {stamp, pose_at(recording.trajectory, stamp)});
    outputs.scans.put_lazy(
        stamp,
        [file = recording.files[i], read, &context] { return load_scan(file, read, context); },
        bytes[i]);
    context.progress(static_cast<double>(i + 1) / static_cast<double>(recording.files.size()));
  }
}

}  // namespace stope::source
