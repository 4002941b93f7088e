// Problem: the grid of today shows obstacles on roads that the graph thinks open.
// Idea: only the roads of a way found are looked at; what is obstructed is cut, and a way is sought
// again. As costs only rise, the first way without an obstruction is as cheap as if all roads had
// been looked at before.
// Cost: a search for each obstruction met, and the cells along the roads driven.
#include "plugins/planner/unobstructed_route.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "plugins/planner/road_obstructions.hpp"

namespace stope::planner {
namespace {

std::string roads_text(std::size_t count) {
  return count == 1 ? "one road is obstructed" : fmt::format("{} roads are obstructed", count);
}

[[noreturn]] void refuse_way(const PlanEnds& ends, const RoadChanges& changes,
                             std::size_t obstructed, const Vector2& first) {
  std::string why = "cannot be reached from the start by road";
  if (obstructed > 0)
    why +=
        fmt::format(", as {} now, the first at {}", roads_text(obstructed), text_of_point(first));
  else if (!changes.empty())
    why += " with the roads closed that closed_places and closed_roads name";
  ends.refuse_goal(why);
}

}  // namespace

Route unobstructed_route(RoadRouter& router, const RoadNetwork& network, const DrivableGrid* grid,
                         const PlanEnds& ends, RoadChanges& changes, const Say& say) {
  std::size_t obstructed = 0;
  Vector2 first = Vector2::Zero();
  for (;;) {
    auto route = router.find(ends.start().place, ends.goal().place, changes);
    if (!route) refuse_way(ends, changes, obstructed, first);
    bool clear = true;
    for (const RouteLeg& leg : route->legs) {
      if (!grid) break;
      const auto place = obstruction_on(*grid, network, leg, network.rules().min_clearance);
      if (!place) continue;
      clear = false;
      changes.cut(place->edge, place->along);
      if (obstructed++ == 0) first = position_of(network, *place);
    }
    if (!clear) continue;
    if (obstructed > 0)
      say(fmt::format("{} now, the first at {}: the way leads round", roads_text(obstructed),
                      text_of_point(first)));
    return *std::move(route);
  }
}

}  // namespace stope::planner
