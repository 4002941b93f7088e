#include "plugins/planner/speed_profile.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {
namespace {

constexpr double kJump = 1e-3;  // 1/m: less is no turn of the wheels on the spot

struct Way {
  double length = 0;
  bool backwards = false;
};

Way way_between(const PathPoint& a, const PathPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double yaw = a.yaw + std::remainder(b.yaw - a.yaw, 2 * M_PI) / 2;
  return {std::hypot(dx, dy), dx * std::cos(yaw) + dy * std::sin(yaw) < 0};
}

}  // namespace

void plan_speeds(std::vector<PathPoint>& points, const Vehicle& vehicle,
                 const SpeedLimits& limits) {
  if (points.size() < 2) return;
  std::vector<Way> ways;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    ways.push_back(way_between(points[i], points[i + 1]));
  std::vector<double> speeds(points.size(), limits.top);
  speeds.front() = speeds.back() = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double here = points[i].curvature, next = points[i + 1].curvature;
    // A point's curvature is that of the way before it; what follows may bend more.
    const double bend = std::max(std::abs(here), std::abs(next));
    if (bend > 0) speeds[i] = std::min(speeds[i], std::sqrt(limits.lateral / bend));
    const bool jumps =
        vehicle.steering_distance > 0 &&
        std::abs(next - here) > 1.01 * vehicle.max_curvature_rate() * ways[i].length + kJump;
    if (jumps || (i > 0 && ways[i].backwards != ways[i - 1].backwards)) speeds[i] = 0;
  }
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    const double square = speeds[i - 1] * speeds[i - 1];
    speeds[i] = std::min(speeds[i], std::sqrt(square + 2 * limits.accelerate * ways[i - 1].length));
  }
  for (std::size_t i = ways.size(); i-- > 0;) {
    const double square = speeds[i + 1] * speeds[i + 1];
    speeds[i] = std::min(speeds[i], std::sqrt(square + 2 * limits.brake * ways[i].length));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool backwards = ways[i == 0 ? 0 : i - 1].backwards;
    points[i].speed = backwards && speeds[i] > 0 ? -speeds[i] : speeds[i];
  }
}

std::size_t standstills_of(const std::vector<PathPoint>& points) {
  std::size_t departures = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    departures += points[i - 1].speed == 0 && points[i].speed != 0 ? 1 : 0;
  return departures > 0 ? departures - 1 : 0;
}

}  // namespace stope::planner
