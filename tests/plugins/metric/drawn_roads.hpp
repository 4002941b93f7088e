#pragma once

#include <string>
#include <vector>

#include "stope/payloads/measures.hpp"
#include "stope/payloads/road_graph.hpp"
#include "stope/random.hpp"

namespace stope::metric {

/// Roads drawn through points; those that begin or end at the same point share a node.
RoadGraph draw_roads(const std::vector<std::vector<Vector2>>& lines);

/// Straight and bent roads between points thrown into a square of `size` metres.
RoadGraph random_roads(Random& random, int nodes, int roads, double size);

/// A figure by its name. Fails the test and is NaN if there is none.
double value_of(const Measures& measures, const std::string& name);

}  // namespace stope::metric
