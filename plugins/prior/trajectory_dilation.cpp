#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plugins/prior/dilate_track.hpp"
#include "stope/stope.hpp"

namespace stope::prior {
namespace {

constexpr double kMostCells = 4e9;

/// A frame that holds all points with `margin` metres to spare, on the lattice of multiples of the
/// resolution, so that grids made apart from each other fit cell on cell.
GridFrame frame_around(const std::vector<Vector2>& points, double margin, double resolution) {
  Vector2 low = points.front(), high = points.front();
  for (const Vector2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double left = std::floor((low.x() - margin) / resolution);
  const double bottom = std::floor((low.y() - margin) / resolution);
  const double width = std::ceil((high.x() + margin) / resolution) - left;
  const double height = std::ceil((high.y() + margin) / resolution) - bottom;
  if (!(width * height <= kMostCells)) {
    throw Error(fmt::format(
        "the trajectory spans {:.0f} x {:.0f} m, too much for cells of {} m: are its poses right?",
        high.x() - low.x(), high.y() - low.y(), resolution));
  }
  return {static_cast<std::int32_t>(width),
          static_cast<std::int32_t>(height),
          resolution,
          {left * resolution, bottom * resolution, 0}};
}

}  // namespace

class TrajectoryDilation final : public Map<OccupancyGrid(Trajectory)> {
 public:
  struct Params {
    double width = 8;
    double resolution = 0.5;
    double margin = 5;
    std::string outside = "unknown";
  } params;

  static void describe(About<TrajectoryDilation>& about) {
    about.summary("The prior road network: the driven route, widened to a road.")
        .from("Huang et al., Obstacles in Mining Area, sec. III")
        .notes(
            "The paper leaves the width open; take the road's or the truck's. A cell is free if "
            "its centre lies within half the width of the route.")
        .ports("trajectory", "grid")
        .param("width", &Params::width, "m", more_than(0.0), "Width of the road.")
        .param("resolution", &Params::resolution, "m", more_than(0.0), "Edge of a cell.")
        .param("margin", &Params::margin, "m", at_least(0.0), "Room round the road.")
        .param("outside", &Params::outside, one_of({"unknown", "occupied"}),
               "What cells off the road become.");
  }

  OccupancyGrid apply(const Trajectory& trajectory, Context& context) const {
    std::vector<Vector2> line;
    for (const StampedPose& pose : trajectory.poses) {
      const Vector3& at = pose.T_map_lidar.translation;
      if (std::isfinite(at.x()) && std::isfinite(at.y())) line.emplace_back(at.x(), at.y());
    }
    if (line.empty())
      throw Error("the trajectory has no pose with a place, so there is no route to widen");
    if (line.size() < trajectory.poses.size()) {
      context.warn(fmt::format("{} of {} poses are not finite and are left out",
                               trajectory.poses.size() - line.size(), trajectory.poses.size()));
    }
    OccupancyGrid grid;
    grid.frame = frame_around(line, params.width / 2 + params.margin, params.resolution);
    grid.cells.assign(grid.frame.size(), params.outside == "unknown" ? OccupancyGrid::kUnknown
                                                                     : OccupancyGrid::kOccupied);
    dilate_track(grid, line, params.width / 2, OccupancyGrid::kFree);
    return grid;
  }
};

STOPE_STAGE(TrajectoryDilation, "prior/trajectory_dilation")

}  // namespace stope::prior
