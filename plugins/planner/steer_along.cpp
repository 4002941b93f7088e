#include "plugins/planner/steer_along.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {

std::optional<DriveCurve> steer_along(const RouteLine& line, const Pose2& start,
                                      const Vehicle& vehicle, double look_ahead,
                                      double start_curvature) {
  const double length = line.length();
  const double step = length / std::max(8.0, std::ceil(length));
  const double most = vehicle.max_curvature() * (1 - 1e-6);
  const double rate = std::min(vehicle.max_curvature_rate(), 2 * most / step) * step;
  DriveCurve curve{start, {}};
  Pose2 pose = start;
  double along = 0, driven = 0;
  double curvature = std::clamp(start_curvature, -most, most);
  while (along < length - step / 2) {
    if (driven > 2 * length + 100) return std::nullopt;
    const Vector2 here(pose.x, pose.y);
    along = line.nearest(here, along, std::min(length, along + 4 * step + look_ahead));
    Vector2 ahead = line.at(std::min(length, along + look_ahead));
    if (along + look_ahead > length) {
      // Beyond the end the line goes on straight, so that the aim stays ahead.
      const double yaw = line.heading(length - 2 * step, 2 * step);
      ahead += (along + look_ahead - length) * Vector2(std::cos(yaw), std::sin(yaw));
    }
    const Vector2 aim = ahead - here;
    const double angle = std::remainder(std::atan2(aim.y(), aim.x()) - pose.yaw, 2 * M_PI);
    const double wish =
        2 * std::sin(std::clamp(angle, -M_PI / 2, M_PI / 2)) / std::max(aim.norm(), look_ahead / 2);
    const double next =
        std::clamp(std::clamp(wish, -most, most), curvature - rate, curvature + rate);
    curve.pieces.push_back({step, curvature, next});
    pose = advance(pose, curve.pieces.back());
    curvature = next;
    driven += step;
    if (along >= length - step && driven > length / 2) {
      const double past = line.nearest({pose.x, pose.y}, along, length);
      if (past >= length - 1e-9) break;
    }
  }
  if (curve.pieces.size() < 4) return std::nullopt;
  return curve;
}

}  // namespace stope::planner
