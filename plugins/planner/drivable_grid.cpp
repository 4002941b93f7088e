#include "plugins/planner/drivable_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "plugins/planner/cell_line.hpp"

namespace stope::planner {
namespace {

/// The cell of a frame that holds a point, also beyond the frame's edges.
Cell cell_of(const GridFrame& frame, const Vector2& point) {
  constexpr double kFar = 5e8;
  const Vector2 at = frame.to_grid(point.x(), point.y());
  return {static_cast<std::int32_t>(std::floor(std::clamp(at.x(), -kFar, kFar))),
          static_cast<std::int32_t>(std::floor(std::clamp(at.y(), -kFar, kFar)))};
}

/// Visits the cells of the frame in square rings round `centre`, nearest ring first, while
/// `wanted(ring)` holds; rings that lie wholly outside cost nothing.
template <class Wanted, class Visit>
void visit_rings(const GridFrame& frame, Cell centre, std::int32_t most, const Wanted& wanted,
                 const Visit& visit) {
  const auto outermost = std::max({std::abs(static_cast<std::int64_t>(centre.column)),
                                   std::abs(static_cast<std::int64_t>(centre.row)),
                                   std::abs(static_cast<std::int64_t>(frame.width) - centre.column),
                                   std::abs(static_cast<std::int64_t>(frame.height) - centre.row)});
  const auto last = static_cast<std::int32_t>(std::min<std::int64_t>(most, outermost));
  for (std::int32_t ring = 0; ring <= last && wanted(ring); ++ring) {
    const std::int32_t bottom = centre.row - ring, top = centre.row + ring;
    const std::int32_t left = centre.column - ring, right = centre.column + ring;
    for (std::int32_t row = std::max(0, bottom); row <= std::min(frame.height - 1, top); ++row) {
      if (row == bottom || row == top) {
        for (std::int32_t column = std::max(0, left); column <= std::min(frame.width - 1, right);
             ++column)
          visit(Cell{column, row});
      } else {
        if (left >= 0 && left < frame.width) visit(Cell{left, row});
        if (right >= 0 && right < frame.width) visit(Cell{right, row});
      }
    }
  }
}

}  // namespace

Ground DrivableGrid::ground_at(const Vector2& point) const {
  const auto cell = grid_.frame.cell_at(point.x(), point.y());
  if (!cell) return Ground::kOffMap;
  const std::uint8_t value = grid_.cells[grid_.frame.place(*cell)];
  if (value == OccupancyGrid::kUnknown) return Ground::kUnknown;
  return value < 127 ? Ground::kFree : Ground::kObstacle;
}

bool DrivableGrid::line_free(const Vector2& a, const Vector2& b) const {
  if (ground_at(a) != Ground::kFree || ground_at(b) != Ground::kFree) return false;
  return walk_line(grid_.frame.to_grid(a.x(), a.y()), grid_.frame.to_grid(b.x(), b.y()),
                   [this](Cell cell) { return free(cell); });
}

double DrivableGrid::clearance(const Vector2& point, double most) const {
  return distance_to_nearest(point, most, [this](Cell cell) { return !free(cell); });
}

double DrivableGrid::distance_to_obstacle(const Vector2& point, double most) const {
  return distance_to_nearest(point, most, [this](Cell cell) {
    const std::uint8_t value = grid_.cells[grid_.frame.place(cell)];
    return value >= 127 && value != OccupancyGrid::kUnknown;
  });
}

template <class Wanted>
double DrivableGrid::distance_to_nearest(const Vector2& point, double most,
                                         const Wanted& wanted) const {
  const double resolution = grid_.frame.resolution;
  double best = most;
  visit_rings(
      grid_.frame, cell_of(grid_.frame, point), static_cast<std::int32_t>(most / resolution) + 1,
      [&](std::int32_t ring) { return (ring - 1) * resolution < best; },
      [&](Cell cell) {
        if (wanted(cell)) best = std::min(best, (grid_.frame.centre(cell) - point).norm());
      });
  return best;
}

Cell DrivableGrid::nearest_free(const Vector2& point, double most) const {
  const double resolution = grid_.frame.resolution;
  Cell found{-1, -1};
  double best = most;
  visit_rings(
      grid_.frame, cell_of(grid_.frame, point),
      static_cast<std::int32_t>(std::min(most / resolution, 1e8)) + 1,
      [&](std::int32_t ring) { return (ring - 1) * resolution <= best; },
      [&](Cell cell) {
        if (!free(cell)) return;
        const double distance = (grid_.frame.centre(cell) - point).norm();
        if (distance < best || (found.row < 0 && distance <= best)) best = distance, found = cell;
      });
  return found;
}

}  // namespace stope::planner
