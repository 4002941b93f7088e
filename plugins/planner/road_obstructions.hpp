#pragma once

#include <optional>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/road_router.hpp"

namespace stope::planner {

/// The first place on a leg, as it is driven, where the grid shows an obstacle that the road's own
/// clearance does not know of: an occupied cell under the centre line, or one nearer to it than
/// `min_clearance` although the road was mapped to have that. Where a road's clearance is not
/// known, only what lies under its centre line counts. Looked at every half cell; unknown cells and
/// those off the grid are no obstacles.
std::optional<RoadPlace> obstruction_on(const DrivableGrid& grid, const RoadNetwork& network,
                                        const RouteLeg& leg, double min_clearance);

}  // namespace stope::planner
