#pragma once

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/prune_spurs.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// What every member of the family can be told.
struct ExtractionParams {
  double min_clearance = 2.0;
  double min_obstacle_area = 10.0;
  double simplify = 0.2;
  double occupied_threshold = 0.5;
  bool unknown_is_obstacle = true;
  bool allow_empty = false;  ///< heeded by the stages: the functions below give empty graphs
};

/// When voronoi keeps a branch that ends; metres.
struct BranchParams {
  double min_branch = 4.0;
  double min_branch_share = 0.75;
};

/// Roads between different obstacles only.
RoadGraph watershed_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                          const Checkpoint& checkpoint = never_stop);

/// Roads between different obstacles and between different sides of one, dead ends included.
RoadGraph voronoi_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                        const BranchParams& branches, const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
