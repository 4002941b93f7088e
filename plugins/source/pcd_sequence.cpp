#include <filesystem>
#include <optional>

#include "plugins/source/recording/pcd_scan.hpp"
#include "plugins/source/recording/recording_stage.hpp"

namespace stope::source {
namespace {

class PcdSequence final : public Stage {
 public:
  struct Params {
    std::filesystem::path scans;
    std::optional<std::filesystem::path> poses, trajectory, times;
    double rate = 10.0;
    std::int64_t first = 0, last = -1, limit = 0;
  } params;
  Out<LidarScan> scans;
  Out<StampedPose> poses;
  OutValue<Trajectory> trajectory;

  static void describe(About<PcdSequence>& about);
  void run(Context& context) override {
    const Recording recording =
        open_recording({params.scans, ".pcd", params.poses, params.trajectory, params.times,
                        params.rate, params.first, params.last, params.limit});
    play(recording, {scans, poses, trajectory}, pcd_scan_bytes, read_pcd_scan, context);
  }
};

void PcdSequence::describe(About<PcdSequence>& about) {
  about
      .summary(
          "A folder of PCD files, one a scan, in the order of their names (scan2 before scan10).")
      .from("Rusu and Cousins, 3D is here: Point Cloud Library (PCL), ICRA 2011; PCD 0.7")
      .notes(
          "Reads ascii, binary and binary_compressed; x, y, z and, where there are any, intensity, "
          "ring, time and label of any numeric type. Whole-number times are nanoseconds, others "
          "seconds. Points without a finite place are left out and counted in the log. Coordinates "
          "are single precision.")
      .output("scans", &PcdSequence::scans, "Sweeps with the fields the files have.")
      .output("poses", &PcdSequence::poses, "The pose of each scan; asks for poses or trajectory.")
      .output("trajectory", &PcdSequence::trajectory, "The motion; asks for poses or trajectory.")
      .param("scans", &Params::scans, required() + existing(PathKind::kFolder),
             "Folder of *.pcd files.")
      .param("poses", &Params::poses, existing(PathKind::kFile),
             "Text file of poses, a row of 12 numbers of a 3x4 matrix for each scan.")
      .param("trajectory", &Params::trajectory, existing(PathKind::kFile),
             "Text file of rows t x y z qx qy qz qw (TUM); without times, one row for each scan.")
      .param("times", &Params::times, existing(PathKind::kFile),
             "Text file of times in seconds, one for each scan; instead of rate.")
      .param("rate", &Params::rate, "Hz", more_than(0),
             "Scans a second, where neither times nor trajectory is given.")
      .param("first", &Params::first, at_least(0), "The first scan to take, counted from 0.")
      .param("last", &Params::last, at_least(-1), "The last scan to take; -1 is the folder's last.")
      .param("limit", &Params::limit, at_least(0), "Take at most this many; 0 takes all.");
}

}  // namespace

STOPE_STAGE(PcdSequence, "source/pcd_sequence");

}  // namespace stope::source
