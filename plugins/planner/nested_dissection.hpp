#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stope::planner {

/// Where a node lies, in any unit.
struct NodePlace {
  float x = 0, y = 0;
};

/// Neighbours of each node, both ways, in two flat arrays.
struct NeighbourLists {
  std::vector<std::uint32_t> first;  // node count + 1
  std::vector<std::uint32_t> nodes;
  std::span<const std::uint32_t> of(std::uint32_t node) const {
    return std::span(nodes).subspan(first[node], first[node + 1] - first[node]);
  }
};

/// An order of the nodes in which those that part the graph into halves come last, before them
/// those that part the halves, and so on. `places` only guide it: any will do, good ones give small
/// parts. See the .cpp for method and cost.
std::vector<std::uint32_t> dissection_order(const NeighbourLists& neighbours,
                                            std::span<const NodePlace> places);

}  // namespace stope::planner
