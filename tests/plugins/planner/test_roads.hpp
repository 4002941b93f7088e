#pragma once

#include <vector>

#include "stope/payloads/road_graph.hpp"
#include "stope/random.hpp"

namespace stope::planner {

/// Adds a road through the points and returns its place in graph.edges.
std::size_t add_road(RoadGraph& graph, std::uint32_t from, std::uint32_t to,
                     const std::vector<Vector2>& between = {}, double clearance = 5);

/// Nodes thrown into a square of 100 m, joined at random by bent roads, some one-way, some closed.
RoadGraph random_roads(Random& random, std::uint32_t nodes, std::uint32_t roads);

}  // namespace stope::planner
