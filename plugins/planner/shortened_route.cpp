#include "plugins/planner/shortened_route.hpp"

#include <cmath>
#include <utility>

#include "plugins/planner/route_geometry.hpp"
#include "plugins/planner/shortcut.hpp"

namespace stope::planner {

std::vector<RoadVertex> shortened_route(const Route& route, std::vector<RoadVertex> line,
                                        RoadRouter& router, const RoadNetwork& network,
                                        const DrivableGrid& grid, const PlanEnds& ends,
                                        const RoadChanges& changes) {
  constexpr int kAlternatives = 10;
  constexpr double kDearer = 1.2;
  std::vector<std::vector<RoadVertex>> lines{line};
  // What was driven is made dearer, so that the next way is another if one is nearly as good.
  RoadChanges dearer = changes;
  Route last = route;
  for (int i = 1; i < kAlternatives; ++i) {
    for (const RouteLeg& leg : last.legs) dearer.raise(leg.edge, kDearer * dearer.factor(leg.edge));
    auto other = router.find(ends.start().place, ends.goal().place, dearer);
    if (!other) break;
    last = *std::move(other);
    lines.push_back(line_of_route(last, ends, network, &grid));
  }
  const auto points = shortcut_along(grid, lines, network.rules().min_clearance);
  if (!points) return line;
  std::vector<RoadVertex> pulled;
  std::size_t nearest = 0;
  for (const Vector2& point : *points) {
    const auto distance = [&](std::size_t i) {
      return std::hypot(line[i].x - point.x(), line[i].y - point.y());
    };
    for (std::size_t i = nearest + 1; i < line.size(); ++i)
      if (distance(i) < distance(nearest)) nearest = i;
    pulled.push_back(
        {point.x(), point.y(), line[nearest].z, grid.clearance(point, kFarthestClearance)});
  }
  return pulled;
}

}  // namespace stope::planner
