#pragma once

#include <span>
#include <vector>

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// A cell a region may grow from.
struct GrowthPoint {
  CellIndex cell = 0;
  std::int32_t squared = 0;  ///< squared clearance in cells, at most that of the largest region
  bool operator==(const GrowthPoint&) const = default;
};

/// In the order they are tried: the clearest first.
bool tried_before(const GrowthPoint& a, const GrowthPoint& b);

/// The cells in the middle of free space: those none of whose neighbours is clearer. Where nothing
/// is near, every few cells one. `max_radius` in cells.
std::vector<GrowthPoint> middle_points(const Ground& ground, double max_radius,
                                       const Checkpoint& checkpoint);

/// Those of the cells that are free, once each.
std::vector<GrowthPoint> points_at(const Ground& ground, std::vector<CellIndex> cells,
                                   double max_radius);

}  // namespace stope::topology
