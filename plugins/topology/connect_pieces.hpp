#pragma once

#include "plugins/topology/trace_lines.hpp"

namespace stope::topology {

/// Lines of one network for each piece of free space.
struct ConnectedLines {
  LineNetwork network;
  /// By line of the network: its steps that are narrow (TracedLine) and have one outline on both
  /// sides. A line has a point for each step and one before and behind them.
  std::vector<std::vector<StepRange>> narrow;
};

/// The dividing lines, given in order with the corners they end at, as one connected network for
/// each piece of free space (8-connected).
///
/// Dividing lines between sides are connected wherever no hole hides in a notch shorter than the
/// bound of the side rule. Where one does, its lines are linked to the rest along the way of
/// greatest clearance; a piece without any line (a round yard) gets one node, at its widest place.
/// A link joins what was apart, so it adds no cycle. `least_apart` is the lines'.
ConnectedLines connect_pieces(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                              std::vector<const TracedLine*> lines, const LineEnds& ends,
                              Courses& courses, double least_apart,
                              const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
