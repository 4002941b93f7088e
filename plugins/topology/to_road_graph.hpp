#pragma once

#include "plugins/topology/line_network.hpp"
#include "plugins/topology/outlines.hpp"
#include "plugins/topology/road_memo.hpp"
#include "stope/payloads/grid_frame.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// How centre lines become polylines.
struct LineStyle {
  double tolerance = 0.2;  ///< metres that a polyline may be off its smoothed line
  double smoothing = 0.4;  ///< reach of the smoothing as a share of the clearance, at least 3 cells
};

/// Brings centre lines into the map frame, smoothed and simplified, as a
/// canonical road graph. Clearance is measured to the obstacle's edge, taken half a cell before its
/// centre; an edge's width is twice the median clearance along it. `memo`, if given, knows roads
/// that are finished already; the graph is the same. `edges` as DistanceField asks for.
RoadGraph to_road_graph(const LineNetwork& network, const Outlines& outlines, const EdgeGrid& edges,
                        const FreeSpace& space, const GridFrame& frame, const LineStyle& style,
                        const Checkpoint& checkpoint = never_stop, RoadMemo* memo = nullptr);

}  // namespace stope::topology
