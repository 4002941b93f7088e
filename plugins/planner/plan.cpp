#include "plugins/planner/plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/far_ends.hpp"
#include "plugins/planner/grid_link.hpp"
#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/road_obstructions.hpp"
#include "plugins/planner/road_snap.hpp"
#include "plugins/planner/shortcut.hpp"
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
  Planner(const RoadNetwork& network, RoadRouter& router, const OccupancyGrid* grid,
          const PlanRequest& request, const std::function<void(std::string_view)>& say)
      : network_(network),
        router_(router),
        request_(request),
        say_(say),
        changes_(resolve(request.changes, network, request.snap_distance)) {
    if (grid) grid_.emplace(*grid);
  }

  Path plan() {
    choose_ends();
    return path_of(find_route());
  }

 private:
  /// The cheapest way whose roads the grid shows free: those of a way are looked at, what is
  /// obstructed is cut, and a way is sought again. As costs only rise, the first way without an
  /// obstruction is as cheap as if all roads had been looked at before.
  Route find_route() {
    std::size_t obstructed = 0;
    Vector2 first = Vector2::Zero();
    for (;;) {
      auto route = router_.find(start_.place, goal_.place, changes_);
      if (!route) refuse_way(obstructed, first);
      bool clear = true;
      for (const RouteLeg& leg : route->legs) {
        if (!grid_ || !request_.avoid_obstructed) break;
        const auto place = obstruction_on(*grid_, network_, leg, network_.rules().min_clearance);
        if (!place) continue;
        clear = false;
        changes_.cut(place->edge, place->along);
        if (obstructed++ == 0) first = position_of(network_, *place);
      }
      if (!clear) continue;
      if (obstructed > 0)
        say_(fmt::format("{} now, the first at {}: the way leads round", roads_text(obstructed),
                         text_of(first)));
      return *std::move(route);
    }
  }

  static std::string roads_text(std::size_t count) {
    return count == 1 ? "one road is obstructed" : fmt::format("{} roads are obstructed", count);
  }

  [[noreturn]] void refuse_way(std::size_t obstructed, const Vector2& first) const {
    const Vector2 goal = goal_.points.front();
    std::string why = "cannot be reached from the start by road";
    if (obstructed > 0)
      why += fmt::format(", as {} now, the first at {}", roads_text(obstructed), text_of(first));
    else if (!changes_.empty())
      why += " with the roads closed that closed_places and closed_roads name";
    refuse("goal", goal, why, useful_places("goal", goal).front().position);
  }

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
    const auto places = open_places(point);
    if (places.empty())
      throw Error("closed_roads names all roads that can be driven, so there is no way to plan");
    const auto nearest = [&] { return useful_places(which, point).front().position; };
    if (grid_) {
      const Ground ground = grid_->ground_at(point);
      if (ground == Ground::kOffMap) refuse(which, point, "lies off the map", nearest());
      if (ground == Ground::kObstacle)
        refuse(which, point, "lies in an obstacle", nearest_drivable(which, point));
      if (ground == Ground::kUnknown)
        refuse(which, point, "lies where the map knows nothing", nearest_drivable(which, point));
    }
    if (places.front().distance > request_.snap_distance) {
      refuse(which, point,
             fmt::format("lies {:.1f} m from the nearest road, more than the snap_distance of "
                         "{:.1f} m",
                         places.front().distance, request_.snap_distance),
             nearest());
    }
    if (!grid_) return {places.front().place, {point, places.front().position}};
    auto found = link_to_road(*grid_, network_, point, places, request_.snap_distance);
    if (!found) {
      refuse(which, point,
             fmt::format("has no way through free ground to any road within the snap_distance of "
                         "{:.1f} m",
                         request_.snap_distance),
             nearest());
    }
    return *std::move(found);
  }

  std::vector<SnappedPlace> open_places(const Vector2& point) const {
    return nearest_places(network_, point,
                          [this](std::uint32_t edge) { return !changes_.closed(edge); });
  }

  /// Places to offer instead of one that cannot be used: those that are of use with the query's
  /// other end, if there are any.
  std::vector<SnappedPlace> useful_places(const std::string& which, const Vector2& point) const {
    std::vector<SnappedPlace> places;
    if (which == "goal" && !start_.points.empty()) {
      places = reachable_places(network_, start_.place, false, point, changes_);
      if (places.empty()) {
        const Vector2 here = position_of(network_, start_.place);
        return {{start_.place, here, (point - here).norm()}};
      }
    } else if (which == "start" && request_.goal) {
      const auto goals = open_places(Vector2((*request_.goal)[0], (*request_.goal)[1]));
      if (goals.front().distance <= request_.snap_distance)
        places = reachable_places(network_, goals.front().place, true, point, changes_);
    }
    return places.empty() ? open_places(point) : places;
  }

  /// The nearest free ground from which a useful road can be reached; such a road's own place if
  /// none is near.
  Vector2 nearest_drivable(const char* which, const Vector2& point) const {
    const Vector2 on_road = useful_places(which, point).front().position;
    const Cell cell = grid_->nearest_free(point, request_.snap_distance);
    if (!grid_->frame().contains(cell)) return on_road;
    const Vector2 centre = grid_->frame().centre(cell);
    const auto around = useful_places(which, centre);
    const bool linked =
        link_to_road(*grid_, network_, centre, around, request_.snap_distance).has_value();
    return linked ? centre : on_road;
  }

  [[noreturn]] static void refuse(const char* which, const Vector2& point, const std::string& why,
                                  const Vector2& instead) {
    throw Error(fmt::format("the {} {} {}; the nearest reachable place is {}, {:.1f} m away", which,
                            text_of(point), why, text_of(instead), (instead - point).norm()));
  }

  Path path_of(const Route& route) {
    Path path;
    std::vector<RoadVertex> line = line_of(route);
    for (const RouteLeg& leg : route.legs)
      path.edges.push_back(network_.graph().edges[leg.edge].id);
    if (request_.shortcut) line = shortened(std::move(line), route);
    path.length = length_of(line);
    path.points = sample_path(line, request_.step, request_.smoothing);
    return path;
  }

  std::vector<RoadVertex> line_of(const Route& route) const {
    std::vector<RoadVertex> line;
    append_link(line, start_, false);
    for (const RouteLeg& leg : route.legs) append_leg(line, leg);
    append_link(line, goal_, true);
    return line;
  }

  /// The route, or another that is nearly as cheap, pulled straight through free ground.
  std::vector<RoadVertex> shortened(std::vector<RoadVertex> line, const Route& route) {
    constexpr int kAlternatives = 10;
    constexpr double kDearer = 1.2, kFarthest = 20;
    if (!grid_) {
      say_("shortcut needs a grid to see free ground in; without one the way follows the roads");
      return line;
    }
    std::vector<std::vector<RoadVertex>> lines{line};
    // What was driven is made dearer, so that the next way is another if one is nearly as good.
    RoadChanges changes = changes_;
    Route last = route;
    for (int i = 1; i < kAlternatives; ++i) {
      for (const RouteLeg& leg : last.legs)
        changes.raise(leg.edge, kDearer * changes.factor(leg.edge));
      auto other = router_.find(start_.place, goal_.place, changes);
      if (!other) break;
      last = *std::move(other);
      lines.push_back(line_of(last));
    }
    const auto points = shortcut_along(*grid_, lines, network_.rules().min_clearance);
    if (!points) return line;
    std::vector<RoadVertex> pulled;
    std::size_t nearest = 0;
    for (const Vector2& point : *points) {
      // Height comes from the road beside.
      const auto distance = [&](std::size_t i) {
        return std::hypot(line[i].x - point.x(), line[i].y - point.y());
      };
      for (std::size_t i = nearest + 1; i < line.size(); ++i)
        if (distance(i) < distance(nearest)) nearest = i;
      pulled.push_back({point.x(), point.y(), line[nearest].z, grid_->clearance(point, kFarthest)});
    }
    return pulled;
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
  RoadRouter& router_;
  std::optional<DrivableGrid> grid_;
  const PlanRequest& request_;
  const std::function<void(std::string_view)>& say_;
  RoadChanges changes_;
  Link start_, goal_;
};

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

Path RoadPlanner::plan(const OccupancyGrid* grid, const PlanRequest& request,
                       const std::function<void(std::string_view)>& say) {
  return Planner(network_, router_, grid, request, say).plan();
}

Path plan_path(const RoadGraph& roads, const OccupancyGrid* grid, const PlanRequest& request,
               const std::function<void(std::string_view)>& say) {
  return RoadPlanner(roads, request.rules).plan(grid, request, say);
}

}  // namespace stope::planner
