#include "plugins/planner/plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/far_ends.hpp"
#include "plugins/planner/grid_link.hpp"
#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/road_search.hpp"
#include "plugins/planner/road_snap.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

std::string text_of(const Vector2& point) {
  return fmt::format("({:.2f}, {:.2f})", point.x(), point.y());
}

Vector2 position_of(const RoadNetwork& network, RoadPlace place) {
  const RoadVertex vertex = network.at(place);
  return {vertex.x, vertex.y};
}

class Planner {
 public:
  Planner(const RoadNetwork& network, const OccupancyGrid* grid, const PlanRequest& request,
          const std::function<void(std::string_view)>& say)
      : network_(network), request_(request), say_(say) {
    if (grid) grid_.emplace(*grid);
  }

  Path plan() {
    choose_ends();
    const auto route = find_route(network_, start_.place, goal_.place);
    if (!route) {
      const Vector2 goal = goal_.points.front();
      refuse("goal", goal, "cannot be reached from the start by road",
             nearest_reachable(network_, start_.place, goal).position);
    }
    return path_of(*route);
  }

 private:
  void choose_ends() {
    if (request_.start) start_ = link("start", *request_.start);
    if (request_.goal) goal_ = link("goal", *request_.goal);
    if (!request_.start && !request_.goal) {
      const auto ends = far_ends(network_);
      start_ = take("start", ends->start, "node", "one of the largest part of the network");
      goal_ = take_far("goal", ends->goal, "start");
    } else if (!request_.goal) {
      goal_ = take_far("goal", farthest_from(network_, start_.place, false), "start");
    } else if (!request_.start) {
      start_ = take_far("start", farthest_from(network_, goal_.place, true), "goal");
    }
  }

  Link take_far(const char* which, const FarPlace& end, const char* other) const {
    if (end.across_ring) {
      return take(which, end.place, "place",
                  fmt::format("the far side of the ring on which the {} lies", other));
    }
    return take(which, end.place, "node",
                fmt::format("the one farthest from the {} by road", other));
  }

  Link take(const char* which, RoadPlace place, const char* what, const std::string& why) const {
    const Vector2 position = position_of(network_, place);
    say_(fmt::format("no {} is given: the {} at {} is taken, {}", which, what, text_of(position),
                     why));
    return {place, {position}};
  }

  Link link(const char* which, const std::vector<double>& numbers) const {
    const Vector2 point(numbers[0], numbers[1]);
    if (!std::isfinite(point.x()) || !std::isfinite(point.y()))
      throw Error(fmt::format("the {} is not a place: its coordinates must be finite", which));
    const auto places = nearest_places(network_, point, [](std::uint32_t) { return true; });
    const Vector2 nearest = places.front().position;
    if (grid_) {
      const Ground ground = grid_->ground_at(point);
      if (ground == Ground::kOffMap) refuse(which, point, "lies off the map", nearest);
      if (ground == Ground::kObstacle)
        refuse(which, point, "lies in an obstacle", nearest_drivable(point, places));
      if (ground == Ground::kUnknown)
        refuse(which, point, "lies where the map knows nothing", nearest_drivable(point, places));
    }
    if (places.front().distance > request_.snap_distance) {
      refuse(which, point,
             fmt::format("lies {:.1f} m from the nearest road, more than the snap_distance of "
                         "{:.1f} m",
                         places.front().distance, request_.snap_distance),
             nearest);
    }
    if (!grid_) return {places.front().place, {point, nearest}};
    auto found = link_to_road(*grid_, network_, point, places, request_.snap_distance);
    if (!found) {
      refuse(which, point,
             fmt::format("has no way through free ground to any road within the snap_distance of "
                         "{:.1f} m",
                         request_.snap_distance),
             nearest);
    }
    return *std::move(found);
  }

  /// The nearest free ground from which a road can be reached; a road's own place if none is near.
  Vector2 nearest_drivable(const Vector2& point, const std::vector<SnappedPlace>& places) const {
    const Cell cell = grid_->nearest_free(point, request_.snap_distance);
    if (!grid_->frame().contains(cell)) return places.front().position;
    const Vector2 centre = grid_->frame().centre(cell);
    const auto around = nearest_places(network_, centre, [](std::uint32_t) { return true; });
    const bool linked =
        link_to_road(*grid_, network_, centre, around, request_.snap_distance).has_value();
    return linked ? centre : places.front().position;
  }

  [[noreturn]] static void refuse(const char* which, const Vector2& point, const std::string& why,
                                  const Vector2& instead) {
    throw Error(fmt::format("the {} {} {}; the nearest reachable place is {}, {:.1f} m away", which,
                            text_of(point), why, text_of(instead), (instead - point).norm()));
  }

  Path path_of(const Route& route) const {
    Path path;
    std::vector<RoadVertex> line;
    append_link(line, start_, false);
    for (const RouteLeg& leg : route.legs) {
      append_leg(line, leg);
      path.edges.push_back(network_.graph().edges[leg.edge].id);
    }
    append_link(line, goal_, true);
    path.length = length_of(line);
    path.points = sample_path(line, request_.step, request_.smoothing);
    return path;
  }

  void append_link(std::vector<RoadVertex>& line, const Link& link, bool backward) const {
    constexpr double kFarthest = 20;  // metres: beyond it clearance does not matter to a link
    if (link.points.size() < 2) return;
    const double z = network_.at(link.place).z;
    // The last point is the place on the road, which the route itself brings.
    for (std::size_t i = 0; i + 1 < link.points.size(); ++i) {
      const Vector2& point = link.points[backward ? link.points.size() - 2 - i : i];
      const double clearance =
          grid_ ? grid_->clearance(point, kFarthest) : std::numeric_limits<double>::quiet_NaN();
      line.push_back({point.x(), point.y(), z, clearance});
    }
  }

  void append_leg(std::vector<RoadVertex>& line, const RouteLeg& leg) const {
    const RoadEdge& edge = network_.graph().edges[leg.edge];
    line.push_back(network_.at({leg.edge, leg.from}));
    for (std::uint32_t i = 0; i < edge.vertex_count; ++i) {
      const bool forward = leg.from <= leg.to;
      const std::uint32_t v = edge.first_vertex + (forward ? i : edge.vertex_count - 1 - i);
      const double along = network_.along(v);
      if (std::min(leg.from, leg.to) < along && along < std::max(leg.from, leg.to))
        line.push_back(network_.graph().vertices[v]);
    }
    line.push_back(network_.at({leg.edge, leg.to}));
  }

  const RoadNetwork& network_;
  std::optional<DrivableGrid> grid_;
  const PlanRequest& request_;
  const std::function<void(std::string_view)>& say_;
  Link start_, goal_;
};

}  // namespace

Path plan_path(const RoadGraph& roads, const OccupancyGrid* grid, const PlanRequest& request,
               const std::function<void(std::string_view)>& say) {
  if (roads.edges.empty())
    throw Error("the road graph has no roads, so there is no way to plan: is any of the map free?");
  const RoadNetwork network(roads, request.rules);
  if (!far_ends(network)) {
    throw Error(fmt::format(
        "none of the {} roads can be driven: all are closed or have less than the min_clearance of "
        "{:.2f} m",
        roads.edges.size(), request.rules.min_clearance));
  }
  return Planner(network, grid, request, say).plan();
}

}  // namespace stope::planner
