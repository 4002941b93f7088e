#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plugins/topology/regions/finish_regions.hpp"
#include "plugins/topology/regions/grow_regions.hpp"
#include "plugins/topology/regions/merge_regions.hpp"
#include "plugins/topology/regions/shared_names.hpp"
#include "stope/payloads/trajectory.hpp"
#include "stope/random.hpp"

namespace stope::topology {

/// What topology/region_growing is told; metres and square metres.
struct GrowingParams {
  double growth_radius = 12.0;
  double max_radius = 30.0;
  double radius_weight = 1.0;
  double addition_ratio = 0.3;
  double obstacle_ratio = 0.05;
  double second_radius = 30.0;
  double merge_radius = 6.0;
  double merge_area = 2000.0;
  double merge_obstacle_ratio = 0.2;
  double coverage = 0.95;
  double min_region_area = 50.0;  ///< of a part of free space, else it is left out
  bool as_printed = false;        ///< `mode: paper`
};

/// What is kept of one map for the next.
struct GrowthMemory {
  std::vector<CellIndex> visited;
  std::vector<GrowthPoint> middle;    ///< of free space
  std::optional<GrownRegions> grown;  ///< and what they have absorbed
  std::optional<TileParts> tiles;     ///< … of which
  std::vector<RegionShape> shapes;    ///< … by name
  std::optional<SharedNames> names;   ///< … of each cell
  MergeMemo merges;
  RegionMemo memo;
  std::size_t reused = 0;  ///< of what has grown: taken from the map before
};

/// The cells of a grid that a trajectory passes through, in its order; `outside` counts the poses
/// that are not on the grid, `blocked` those in cells that are not free.
std::vector<CellIndex> cells_visited(const Ground& ground, const Trajectory& trajectory,
                                     std::size_t& outside, std::size_t& blocked);

/// Divides free space by region growing (Wang et al. 2019). `visited` may be empty. The ground is
/// used up: a large map's labels take its place in memory.
RegionsAndRoads segment_by_growth(Ground&& ground, const std::vector<CellIndex>& visited,
                                  const GrowingParams& params, const RegionRoadsRule& roads,
                                  Random random, const Checkpoint& checkpoint = never_stop);

/// The same for maps that follow each other, not in `mode: paper`: where the memory has one of the
/// map before and `change` tells how the ground differs from that one's, what grew there is used
/// where it can be, with the same result; then it is of this map. Without `change` what it has is
/// forgotten.
RegionsAndRoads segment_by_growth(const Ground& ground, const std::vector<CellIndex>& visited,
                                  const GrowingParams& params, const RegionRoadsRule& roads,
                                  GrowthMemory& memory, const GroundChange* change = nullptr,
                                  const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
