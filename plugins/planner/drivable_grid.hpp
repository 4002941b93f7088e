#pragma once

#include <string>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::planner {

enum class Ground : int { kFree, kObstacle, kUnknown, kOffMap };

/// An occupancy grid as a driver sees it: a cell below half is free, the rest is not. Keeps a
/// reference to the grid.
class DrivableGrid {
 public:
  explicit DrivableGrid(const OccupancyGrid& grid) : grid_(grid) {}

  const GridFrame& frame() const { return grid_.frame; }
  bool free(Cell cell) const {
    return grid_.frame.contains(cell) && grid_.cells[grid_.frame.place(cell)] < 127;
  }
  Ground ground_at(const Vector2& point) const;
  /// Whether the straight line between two points touches free cells only; where it runs through a
  /// corner of cells, all that meet there count.
  bool line_free(const Vector2& a, const Vector2& b) const;
  /// Metres from a point to the centre of the nearest cell of the map that is not free, at most
  /// `most`.
  double clearance(const Vector2& point, double most) const;
  /// The same to the nearest cell that is known to be occupied.
  double distance_to_obstacle(const Vector2& point, double most) const;
  /// The free cell whose centre is nearest to a point, no farther than `most` metres; equals by
  /// row, then column. Outside the map if there is none.
  Cell nearest_free(const Vector2& point, double most) const;

 private:
  template <class Wanted>
  double distance_to_nearest(const Vector2& point, double most, const Wanted& wanted) const;

  const OccupancyGrid& grid_;
};

}  // namespace stope::planner
