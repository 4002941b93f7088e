#pragma once

#include <optional>

#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// The place that lies farthest by road from another.
struct FarPlace {
  RoadPlace place;
  bool across_ring =
      false;  ///< no node, but halfway along a road that leads back to where it began
};

struct FarEnds {
  RoadPlace start;
  FarPlace goal;
};

/// Two places of the largest connected part of the network that lie far apart by road: the last two
/// nodes of a double sweep (the node farthest from the part's first node, then the one farthest
/// from that); on a ring with a single node that node and the place across the ring. None if no
/// road can be driven. O(E log V).
std::optional<FarEnds> far_ends(const RoadNetwork& network);

/// The node that costs most to reach from `start` (or, `against`, to come to it from). Where all
/// roads lead back to `start`: the place halfway along the longest of them.
FarPlace farthest_from(const RoadNetwork& network, RoadPlace start, bool against);

}  // namespace stope::planner
