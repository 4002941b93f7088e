#include "plugins/topology/extract_roads.hpp"

#include "plugins/topology/finish_roads.hpp"
#include "plugins/topology/terrain.hpp"

namespace stope::topology {

RoadGraph extract_roads(const OccupancyGrid& grid, const ExtractionMethod& method,
                        const Checkpoint& checkpoint) {
  Terrain terrain(grid, method, checkpoint);
  std::vector<CellIndex> corners;
  std::vector<ReplacedEdge> replaced;
  {
    const DividingRule rule(method, grid.frame, terrain.outlines);
    corners = find_dividing_lines(terrain.space, terrain.outlines, rule.rule(), terrain.edges,
                                  checkpoint, &replaced);
  }
  Courses courses(true);
  LineTracer tracer(terrain.space, terrain.outlines, terrain.edges, courses,
                    method.least_apart(grid.frame));
  const std::vector<TracedLine> lines = trace_lines(tracer, corners);
  checkpoint();
  return finish_roads(terrain.space, terrain.outlines, terrain.edges, replaced, list_of(lines),
                      LineEnds(list_of(lines)), courses, method, grid.frame, nullptr, checkpoint);
}

RoadGraph watershed_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                          const Checkpoint& checkpoint) {
  return extract_roads(grid, {ExtractionMethod::Kind::kWatershed, params, {}, {}, {}}, checkpoint);
}

RoadGraph voronoi_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                        const BranchParams& branches, const Checkpoint& checkpoint) {
  return extract_roads(grid, {ExtractionMethod::Kind::kVoronoi, params, branches, {}, {}},
                       checkpoint);
}

RoadGraph skeleton_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                         const BranchParams& branches, const SkeletonParams& skeleton,
                         const Checkpoint& checkpoint) {
  return extract_roads(grid, {ExtractionMethod::Kind::kSkeleton, params, branches, skeleton, {}},
                       checkpoint);
}

RoadGraph watershed_part_roads(const OccupancyGrid& grid, const ExtractionParams& params,
                               const BranchParams& branches, const PartParams& parts,
                               const Checkpoint& checkpoint) {
  return extract_roads(grid, {ExtractionMethod::Kind::kWatershedParts, params, branches, {}, parts},
                       checkpoint);
}

}  // namespace stope::topology
