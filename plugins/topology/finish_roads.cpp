#include "plugins/topology/finish_roads.hpp"

#include "plugins/topology/connect_pieces.hpp"
#include "plugins/topology/drop_narrow.hpp"
#include "plugins/topology/merge_junctions.hpp"
#include "plugins/topology/straighten_junctions.hpp"
#include "plugins/topology/to_road_graph.hpp"

namespace stope::topology {

RoadGraph finish_roads(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                       const std::vector<const TracedLine*>& lines, const ExtractionMethod& method,
                       const GridFrame& frame, RoadMemo* memo, const Checkpoint& checkpoint) {
  constexpr double kJunctionShare = 1.5;
  LineNetwork network = method.branching()
                            ? connect_pieces(space, outlines, edges, lines, checkpoint)
                            : to_network(lines);
  checkpoint();
  // Clearance counts from an obstacle's edge, distance from its cell's centre.
  if (method.params.min_clearance > 0)
    drop_narrow(network, method.params.min_clearance / frame.resolution + 0.5);
  checkpoint();
  if (method.branching())
    prune_spurs(network,
                {method.branches.min_branch / frame.resolution, method.branches.min_branch_share});
  checkpoint();
  merge_junctions(network, kJunctionShare);
  checkpoint();
  straighten_junctions(network);
  return to_road_graph(network, outlines, edges, space, frame, method.params.simplify, checkpoint,
                       memo);
}

}  // namespace stope::topology
