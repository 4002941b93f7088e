#pragma once

#include <optional>
#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/road_snap.hpp"

namespace stope::planner {

/// The way from a point off the roads to a place on one.
struct Link {
  RoadPlace place;
  std::vector<Vector2> points;  ///< from the point to the place, both included
};

/// Links a free point to the nearest road that can be reached from it through free cells, no
/// farther than `most` metres. `candidates` as nearest_places() gives them. First straight lines
/// are tried, then the cells around are searched; a winding way is pulled straight where it can be.
std::optional<Link> link_to_road(const DrivableGrid& grid, const RoadNetwork& network,
                                 const Vector2& point, const std::vector<SnappedPlace>& candidates,
                                 double most);

}  // namespace stope::planner
