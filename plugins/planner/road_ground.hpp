#pragma once

#include <cstdint>
#include <vector>

#include "plugins/planner/cell_box.hpp"
#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// Which road each free cell belongs to, and what that forbids to ways that leave the roads'
/// middles. A cell belongs to the road nearest to it through free ground. Then
/// - ground of a closed road is not driven;
/// - on ground of a one-way road no way leads against it, though across;
/// - where a road is cut, no way on its ground passes the line across it at that place; where two
///   that meet are cut, none leads from one's ground to the other's within the clearance there;
/// - ground of a road that costs more costs as much more, up to kMostFactor.
/// What the route by road itself drives stays allowed. Where nothing is closed, one-way or changed
/// all ground is open, and nothing is looked at. Keeps references.
class RoadGround {
 public:
  static constexpr double kMostFactor = 100;

  /// All ground is open.
  RoadGround() = default;
  /// Of the cells in `box`; `driven` is the route by road. O(cells of the box).
  RoadGround(const DrivableGrid& grid, const RoadNetwork& network, const RoadChanges& changes,
             const CellBox& box, const std::vector<RoadVertex>& driven);

  bool open() const { return segments_.empty(); }
  /// Whether a way may come from one cell of the box into one beside it, heading in `direction` (of
  /// the grid's axes, any length).
  bool passable(Cell from, Cell to, const Vector2& direction) const;
  /// What a metre on a cell of the box costs, at least 1.
  double factor(Cell cell) const;
  bool slow() const { return slow_; }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Foot {
    double distance = 0, along = 0;  // cells; metres along the edge
  };
  Foot foot_on(std::uint32_t segment, const Vector2& point) const;
  void mark_driven(const std::vector<RoadVertex>& driven, const GridFrame& frame);
  void flood(const DrivableGrid& grid);
  bool with_direction(std::uint32_t segment, const Vector2& direction) const;
  /// Whether two roads that meet are both cut where a cell lies: a closed junction, which is not
  /// passed from one's ground to the other's either.
  bool both_cut_at(std::uint32_t a, std::uint32_t b, Cell cell) const;

  const RoadNetwork* network_ = nullptr;
  const RoadChanges* changes_ = nullptr;
  GridFrame frame_;
  CellBox box_;
  bool slow_ = false;
  std::vector<Vector2> vertices_;        // of the graph, in cells
  std::vector<std::uint32_t> edge_of_;   // of each vertex
  std::vector<std::uint32_t> segments_;  // of each cell: the vertex where the nearest begins
  std::vector<std::int32_t> driven_;  // of each cell: how many cells into the route; -1: not on it
};

}  // namespace stope::planner
