#include "plugins/topology/finish_roads.hpp"

#include "plugins/topology/connect_pieces.hpp"
#include "plugins/topology/drop_narrow.hpp"
#include "plugins/topology/merge_junctions.hpp"
#include "plugins/topology/straighten_junctions.hpp"
#include "plugins/topology/to_road_graph.hpp"

namespace stope::topology {

RoadGraph finish_roads(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                       const std::vector<const TracedLine*>& lines, const LineEnds& ends,
                       Courses& courses, const ExtractionMethod& method, const GridFrame& frame,
                       RoadMemo* memo, const Checkpoint& checkpoint) {
  constexpr double kJunctionShare = 1.5;
  constexpr double kSmoothingShare = 0.4;
  LineNetwork network =
      method.branching() ? connect_pieces(space, outlines, edges, lines, ends, courses, checkpoint)
                         : to_network(lines, ends, courses);
  checkpoint();
  // Clearance counts from an obstacle's edge, distance from its cell's centre.
  if (method.params.min_clearance > 0)
    drop_narrow(network, method.params.min_clearance / frame.resolution + 0.5);
  checkpoint();
  if (method.branching())
    prune_spurs(network,
                {method.branches.min_branch / frame.resolution, method.branches.min_branch_share});
  checkpoint();
  // A skeleton stays on the medial axis, also where that bends into every opening; but two lines
  // from one joined junction must not run side by side.
  const bool exact = method.kind == ExtractionMethod::Kind::kSkeleton;
  merge_junctions(network, kJunctionShare, exact);
  checkpoint();
  if (!exact) straighten_junctions(network);
  return to_road_graph(network, outlines, edges, space, frame,
                       {method.params.simplify, exact ? 0.0 : kSmoothingShare}, checkpoint, memo);
}

}  // namespace stope::topology
