#pragma once

#include <functional>
#include <vector>

#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"
#include "stope/geometry.hpp"

namespace stope::planner {

/// The nearest place on a road to some point.
struct SnappedPlace {
  RoadPlace place;
  Vector2 position = Vector2::Zero();  ///< metres, map frame
  double distance = 0;                 ///< metres from the point
};

/// For each usable road for which `accept` holds, its place nearest to `point`; nearest road first,
/// equals by edge. O(vertices).
std::vector<SnappedPlace> nearest_places(const RoadNetwork& network, const Vector2& point,
                                         const std::function<bool(std::uint32_t edge)>& accept);

/// The same of the roads, as far as no cut is before it, that can be driven to from `place`, or
/// with `against` from which it can be driven to. None if there are none.
std::vector<SnappedPlace> reachable_places(const RoadNetwork& network, RoadPlace place,
                                           bool against, const Vector2& point,
                                           const RoadChanges& changes = {});

}  // namespace stope::planner
