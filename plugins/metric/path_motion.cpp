#include "plugins/metric/path_motion.hpp"

#include <cmath>
#include <numbers>

namespace stope::metric {
PathMotion motion_between(const PathPoint& a, const PathPoint& b) {
  PathMotion motion;
  motion.turn = std::remainder(b.yaw - a.yaw, 2 * std::numbers::pi);
  const double middle = a.yaw + motion.turn / 2;
  const Vector2 way(b.x - a.x, b.y - a.y), ahead(std::cos(middle), std::sin(middle));
  const double half = std::abs(motion.turn) / 2;
  motion.length = way.norm() * (half > 1e-9 ? half / std::sin(half) : 1);
  motion.backwards = way.dot(ahead) < 0;
  motion.slide = std::abs(cross(ahead, way));
  if (motion.length > 0)
    motion.curvature = motion.turn / (motion.backwards ? -motion.length : motion.length);
  return motion;
}

double circle_through(const Vector2& a, const Vector2& b, const Vector2& c) {
  const double sides = (b - a).norm() * (c - b).norm() * (c - a).norm();
  return sides > 0 ? 2 * std::abs(cross(b - a, c - a)) / sides : 0;
}

}  // namespace stope::metric
