#include "plugins/planner/route_geometry.hpp"

#include <algorithm>
#include <limits>

namespace stope::planner {
namespace {

void append_link(std::vector<RoadVertex>& line, const Link& link, bool backward,
                 const RoadNetwork& network, const DrivableGrid* grid) {
  if (link.points.size() < 2) return;
  const double z = network.at(link.place).z;
  // The last point is the place on the road, which the route itself brings.
  for (std::size_t i = 0; i + 1 < link.points.size(); ++i) {
    const Vector2& point = link.points[backward ? link.points.size() - 2 - i : i];
    const double clearance = grid ? grid->clearance(point, kFarthestClearance)
                                  : std::numeric_limits<double>::quiet_NaN();
    line.push_back({point.x(), point.y(), z, clearance});
  }
}

void append_leg(std::vector<RoadVertex>& line, const RouteLeg& leg, const RoadNetwork& network) {
  const RoadEdge& edge = network.graph().edges[leg.edge];
  line.push_back(network.at({leg.edge, leg.from}));
  for (std::uint32_t i = 0; i < edge.vertex_count; ++i) {
    const bool forward = leg.from <= leg.to;
    const std::uint32_t v = edge.first_vertex + (forward ? i : edge.vertex_count - 1 - i);
    const double along = network.along(v);
    if (std::min(leg.from, leg.to) < along && along < std::max(leg.from, leg.to))
      line.push_back(network.graph().vertices[v]);
  }
  line.push_back(network.at({leg.edge, leg.to}));
}

}  // namespace

std::vector<RoadVertex> line_of_route(const Route& route, const PlanEnds& ends,
                                      const RoadNetwork& network, const DrivableGrid* grid) {
  std::vector<RoadVertex> line;
  append_link(line, ends.start(), false, network, grid);
  for (const RouteLeg& leg : route.legs) append_leg(line, leg, network);
  append_link(line, ends.goal(), true, network, grid);
  return line;
}

}  // namespace stope::planner
