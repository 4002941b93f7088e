#pragma once

#include "plugins/topology/extraction_method.hpp"
#include "plugins/topology/road_memo.hpp"
#include "plugins/topology/trace_lines.hpp"

namespace stope::topology {

/// From dividing lines, given in order with the corners they end at, to the graph. `courses` are
/// theirs; `memo`, if given, knows finished roads. `replaced` are the cells that were given a
/// neighbour's edge: all of them see their own while roads are measured, and `edges` comes back as
/// it was.
RoadGraph finish_roads(FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
                       std::vector<ReplacedEdge>& replaced,
                       const std::vector<const TracedLine*>& lines, const LineEnds& ends,
                       Courses& courses, const ExtractionMethod& method, const GridFrame& frame,
                       RoadMemo* memo, const Checkpoint& checkpoint);

}  // namespace stope::topology
