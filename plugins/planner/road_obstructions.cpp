#include "plugins/planner/road_obstructions.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {

std::optional<RoadPlace> obstruction_on(const DrivableGrid& grid, const RoadNetwork& network,
                                        const RouteLeg& leg, double min_clearance) {
  const double resolution = grid.frame().resolution;
  // A line that was simplified, on a grid of cells, may differ that much from its clearance.
  const double slack = 1.5 * resolution;
  const double steps = std::ceil(std::abs(leg.to - leg.from) / (0.5 * resolution));
  for (double i = 0; i <= steps; ++i) {
    const RoadPlace place{leg.edge,
                          steps > 0 ? leg.from + (leg.to - leg.from) * i / steps : leg.from};
    const RoadVertex vertex = network.at(place);
    if (vertex.clearance <= slack) continue;
    const Vector2 point(vertex.x, vertex.y);
    if (grid.ground_at(point) == Ground::kObstacle) return place;
    if (std::isnan(vertex.clearance)) continue;
    const double wanted = std::min(min_clearance, vertex.clearance - slack);
    if (wanted > resolution && grid.distance_to_obstacle(point, wanted) < wanted) return place;
  }
  return std::nullopt;
}

}  // namespace stope::planner
