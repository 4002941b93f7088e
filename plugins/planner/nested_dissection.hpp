#pragma once

#include <cstdint>
#include <functional>
#include <limits>
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

/// A part of a network that its own last nodes divide into two, by places in an order. No link
/// leads from one half to the other; those that leave the cell lead to own nodes of cells above.
struct Cell {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t first = 0, own = 0, end = 0;  ///< halves in [first, own), dividing nodes behind
  std::uint32_t parent = kNone;               ///< the cell of which it is a half
};

/// An order of the nodes in which those that part the graph into halves come last, before them
/// those that part the halves, and so on; and the cells in which they do. A cell comes after its
/// halves, the whole last. Cells of a few nodes are not divided: all of these are their own.
struct Dissection {
  std::vector<std::uint32_t> order;
  std::vector<Cell> cells;
};

/// `places` only guide it: any will do, good ones give small parts. The same on any number of
/// threads. See the .cpp for method and cost. Calls `pause` now and then on the caller's thread,
/// which may throw to give up.
Dissection dissect(const NeighbourLists& neighbours, std::span<const NodePlace> places,
                   const std::function<void()>& pause);

/// How many links the best straight line crosses that leaves at least a third of the nodes on
/// either side.
std::uint64_t least_crossing(const NeighbourLists& neighbours, std::span<const NodePlace> places);

}  // namespace stope::planner
