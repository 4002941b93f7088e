#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {
namespace {

/// Seconds with all nine decimals of the stamp, without rounding through floating point.
std::string seconds_text(Stamp stamp) {
  constexpr Stamp kSecond = 1'000'000'000;
  const char* sign = stamp < 0 ? "-" : "";
  return fmt::format("{}{}.{:09}", sign, std::abs(stamp / kSecond), std::abs(stamp % kSecond));
}

}  // namespace

class Tum final : public Map<Artefact(Trajectory)> {
 public:
  struct Params {
  } params;

  static void describe(About<Tum>& about) {
    about.summary("Writes a trajectory as text, a pose a line: t x y z qx qy qz qw.")
        .from("TUM RGB-D benchmark")
        .notes("Seconds, metres and a unit quaternion: the sensor's pose in the map frame.")
        .ports("trajectory", "artefact")
        .writes({"tum"});
  }

  Artefact apply(const Trajectory& trajectory, Context&) const {
    std::string text;
    for (const StampedPose& pose : trajectory.poses) {
      const Vector3& at = pose.T_map_lidar.translation;
      const Quaternion& turn = pose.T_map_lidar.rotation;
      text += fmt::format("{} {} {} {} {} {} {} {}\n", seconds_text(pose.stamp), at.x(), at.y(),
                          at.z(), turn.x(), turn.y(), turn.z(), turn.w());
    }
    return {{{"tum", bytes_of(text)}}};
  }
};

STOPE_STAGE(Tum, "export/tum")

}  // namespace stope::exports
