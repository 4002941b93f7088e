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
  bool allow_empty = false;   ///< heeded by the stages: the functions below give empty graphs
  bool medial_lines = false;  ///< stay on the medial axis, also where roads meet
  bool operator==(const ExtractionParams&) const = default;
};

/// When a branch that ends is kept; metres.
struct BranchParams {
  double min_branch = 4.0;
  double min_branch_share = 0.75;
  bool operator==(const BranchParams&) const = default;
};

/// Which lines of the medial axis a skeleton has, before its branches are judged; metres.
struct SkeletonParams {
  enum class Pruning { kChordResidual, kLambda };
  Pruning pruning = Pruning::kChordResidual;
  double residual = 1.0;  ///< least way along the outline beyond the straight one
  double lambda = 4.0;    ///< least distance of the two places seen
  bool operator==(const SkeletonParams&) const = default;
};

/// How a watershed splits outlines into sites: where they turn towards free space.
struct PartParams {
  double corner_angle = 1.0;  ///< radians
  double part_length = 40.0;  ///< metres within which the outline turns so far
  bool operator==(const PartParams&) const = default;
};

/// Roads between different obstacles only.
RoadGraph watershed_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                          const Checkpoint& checkpoint = never_stop);

/// Roads between different obstacles and between different sides of one, dead ends included.
RoadGraph voronoi_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                        const BranchParams& branches, const Checkpoint& checkpoint = never_stop);

/// Roads along the medial axis, between different obstacles and between sides of one.
RoadGraph skeleton_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                         const BranchParams& branches, const SkeletonParams& skeleton,
                         const Checkpoint& checkpoint = never_stop);

/// Roads between different obstacles and between parts of one, dead ends included.
RoadGraph watershed_part_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                               const BranchParams& branches, const PartParams& parts,
                               const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
