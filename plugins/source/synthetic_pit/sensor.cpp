#include "plugins/source/synthetic_pit/sensor.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "stope/payloads/point_label.hpp"
#include "stope/random.hpp"

namespace stope::source {
namespace {

constexpr double kMinRange = 1.0;
// How bright each label is: unknown, ground, wall, berm, object.
constexpr std::array<double, 5> kReflectivity{0.2, 0.28, 0.42, 0.36, 0.75};

struct Echo {
  double range;
  PointLabel label;
};

class Scene {
 public:
  Scene(const Terrain& terrain, const HeightPyramid& pyramid, const std::vector<Box>& boxes,
        const Vector3& viewpoint, double max_range)
      : terrain_(terrain), pyramid_(pyramid), max_range_(max_range) {
    for (const Box& box : boxes) {
      if ((box.centre - viewpoint).norm() < max_range + 20) boxes_.push_back(box);
    }
  }

  Echo look(const Vector3& from, const Vector3& along) const {
    double nearest = max_range_;
    bool object = false;
    for (const Box& box : boxes_) {
      // A cheap miss first: how far the ray passes the box's middle.
      const Vector3 offset = box.centre - from;
      const double ahead = offset.dot(along);
      if (offset.squaredNorm() - ahead * ahead > box.half.squaredNorm()) continue;
      const double range = box.cast(from, along);
      if (range < nearest) nearest = range, object = true;
    }
    const auto ground = pyramid_.cast(from, along, nearest);
    if (ground) {
      const std::uint8_t label = terrain_.label[terrain_.frame.place(ground->cell)];
      return {ground->range, static_cast<PointLabel>(label)};
    }
    if (object) return {nearest, PointLabel::kObject};
    return {std::numeric_limits<double>::infinity(), PointLabel::kUnknown};
  }

 private:
  const Terrain& terrain_;
  const HeightPyramid& pyramid_;
  double max_range_;
  std::vector<Box> boxes_;
};

}  // namespace

SpinningLidar::SpinningLidar(const PitParameters& parameters)
    : azimuths_(parameters.azimuths),
      noise_(parameters.range_noise),
      dropout_(parameters.dropout),
      max_range_(parameters.max_range) {
  const auto rings = static_cast<int>(parameters.rings);
  const double lowest = rings == 16 ? -15.0 : rings == 32 ? -30.67 : -24.8;
  const double highest = rings == 16 ? 15.0 : rings == 32 ? 10.67 : 2.0;
  for (int i = 0; i < rings; ++i) {
    const double degrees = lowest + (highest - lowest) * i / (rings - 1);
    elevations_.push_back(degrees * std::numbers::pi / 180);
    cosine_.push_back(std::cos(elevations_.back()));
    sine_.push_back(std::sin(elevations_.back()));
  }
}

LidarScan SpinningLidar::sweep(const Terrain& terrain, const HeightPyramid& pyramid,
                               const std::vector<Box>& boxes, const Trajectory& trajectory,
                               Stamp begin, Stamp end, std::uint64_t seed) const {
  Random random(seed);
  LidarScan scan;
  const auto most = elevations_.size() * static_cast<std::size_t>(azimuths_);
  scan.points.reserve(most);
  scan.intensity.reserve(most);
  scan.ring.reserve(most);
  scan.time_offset.reserve(most);
  scan.label.reserve(most);
  const Scene scene(terrain, pyramid, boxes, pose_at(trajectory, end).translation, max_range_);
  for (std::int64_t column = 0; column < azimuths_; ++column) {
    // The last column fires at the end of the sweep.
    const Stamp stamp = end - (end - begin) * (azimuths_ - 1 - column) / azimuths_;
    const Pose T_map_lidar = pose_at(trajectory, stamp);
    const double azimuth = -std::numbers::pi + 2 * std::numbers::pi * static_cast<double>(column) /
                                                   static_cast<double>(azimuths_);
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    const Eigen::Matrix3d rotation = T_map_lidar.rotation.toRotationMatrix();
    for (std::size_t ring = 0; ring < elevations_.size(); ++ring) {
      const Vector3 beam(cosine_[ring] * c, cosine_[ring] * s, sine_[ring]);
      const Echo echo = scene.look(T_map_lidar.translation, rotation * beam);
      if (!(echo.range >= kMinRange && echo.range < max_range_)) continue;
      const double luck = random.uniform();
      const double range = echo.range + noise_ * random.normal();
      const double brightness = random.uniform();
      if (luck < dropout_) continue;
      scan.points.push_back({static_cast<float>(range * beam.x()),
                             static_cast<float>(range * beam.y()),
                             static_cast<float>(range * beam.z())});
      const double reflectivity = kReflectivity[static_cast<std::size_t>(echo.label)];
      scan.intensity.push_back(static_cast<float>(reflectivity * (0.8 + 0.4 * brightness)));
      scan.ring.push_back(static_cast<std::uint16_t>(ring));
      scan.time_offset.push_back(static_cast<std::int32_t>(stamp - end));
      scan.label.push_back(static_cast<std::uint8_t>(echo.label));
    }
  }
  return scan;
}

}  // namespace stope::source
