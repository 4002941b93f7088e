#pragma once

#include <vector>

#include "plugins/topology/regions/ground.hpp"
#include "plugins/topology/regions/growth_points.hpp"
#include "plugins/topology/regions/region_grower.hpp"

namespace stope::topology {

/// A region as it grew, and when: regions of earlier rounds grow first, then those of clearer
/// points.
struct GrownRegion {
  std::int32_t name = 0;
  std::int32_t round = 0;
  GrowthPoint point;
  Growth growth;
};

/// What has grown on a ground.
struct GrownRegions {
  /// Nothing yet.
  GrownRegions(const Ground& ground, const GrowthRule& rule, const Checkpoint& checkpoint);

  std::vector<GrownRegion> list;     ///< in the order they grew
  RegionCells names;                 ///< by cell: whose it is, 0 if nobody's
  PaddedGrid<std::uint8_t> open;     ///< 1 in free cells that nothing has grown into
  std::int32_t names_given = 0;      ///< from 1 on; some may be unused
  std::vector<std::int32_t> unused;  ///< names
  RegionGrower grower;               ///< whose tables serve the next map, too
};

/// What shares of its clearance a point must have for itself, by round.
constexpr std::array<double, 4> kOwnRoom{1.0, 0.6, 0.3, 0.0};

/// Whether there is room for a region of its own around a cell: it is open, and so is a circle of
/// that radius. Reads no cell further than `room` from it.
class RoomToGrow {
 public:
  RoomToGrow();
  bool operator()(const PaddedGrid<std::uint8_t>& open, CellIndex cell, double room) const;

 private:
  struct Direction {
    double x = 0, y = 0;
  };
  std::array<Direction, 16> directions_{};
};

/// Grows regions from the points, group after group, until every point is in one. Within a group
/// points with much room are first, so that regions lie side by side instead of in each other's
/// gaps. Without `keep_cells` the list does not have the cells of each region.
GrownRegions grow_regions(const Ground& ground, const std::vector<std::vector<GrowthPoint>>& groups,
                          const GrowthRule& rule, bool keep_cells, const Checkpoint& checkpoint);

}  // namespace stope::topology
