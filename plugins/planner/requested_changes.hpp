#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// What an operator says of the roads today.
struct RequestedChanges {
  std::vector<double> closed_places;      ///< [x, y, x, y, …], metres: no passing there
  std::vector<std::string> closed_roads;  ///< ids of road edges, decimal
  std::vector<double> slow_places;  ///< [x, y, factor, …]: the road there costs factor times
  /// How many of a graph's roads, from the first on, can be meant: those behind were added since.
  std::size_t known_roads = std::numeric_limits<std::size_t>::max();
};

/// Finds the roads that are meant: the one nearest to each place, no farther than `most` metres,
/// and those with the ids. A closed place also closes the other roads that pass within
/// closed_reach() of where the nearest road is, which `say` is told: at a junction all of its
/// roads. Throws Error for what cannot be meant; the sentence names the nearest.
RoadChanges resolve(
    const RequestedChanges& requested, const RoadNetwork& network, double most,
    const std::function<void(std::string_view)>& say = [](std::string_view) {});

/// Metres around a closed place within which roads are closed: half of the clearance there, at
/// least half a metre.
double closed_reach(double clearance);

}  // namespace stope::planner
