#include "plugins/topology/extract_roads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/topology/connect_pieces.hpp"
#include "plugins/topology/drop_narrow.hpp"
#include "plugins/topology/merge_junctions.hpp"
#include "plugins/topology/straighten_junctions.hpp"
#include "plugins/topology/to_road_graph.hpp"

namespace stope::topology {
namespace {

constexpr double kJunctionShare = 1.5;
// Below these, in cells, a rule would follow the raster's steps.
constexpr double kLeastResidual = 2.0;
constexpr double kLeastLambda = 4.0;

/// Free space, its outlines and the nearest of them for each cell.
struct Terrain {
  Terrain(const OccupancyGrid& grid, const ExtractionParams& params, std::int32_t gap,
          const Checkpoint& checkpoint)
      : space(make_free_space(grid, {params.occupied_threshold, params.unknown_is_obstacle},
                              checkpoint)),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, cells_of_area(grid, params), gap, checkpoint)) {
    find_nearest_outline(space, outlines, edges, checkpoint);
  }
  static double cells_of_area(const OccupancyGrid& grid, const ExtractionParams& params) {
    return params.min_obstacle_area / (grid.frame.resolution * grid.frame.resolution);
  }
  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
};

void drop_below_clearance(LineNetwork& network, const GridFrame& frame, double clearance) {
  // Clearance counts from an obstacle's edge, distance from its cell's centre.
  if (clearance > 0) drop_narrow(network, clearance / frame.resolution + 0.5);
}

}  // namespace

RoadGraph watershed_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                          const Checkpoint& checkpoint) {
  constexpr std::int32_t kGap = 64;
  Terrain terrain(grid, params, kGap, checkpoint);
  const auto corners =
      find_dividing_lines(terrain.space, terrain.outlines,
                          SideRule::between_outlines(terrain.outlines), terrain.edges, checkpoint);
  LineNetwork network =
      to_network(list_of(trace_lines(terrain.space, terrain.outlines, terrain.edges, corners, {})));
  checkpoint();
  drop_below_clearance(network, grid.frame, params.min_clearance);
  checkpoint();
  merge_junctions(network, kJunctionShare);
  checkpoint();
  straighten_junctions(network);
  return to_road_graph(network, terrain.outlines, terrain.edges, terrain.space, grid.frame,
                       params.simplify, checkpoint);
}

namespace {

/// From dividing lines, some of which end, to the graph.
RoadGraph branching_roads(const OccupancyGrid& grid, Terrain& terrain, const SideRule& rule,
                          const ExtractionParams& params, const BranchParams& branches,
                          const Checkpoint& checkpoint) {
  const auto corners =
      find_dividing_lines(terrain.space, terrain.outlines, rule, terrain.edges, checkpoint);
  const std::vector<TracedLine> lines =
      trace_lines(terrain.space, terrain.outlines, terrain.edges, corners, {});
  checkpoint();
  LineNetwork network =
      connect_pieces(terrain.space, terrain.outlines, terrain.edges, list_of(lines), checkpoint);
  checkpoint();
  drop_below_clearance(network, grid.frame, params.min_clearance);
  prune_spurs(network, {branches.min_branch / grid.frame.resolution, branches.min_branch_share});
  checkpoint();
  merge_junctions(network, kJunctionShare);
  checkpoint();
  straighten_junctions(network);
  return to_road_graph(network, terrain.outlines, terrain.edges, terrain.space, grid.frame,
                       params.simplify, checkpoint);
}

/// The most edges that two cells with sides of a given length between them may be apart.
std::int32_t gap_of(double cells) {
  return static_cast<std::int32_t>(std::clamp(std::floor(cells), 3.0, 1e6));
}

}  // namespace

RoadGraph voronoi_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                        const BranchParams& branches, const Checkpoint& checkpoint) {
  // Both sides of a branch that reaches so far are at least as long.
  Terrain terrain(grid, params, gap_of(branches.min_branch / grid.frame.resolution), checkpoint);
  return branching_roads(grid, terrain, SideRule::between_sides(terrain.outlines), params, branches,
                         checkpoint);
}

RoadGraph skeleton_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                         const BranchParams& branches, const SkeletonParams& skeleton,
                         const Checkpoint& checkpoint) {
  // Two cells by whose numbers they are n apart are at most 1.42 n cells apart, along and across.
  constexpr double kCellsPerEdge = std::numbers::sqrt2;
  const bool by_lambda = skeleton.pruning == SkeletonParams::Pruning::kLambda;
  const double cells =
      std::max((by_lambda ? skeleton.lambda : skeleton.residual) / grid.frame.resolution,
               by_lambda ? kLeastLambda : kLeastResidual);
  Terrain terrain(grid, params, gap_of(cells / kCellsPerEdge), checkpoint);
  if (by_lambda)
    return branching_roads(grid, terrain, SideRule::by_separation(terrain.outlines, cells), params,
                           branches, checkpoint);
  const OutlineWays ways = measure_ways(terrain.outlines);
  return branching_roads(grid, terrain, SideRule::by_residual(terrain.outlines, ways, cells),
                         params, branches, checkpoint);
}

RoadGraph watershed_part_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                               const BranchParams& branches, const PartParams& parts,
                               const Checkpoint& checkpoint) {
  Terrain terrain(grid, params, gap_of(branches.min_branch / grid.frame.resolution), checkpoint);
  const OutlineTurns turns =
      find_turns(terrain.outlines, {parts.corner_angle, parts.part_length / grid.frame.resolution});
  return branching_roads(grid, terrain, SideRule::between_parts(terrain.outlines, turns), params,
                         branches, checkpoint);
}

}  // namespace stope::topology
