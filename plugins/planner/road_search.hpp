#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// A piece of a route: an edge driven from one place of it to another; backward where from > to.
struct RouteLeg {
  std::uint32_t edge = 0;
  double from = 0, to = 0;
};

struct Route {
  std::vector<RouteLeg> legs;
  double cost = 0;
};

/// The cheapest way from one place to another, respecting directions; none if there is no way. The
/// two places split their edges virtually; several equal ways are told apart by node numbers.
std::optional<Route> find_route(const RoadNetwork& network, RoadPlace start, RoadPlace goal);

/// The cost of driving from `start` to each node, infinite where there is no way. `against` turns
/// all directions round: the cost from each node to `start`.
std::vector<double> costs_from(const RoadNetwork& network, RoadPlace start, bool against = false);

}  // namespace stope::planner
