// Problem: how near does the truck's outline come to obstacle squares?
// Idea: the distance of two convex polygons is 0 unless a line along an edge of one keeps them
// apart, and then the least of those between a corner of one and an edge of the other.
// Cost: the cells within `farthest` of the outline's bounding box.
#include "plugins/metric/outline_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/metric/path_motion.hpp"

namespace stope::metric {
namespace {

double distance_to_segment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 way = b - a;
  const double share = std::clamp(way.dot(point - a) / way.squaredNorm(), 0.0, 1.0);
  return (point - a - share * way).norm();
}

/// Whether a line along one of `a`'s edges keeps `a` and `b` apart.
bool separates(const Outline& a, const Outline& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector2 edge = a[(i + 1) % 4] - a[i];
    const double inside = cross(edge, a[(i + 2) % 4] - a[i]);
    const bool all_beyond = std::all_of(b.begin(), b.end(), [&](const Vector2& corner) {
      return cross(edge, corner - a[i]) * inside < 0;
    });
    if (all_beyond) return true;
  }
  return false;
}

/// Metres between two convex polygons; 0 if they touch.
double distance_between(const Outline& a, const Outline& b) {
  if (!separates(a, b) && !separates(b, a)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      least = std::min({least, distance_to_segment(a[i], b[j], b[(j + 1) % 4]),
                        distance_to_segment(b[i], a[j], a[(j + 1) % 4])});
    }
  }
  return least;
}

bool is_obstacle(const OccupancyGrid& grid, Cell cell) {
  // 255 is unknown, 127 / 254 an even chance.
  return !grid.frame.contains(cell) || grid.cells[grid.frame.place(cell)] >= 127;
}

}  // namespace

Outline outline_of(const TruckLimits& truck, const Pose2& pose) {
  const Vector2 ahead(std::cos(pose.yaw), std::sin(pose.yaw)), left(-ahead.y(), ahead.x());
  const Vector2 axle(pose.x, pose.y);
  const Vector2 nose = axle + (truck.length - truck.rear_overhang) * ahead;
  const Vector2 tail = axle - truck.rear_overhang * ahead;
  const Vector2 side = truck.width / 2 * left;
  return {Vector2(tail - side), Vector2(nose - side), Vector2(nose + side), Vector2(tail + side)};
}

double clearance_of(const Outline& outline, const OccupancyGrid& grid, double farthest) {
  const GridFrame& frame = grid.frame;
  double left = std::numeric_limits<double>::infinity(), bottom = left, right = -left, top = -left;
  for (const Vector2& corner : outline) {
    const Vector2 at = frame.to_grid(corner.x(), corner.y());
    left = std::min(left, at.x()), right = std::max(right, at.x());
    bottom = std::min(bottom, at.y()), top = std::max(top, at.y());
  }
  const double around = farthest / frame.resolution;
  const auto whole = [](double value) { return static_cast<std::int32_t>(std::floor(value)); };
  double least = farthest;
  for (std::int32_t row = whole(bottom - around); row <= whole(top + around); ++row) {
    for (std::int32_t column = whole(left - around); column <= whole(right + around); ++column) {
      if (!is_obstacle(grid, {column, row})) continue;
      const Outline square{frame.to_map(column, row), frame.to_map(column + 1, row),
                           frame.to_map(column + 1, row + 1), frame.to_map(column, row + 1)};
      least = std::min(least, distance_between(outline, square));
      if (least == 0) return 0;
    }
  }
  return least;
}

}  // namespace stope::metric
