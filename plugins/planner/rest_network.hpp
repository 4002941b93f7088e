#pragma once

#include <span>
#include <vector>

#include "plugins/planner/nested_dissection.hpp"
#include "plugins/planner/node_contraction.hpp"

namespace stope::planner {

/// The nodes that a contraction has not taken out yet, numbered anew from 0.
struct RestNetwork {
  std::vector<std::uint32_t> nodes;      ///< of each number
  std::vector<std::uint32_t> number_of;  ///< of each node that is left
  NeighbourLists neighbours;
  std::vector<NodePlace> places;
};

/// `taken` are the nodes that are gone, `places` those of all nodes.
RestNetwork rest_of(const NodeContraction& contraction, std::span<const NodePlace> places,
                    std::span<const std::uint32_t> taken);

/// Whether about as many links join the halves of a network as join those of a grid.
bool is_grid_like(const RestNetwork& rest);

}  // namespace stope::planner
