#include <filesystem>
#include <optional>

#include "plugins/source/recording/kitti_scan.hpp"
#include "plugins/source/recording/recording_stage.hpp"

namespace stope::source {
namespace {

std::size_t scan_bytes(const std::filesystem::path& file) { return 16 * count_kitti_points(file); }

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
  void run(Context& context) override {
    const Recording recording =
        open_recording({params.scans, ".bin", params.poses, std::nullopt, params.times, params.rate,
                        params.first, params.last, params.limit});
    play(recording, {scans, poses, trajectory}, scan_bytes, read_kitti_scan, context);
  }
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
      .output("poses", &Kitti::poses, "The pose of each scan; asks for a file of poses.")
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

}  // namespace

STOPE_STAGE(Kitti, "source/kitti");

}  // namespace stope::source
