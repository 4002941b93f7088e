#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// When a branch that ends is a road.
struct SpurRule {
  /// Cells it must reach further than the largest circle at its root.
  double least_reach = 0;
  /// … and the same as a share of that circle's radius. Every corner of right angle has a branch
  /// that reaches 0.41 radii further.
  double least_share = 0.75;
};

/// Removes the branches that roughness and corners leave, keeping dead-end roads, and lets those
/// end where their full width ends, not in a corner of their face.
///
/// The reach of a point of a branch is how far the free space behind it goes on: the longest way
/// along the branch to its tip plus the tip's distance to the obstacle, minus the point's own
/// distance (erosion thickness; Liu, Chambers, Letscher and Ju 2011). It never falls from the tip
/// towards the root. A branch is kept if it has a point whose reach satisfies the rule. It is then
/// cut where distance to the obstacle plus half the way travelled is largest: beyond that place
/// the sides close in at more than 30 degrees each, as at a face. Removing branches from their tips
/// leaves pieces and cycles as they are; a tree of which nothing is left becomes a lone node.
/// Cost: n log n in the number of lines, linear in their points.
void prune_spurs(LineNetwork& network, const SpurRule& rule);

}  // namespace stope::topology
