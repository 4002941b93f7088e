#include "plugins/source/synthetic_pit/drive.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/source/synthetic_pit/curve.hpp"
#include "plugins/source/synthetic_pit/route.hpp"

namespace stope::source {
namespace {

constexpr double kSidewaysAcceleration = 1.3;  // m/s^2 a loaded truck takes in bends
constexpr double kAcceleration = 0.8;          // m/s^2 along the road
constexpr double kAxle = 3.0, kTrack = 1.6;    // metres from the truck's middle to its wheels
constexpr double kSensorForward = 2.5;         // metres, the LiDAR is over the cab
constexpr std::size_t kSway = 6;               // steps of the route that suspension averages over

std::vector<double> headings(const std::vector<Vector2>& line) {
  std::vector<double> yaw(line.size());
  double before = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector2 along =
        line[std::min(i + 2, line.size() - 1)] - line[i - std::min<std::size_t>(i, 2)];
    const double heading = std::atan2(along.y(), along.x());
    before = i == 0 ? heading : before + std::remainder(heading - before, 2 * M_PI);
    yaw[i] = before;
  }
  return yaw;
}

std::vector<double> speeds(const std::vector<double>& yaw, double fastest) {
  const std::size_t n = yaw.size();
  std::vector<double> speed(n, fastest);
  for (std::size_t i = 4; i + 4 < n; ++i) {
    const double curvature = std::abs(yaw[i + 4] - yaw[i - 4]) / (8 * kRouteStep);
    if (curvature > 1e-6)
      speed[i] = std::min(fastest, std::sqrt(kSidewaysAcceleration / curvature));
  }
  const double gain = 2 * kAcceleration * kRouteStep;
  for (std::size_t i = 1; i < n; ++i)
    speed[i] = std::min(speed[i], std::sqrt(speed[i - 1] * speed[i - 1] + gain));
  for (std::size_t i = n - 1; i-- > 0;)
    speed[i] = std::min(speed[i], std::sqrt(speed[i + 1] * speed[i + 1] + gain));
  return speed;
}

}  // namespace

Drive::Drive(const std::vector<Vector2>& line, const Terrain& terrain,
             const PitParameters& parameters, const Checkpoint& checkpoint)
    : yaw_(headings(line)), sensor_height_(parameters.sensor_height) {
  const std::vector<double> speed = speeds(yaw_, parameters.truck_speed);
  time_.assign(line.size(), 0.0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    checkpoint();
    x_.push_back(line[i].x());
    y_.push_back(line[i].y());
    const Vector2 ahead(std::cos(yaw_[i]), std::sin(yaw_[i])), left(-ahead.y(), ahead.x());
    const auto wheel = [&](const Vector2& offset) {
      const Vector2 place = line[i] + offset;
      return terrain.height_at(place.x(), place.y());
    };
    const double front = wheel(kAxle * ahead), back = wheel(-kAxle * ahead);
    const double high_left = wheel(kTrack * left), high_right = wheel(-kTrack * left);
    z_.push_back(0.25 * (front + back + high_left + high_right));
    pitch_.push_back(-std::atan2(front - back, 2 * kAxle));  // nose up turns about -y
    roll_.push_back(std::atan2(high_left - high_right, 2 * kTrack));
    if (i > 0)
      time_[i] = time_[i - 1] + 2 * (line[i] - line[i - 1]).norm() / (speed[i] + speed[i - 1]);
  }
  z_ = moving_average(z_, kSway);
  pitch_ = moving_average(pitch_, kSway);
  roll_ = moving_average(roll_, kSway);
}

double Drive::distance_at(double time) const {
  const auto after = std::lower_bound(time_.begin(), time_.end(), time);
  return kRouteStep * static_cast<double>(after - time_.begin());
}

Pose Drive::lidar_at(double time) const {
  const auto after = std::upper_bound(time_.begin() + 1, time_.end() - 1, time);
  const auto i = static_cast<std::size_t>(after - time_.begin());
  const double t = std::clamp((time - time_[i - 1]) / (time_[i] - time_[i - 1]), 0.0, 1.0);
  const auto at = [&](const std::vector<double>& values) {
    return values[i - 1] + t * (values[i] - values[i - 1]);
  };
  Pose truck;
  truck.translation = {at(x_), at(y_), at(z_)};
  truck.rotation = Eigen::AngleAxisd(at(yaw_), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(at(pitch_), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(at(roll_), Eigen::Vector3d::UnitX());
  Pose mount;
  mount.translation = {kSensorForward, 0, sensor_height_};
  return truck * mount;
}

Sweeps plan_sweeps(const Drive& drive, const PitParameters& parameters) {
  Sweeps sweeps;
  sweeps.stride = parameters.stride;
  sweeps.rate = parameters.scan_rate;
  double last = drive.duration();
  if (parameters.route_length > 0) {
    double low = 0, high = last;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (drive.distance_at(middle) < parameters.route_length ? low : high) = middle;
    }
    last = high;
  }
  const auto turns = static_cast<std::int64_t>(std::floor(last * sweeps.rate));
  if (turns > 0) sweeps.count = static_cast<std::size_t>((turns - 1) / sweeps.stride + 1);
  if (parameters.scans > 0)
    sweeps.count = std::min(sweeps.count, static_cast<std::size_t>(parameters.scans));
  return sweeps;
}

Trajectory true_trajectory(const Drive& drive, const Sweeps& sweeps, const Checkpoint& checkpoint) {
  constexpr Stamp kFine = 10'000'000, kCoarse = 50'000'000;
  Trajectory trajectory;
  const auto add = [&](Stamp stamp) {
    trajectory.poses.push_back({stamp, drive.lidar_at(seconds_from_stamp(stamp))});
  };
  for (std::size_t k = 0; k < sweeps.count; ++k) {
    checkpoint();
    const Stamp begin = sweeps.begin(k), end = sweeps.end(k);
    if (trajectory.poses.empty() || trajectory.poses.back().stamp < begin) add(begin);
    for (Stamp stamp = begin + kFine; stamp < end; stamp += kFine) add(stamp);
    add(end);
    if (k + 1 == sweeps.count) break;
    for (Stamp stamp = end + kCoarse; stamp < sweeps.begin(k + 1); stamp += kCoarse) add(stamp);
  }
  return trajectory;
}

}  // namespace stope::source
