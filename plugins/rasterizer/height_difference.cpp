#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "plugins/rasterizer/close_gaps.hpp"
#include "plugins/rasterizer/fill_holes.hpp"
#include "plugins/rasterizer/free_driven.hpp"
#include "plugins/rasterizer/keep_reachable.hpp"
#include "plugins/rasterizer/local_ground.hpp"
#include "stope/stope.hpp"

namespace stope::rasterizer {
namespace {

constexpr double kMostCells = 4e9;
constexpr double kCellsAcrossGround = 6;  // cells of the ground a radius takes, at most

/// The cells that hold all points, on the lattice of multiples of the resolution, so that grids
/// made apart from each other fit cell on cell. Throws Error if no point is finite.
GridFrame frame_of(const PointCloud& cloud, double resolution) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double left = kFar, bottom = kFar, right = -kFar, top = -kFar;
  for (const Point3f& point : cloud.points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    left = std::min(left, cloud.origin.x() + point.x);
    right = std::max(right, cloud.origin.x() + point.x);
    bottom = std::min(bottom, cloud.origin.y() + point.y);
    top = std::max(top, cloud.origin.y() + point.y);
  }
  if (!(left <= right))
    throw Error("the cloud has no finite point, so there is nothing to rasterize");
  const double column = std::floor(left / resolution), row = std::floor(bottom / resolution);
  const double width = std::floor(right / resolution) - column + 1;
  const double height = std::floor(top / resolution) - row + 1;
  if (!(width * height <= kMostCells)) {
    throw Error(fmt::format(
        "the cloud spans {:.0f} x {:.0f} m, too much for cells of {} m: are there points far off?",
        right - left, top - bottom, resolution));
  }
  return {static_cast<std::int32_t>(width),
          static_cast<std::int32_t>(height),
          resolution,
          {column * resolution, row * resolution, 0}};
}

}  // namespace

class HeightDifference final : public Map<OccupancyGrid(PointCloud, Optional<Trajectory>)> {
 public:
  struct Params {
    double resolution = 0.5;
    double obstacle_height = 0.5;
    double max_hole = 50;
    double driven_width = 2.5;
    double passage = 4;
    int min_points = 2;
    std::optional<double> overhang;
    double ground_radius = 3;
    double ground_quantile = 0.25;
    double close_gaps = 2.5;
  } params;

  static void describe(About<HeightDifference>& about) {
    about.summary("Marks cells with several points above the local ground as obstacles.")
        .from("Huang et al., Obstacles in Mining Area, sec. IV")
        .notes(
            "The paper leaves open what the ground is: here a low quantile of the lowest points "
            "within ground_radius, so that a plane steeper than about obstacle_height over 0.4 of "
            "ground_radius counts as a wall. A cell without points stays unknown; gaps up to "
            "close_gaps between the rings of a spinning LiDAR are filled, obstacles first, but "
            "never across a step. With a trajectory wired, the route itself is free, and only the "
            "free ground is kept that a vehicle can reach from it. Vehicles that move while the "
            "scans are taken leave obstacles where they were.")
        .ports("cloud", "trajectory", "grid")
        .param("resolution", &Params::resolution, "m", more_than(0.0), "Edge of a cell.")
        .param("obstacle_height", &Params::obstacle_height, "m", more_than(0.0),
               "Points higher than this above the ground are an obstacle's.")
        .param("min_points", &Params::min_points, at_least(1),
               "How many such points make an obstacle.")
        .param("overhang", &Params::overhang, "m", more_than(0.0),
               "Points higher than this above the ground are driven under; not given: none are.")
        .param("ground_radius", &Params::ground_radius, "m", more_than(0.0),
               "How far round a cell the ground is looked for.")
        .param("ground_quantile", &Params::ground_quantile, between(0.0, 1.0),
               "Which of the lowest points there is the ground: 0 the lowest, 0.5 the middle one.")
        .param("close_gaps", &Params::close_gaps, "m", at_least(0.0),
               "Widest unknown gap that is filled; 0 fills none.")
        .param("max_hole", &Params::max_hole, "m^2", at_least(0.0),
               "Unknown holes in free ground up to this area are filled, if they touch no obstacle "
               "and hide no step.")
        .param("driven_width", &Params::driven_width, "m", at_least(0.0),
               "With a trajectory: this wide along the route the ground is free, since the vehicle "
               "was there.")
        .param("passage", &Params::passage, "m", at_least(0.0),
               "With a trajectory: narrower passages do not lead anywhere.");
  }

  OccupancyGrid apply(const PointCloud& cloud, const Optional<Trajectory>& trajectory,
                      Context& context) const {
    OccupancyGrid grid;
    grid.frame = frame_of(cloud, params.resolution);
    const GroundRules rules{std::max(params.resolution, params.ground_radius / kCellsAcrossGround),
                            params.ground_radius, params.ground_quantile};
    const LocalGround ground = local_ground(cloud, grid.frame, rules, context);
    classify(cloud, ground, grid);
    context.stop_if_cancelled();
    // Across a gap the ground may rise as a ramp does, up to the slope that still counts as ground.
    const double slope = params.obstacle_height / (0.4 * params.ground_radius);
    close_gaps(grid, ground, params.close_gaps, params.obstacle_height + slope * params.close_gaps);
    if (trajectory) free_driven(grid, *trajectory, params.driven_width);
    fill_holes(grid, ground, params.max_hole, params.obstacle_height, slope);
    if (trajectory && !keep_reachable(grid, *trajectory, params.passage)) {
      context.warn(
          "the trajectory does not touch the cloud's area, so all free ground is kept: are both in "
          "the same frame?");
    }
    return grid;
  }

 private:
  void classify(const PointCloud& cloud, const LocalGround& ground, OccupancyGrid& grid) const {
    struct Evidence {
      std::uint16_t high = 0, low = 0;
    };
    std::vector<Evidence> evidence(grid.frame.size());
    for (const Point3f& point : cloud.points) {
      const double x = cloud.origin.x() + point.x, y = cloud.origin.y() + point.y;
      const auto cell = grid.frame.cell_at(x, y);
      const auto ground_cell = ground.frame.cell_at(x, y);
      if (!cell || !ground_cell) continue;
      const float height = point.z - ground.height[ground.frame.place(*ground_cell)];
      if (std::isnan(height) || (params.overhang && height > *params.overhang)) continue;
      Evidence& seen = evidence[grid.frame.place(*cell)];
      std::uint16_t& count = height > params.obstacle_height ? seen.high : seen.low;
      if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
    }
    grid.cells.assign(grid.frame.size(), OccupancyGrid::kUnknown);
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      if (evidence[i].high >= params.min_points) {
        grid.cells[i] = OccupancyGrid::kOccupied;
      } else if (evidence[i].low > 0) {
        grid.cells[i] = OccupancyGrid::kFree;
      }
    }
  }
};

STOPE_STAGE(HeightDifference, "rasterizer/height_difference")

}  // namespace stope::rasterizer
