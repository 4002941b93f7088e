#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plugins/planner/cell_box.hpp"
#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/road_ground.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::planner {

/// Where a way that leaves the roads' middles may lead: cells of a box that are free, at least
/// `min_clearance` from those that are not, or run through by the route by road, which is driven
/// however narrow it is. Each cell is asked once and remembered. Keeps references.
class ShortcutGround {
 public:
  ShortcutGround(const DrivableGrid& grid, const RoadGround& roads, const CellBox& box,
                 const std::vector<RoadVertex>& route, double min_clearance);

  const GridFrame& frame() const { return grid_.frame(); }
  const RoadGround& roads() const { return roads_; }
  const CellBox& box() const { return box_; }

  bool drivable(Cell cell) {
    if (!box_.contains(cell)) return false;
    Known& known = known_[box_.place(cell)];
    if (known == Known::kNotAsked) known = has_room(cell) ? Known::kYes : Known::kNo;
    return known == Known::kYes;
  }

  /// Metres, as dear as the ground is, of a straight line that may be driven; none if it may not.
  std::optional<double> cost_of_sight(const Vector2& a, const Vector2& b);

 private:
  enum class Known : std::uint8_t { kNotAsked, kYes, kNo };
  bool has_room(Cell cell) const;

  const DrivableGrid& grid_;
  const RoadGround& roads_;
  const CellBox box_;
  const double min_clearance_;
  std::vector<Known> known_;  // of each cell of the box
};

}  // namespace stope::planner
