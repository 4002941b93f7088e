#include "plugins/planner/drive_site.hpp"

#include <algorithm>

namespace stope::planner {

ClearanceField field_around(const RouteLine& line, const OccupancyGrid& grid,
                            const DriveRequest& request) {
  constexpr double kApart = 8, kBeyond = 1;  // metres
  const Vehicle& vehicle = request.vehicle;
  const double most = CoveringCircles(vehicle).radius + vehicle.margin +
                      request.wishes.comfortable_clearance + kBeyond;
  return {grid, line.places(kApart), DriveSite::kAround, std::max(ClearanceField::kMost, most)};
}

}  // namespace stope::planner
