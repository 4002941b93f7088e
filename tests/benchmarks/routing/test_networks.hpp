#pragma once

#include <cstdint>
#include <vector>

#include "plugins/planner/nested_dissection.hpp"
#include "plugins/planner/search_graph.hpp"

namespace stope::planner {

/// A directed graph to route on, with places for its nodes (for searches that ask them).
struct TestNetwork {
  std::vector<double> x, y;  // metres
  std::vector<ArcBetween> arcs;
  std::vector<NodePlace> places() const;
  SearchGraph graph() const { return {static_cast<std::uint32_t>(x.size()), arcs}; }
};

/// A lattice of side x side nodes 10 m apart, joined to the four next ones both ways. The cost of a
/// piece is 1000 times its length, times a random number from 1 to `spread`, the same both ways.
TestNetwork lattice(std::uint32_t side, double spread, std::uint64_t seed);

/// A planar network like that of a country's roads: see test_networks.cpp.
TestNetwork road_like(std::uint32_t side, std::uint64_t seed);

}  // namespace stope::planner
