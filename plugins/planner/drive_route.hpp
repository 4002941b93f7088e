#pragma once

#include <functional>
#include <string_view>

#include "plugins/planner/drive_site.hpp"

namespace stope::planner {

/// A way along a route that the truck can drive: smooth where that is possible, with words of arcs
/// and straights where it is not. `field` is field_around() the line. Throws Error, a sentence with
/// the place and the reason, if there is none.
DriveCurve drive_route(const RouteLine& line, const OccupancyGrid& grid,
                       const ElevationGrid* elevation, const ClearanceField& field,
                       const DriveRequest& request,
                       const std::function<void(std::string_view)>& say,
                       const std::function<void()>& checkpoint);

}  // namespace stope::planner
