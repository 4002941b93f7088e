#include "plugins/topology/finish_roads.hpp"

#include "plugins/topology/connect_pieces.hpp"
#include "plugins/topology/drop_narrow.hpp"
#include "plugins/topology/keep_wide_lines.hpp"
#include "plugins/topology/merge_junctions.hpp"
#include "plugins/topology/straighten_junctions.hpp"
#include "plugins/topology/to_road_graph.hpp"

namespace stope::topology {

namespace {

/// Lets the cells see their own edges, or again their neighbours'.
void exchange(std::vector<ReplacedEdge>& replaced, EdgeGrid& edges) {
  for (ReplacedEdge& cell : replaced) std::swap(edges[cell.cell], cell.nearest);
}

}  // namespace

RoadGraph finish_roads(FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
                       std::vector<ReplacedEdge>& replaced,
                       const std::vector<const TracedLine*>& lines, const LineEnds& ends,
                       Courses& courses, const ExtractionMethod& method, const GridFrame& frame,
                       RoadMemo* memo, const Checkpoint& checkpoint) {
  constexpr double kJunctionShare = 1.5;
  constexpr double kSmoothingShare = 0.4;
  LineNetwork network(courses);
  if (method.branching()) {
    const double least_apart = method.least_apart(frame);
    ConnectedLines connected =
        connect_pieces(space, outlines, edges, lines, ends, courses, least_apart, checkpoint);
    network = std::move(connected.network);
    if (method.by_lambda()) keep_wide_lines(network, connected.narrow, method.gap(frame));
  } else {
    network = to_network(lines, ends, courses);
  }
  checkpoint();
  // Clearance counts from an obstacle's edge, distance from its cell's centre.
  if (method.params.min_clearance > 0)
    drop_narrow(network, method.params.min_clearance / frame.resolution + 0.5);
  checkpoint();
  if (method.branching())
    prune_spurs(network,
                {method.branches.min_branch / frame.resolution, method.branches.min_branch_share});
  checkpoint();
  // The medial axis bends into every opening; where it is kept, two lines from one joined junction
  // must still not run side by side.
  merge_junctions(network, kJunctionShare, method.params.medial_lines);
  checkpoint();
  if (!method.params.medial_lines) straighten_junctions(network);
  const LineStyle style{method.params.simplify, method.params.medial_lines ? 0.0 : kSmoothingShare};
  exchange(replaced, edges);
  RoadGraph roads = to_road_graph(network, outlines, edges, space, frame, style, checkpoint, memo);
  exchange(replaced, edges);
  return roads;
}

}  // namespace stope::topology
