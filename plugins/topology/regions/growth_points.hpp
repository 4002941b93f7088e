#pragma once

#include <span>
#include <vector>

#include "plugins/topology/regions/changed_squares.hpp"
#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// A cell a region may grow from.
struct GrowthPoint {
  CellIndex cell = 0;
  std::int32_t column = 0, row = 0;  ///< of that cell
  std::int32_t squared = 0;  ///< squared clearance in cells, at most that of the largest region
  std::uint64_t turn = 0;    ///< among equally clear ones
  bool operator==(const GrowthPoint&) const = default;
};

/// In the order they are tried: the clearest first, in the open one square after the other in an
/// order that is as good as random.
bool tried_before(const GrowthPoint& a, const GrowthPoint& b);

/// In the open, where no obstacle is within the largest radius, there is one growth point for each
/// square of so many cells.
std::int32_t spacing_in_the_open(double max_radius);

/// Whether a cell of this squared clearance is in the open.
bool is_open(std::int32_t squared, double max_radius);

/// The cells in the middle of free space: those none of whose neighbours is clearer; in the open,
/// one in each square. `max_radius` in cells.
std::vector<GrowthPoint> middle_points(const Ground& ground, double max_radius,
                                       const Checkpoint& checkpoint);

/// Makes the middle points of an earlier ground those of this one. `changed` has every cell that is
/// or was next to one whose clearance, up to `max_radius`, is another, and all of each square in
/// the open with a cell that is or was in the open in only one of the two.
void update_middle_points(const Ground& ground, double max_radius, const ChangedSquares& changed,
                          std::vector<GrowthPoint>& points);

/// Those of the cells that are free, once each.
std::vector<GrowthPoint> points_at(const Ground& ground, std::vector<CellIndex> cells,
                                   double max_radius);

}  // namespace stope::topology
