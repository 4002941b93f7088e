#include "plugins/planner/plan_ends.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stope/error.hpp"

namespace stope::planner {
namespace {

[[noreturn]] void refuse(const char* which, const Vector2& point, const std::string& why,
                         const Vector2& instead) {
  throw Error(fmt::format("the {} {} {}; the nearest reachable place is {}, {:.1f} m away", which,
                          text_of_point(point), why, text_of_point(instead),
                          (instead - point).norm()));
}

}  // namespace

std::string text_of_point(const Vector2& point) {
  return fmt::format("({:.2f}, {:.2f})", point.x(), point.y());
}

Vector2 position_of(const RoadNetwork& network, RoadPlace place) {
  const RoadVertex vertex = network.at(place);
  return {vertex.x, vertex.y};
}

PlanEnds::PlanEnds(const RoadNetwork& network, const DrivableGrid* grid, const PlanRequest& request,
                   const RoadChanges& changes, const Say& say)
    : network_(network), grid_(grid), request_(request), changes_(changes), say_(say) {
  choose();
}

void PlanEnds::refuse_goal(const std::string& why) const {
  const Vector2 goal = goal_.points.front();
  refuse("goal", goal, why, useful_places("goal", goal).front().position);
}

void PlanEnds::choose() {
  const auto at = [this](RoadPlace place) { return Link{place, {position_of(network_, place)}}; };
  if (request_.start)
    start_ = link("start", *request_.start);
  else if (request_.start_place)
    start_ = at(*request_.start_place);
  if (request_.goal)
    goal_ = link("goal", *request_.goal);
  else if (request_.goal_place)
    goal_ = at(*request_.goal_place);
  const bool start_known = !start_.points.empty(), goal_known = !goal_.points.empty();
  if (!start_known && !goal_known) {
    const auto ends = far_ends(network_);
    start_ = take("start", ends->start, "node", "one of the largest part of the network");
    goal_ = take_far("goal", ends->goal, "start");
  } else if (!goal_known) {
    goal_ = take_far("goal", farthest_from(network_, start_.place, false), "start");
  } else if (!start_known) {
    start_ = take_far("start", farthest_from(network_, goal_.place, true), "goal");
  }
}

Link PlanEnds::take_far(const char* which, const FarPlace& end, const char* other) const {
  if (end.across_ring) {
    return take(which, end.place, "place",
                fmt::format("the far side of the ring on which the {} lies", other));
  }
  return take(which, end.place, "node", fmt::format("the one farthest from the {} by road", other));
}

Link PlanEnds::take(const char* which, RoadPlace place, const char* what,
                    const std::string& why) const {
  const Vector2 position = position_of(network_, place);
  say_(fmt::format("no {} is given: the {} at {} is taken, {}", which, what,
                   text_of_point(position), why));
  return {place, {position}};
}

Link PlanEnds::link(const char* which, const std::vector<double>& numbers) const {
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

std::vector<SnappedPlace> PlanEnds::open_places(const Vector2& point) const {
  return nearest_places(network_, point,
                        [this](std::uint32_t edge) { return !changes_.closed(edge); });
}

/// Places to offer instead of one that cannot be used: those that are of use with the query's
/// other end, if there are any.
std::vector<SnappedPlace> PlanEnds::useful_places(const std::string& which,
                                                  const Vector2& point) const {
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
Vector2 PlanEnds::nearest_drivable(const char* which, const Vector2& point) const {
  const Vector2 on_road = useful_places(which, point).front().position;
  const Cell cell = grid_->nearest_free(point, request_.snap_distance);
  if (!grid_->frame().contains(cell)) return on_road;
  const Vector2 centre = grid_->frame().centre(cell);
  const auto around = useful_places(which, centre);
  const bool linked =
      link_to_road(*grid_, network_, centre, around, request_.snap_distance).has_value();
  return linked ? centre : on_road;
}

}  // namespace stope::planner
