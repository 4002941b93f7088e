#include "plugins/planner/plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/far_ends.hpp"
#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/plan_ends.hpp"
#include "plugins/planner/route_geometry.hpp"
#include "plugins/planner/shortened_route.hpp"
#include "plugins/planner/unobstructed_route.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

/// Whoever made the graph, a search must not run on what is no number.
const RoadGraph& checked(const RoadGraph& roads) {
  if (roads.edges.empty())
    throw Error("the road graph has no roads, so there is no way to plan: is any of the map free?");
  for (const RoadEdge& edge : roads.edges) {
    const std::uint64_t end = std::uint64_t{edge.first_vertex} + edge.vertex_count;
    if (edge.from >= roads.nodes.size() || edge.to >= roads.nodes.size() ||
        end > roads.vertices.size())
      throw Error(
          fmt::format("road {} of the road graph refers to nodes or vertices that are not "
                      "there: the graph is damaged",
                      edge.id));
    for (const RoadVertex& vertex : roads.polyline(edge)) {
      if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y))
        throw Error(
            fmt::format("road {} of the road graph runs through a place whose coordinates "
                        "are not finite: mend it where it was made or imported",
                        edge.id));
    }
  }
  return roads;
}

}  // namespace

RoadPlanner::RoadPlanner(const RoadGraph& roads, const RoadRules& rules, RouteSearch search,
                         const std::function<void()>& pause)
    : network_(checked(roads), rules), router_(network_, search, pause) {
  if (!far_ends(network_)) {
    throw Error(fmt::format(
        "none of the {} roads can be driven: all are closed or have less than the min_clearance of "
        "{:.2f} m",
        roads.edges.size(), rules.min_clearance));
  }
}

Path RoadPlanner::plan(const OccupancyGrid* grid, const PlanRequest& request, const Say& say) {
  std::optional<DrivableGrid> drivable;
  if (grid) drivable.emplace(*grid);
  const DrivableGrid* ground = drivable ? &*drivable : nullptr;
  const RoadChanges requested = resolve(request.changes, network_, request.snap_distance, say);
  RoadChanges changes = requested;  // and what the grid shows obstructed
  const PlanEnds ends(network_, ground, request, changes, say);
  const Route route = unobstructed_route(
      router_, network_, request.avoid_obstructed ? ground : nullptr, ends, changes, say);
  std::vector<RoadVertex> line = line_of_route(route, ends, network_, ground);
  if (request.shortcut && ground)
    line = shortened_route(std::move(line), network_, *ground, requested, say);
  else if (request.shortcut)
    say("shortcut needs a grid to see free ground in; without one the way follows the roads");
  Path path;
  for (const RouteLeg& leg : route.legs) path.edges.push_back(network_.graph().edges[leg.edge].id);
  path.length = length_of(line);
  path.points = sample_path(line, request.step, request.smoothing);
  return path;
}

PlanRequest RoadPlanner::with_ends(const OccupancyGrid& grid, const PlanRequest& request,
                                   const Say& say) const {
  PlanRequest complete = request;
  if (request.start && request.goal) return complete;
  const DrivableGrid ground(grid);
  const RoadChanges changes = resolve(request.changes, network_, request.snap_distance);
  const PlanEnds ends(network_, &ground, request, changes, say);
  if (!request.start) complete.start_place = ends.start().place;
  if (!request.goal) complete.goal_place = ends.goal().place;
  return complete;
}

Path plan_path(const RoadGraph& roads, const OccupancyGrid* grid, const PlanRequest& request,
               const Say& say) {
  return RoadPlanner(roads, request.rules).plan(grid, request, say);
}

}  // namespace stope::planner
