#pragma once

#include <cstdint>
#include <vector>

namespace stope::planner {

/// No way. Two of these can be added without overflow.
inline constexpr std::uint32_t kNever = 0x7FFFFFFF;

/// Costs between the nodes of a cell, its own first, then those at its border: row by row.
using CostMatrix = std::vector<std::uint32_t>;

/// Lets ways between the nodes after each of the first `own_count` of `size` lead over it. Costs
/// are kNever or at most half of it. O(own_count * size^2).
void lead_over_own(std::uint32_t* costs, std::uint32_t own_count, std::uint32_t size);

/// True costs between a cell's nodes, whatever the way leads over: from a row's node, and to it.
struct TrueCosts {
  CostMatrix from, to;
};

/// Rows `up` and `down`: what links from and to each own node cost, over nodes before it. Those
/// that ways over a third node after it make needless become kNever; `truth`, known between the
/// nodes at the border (kNever from each node to itself), is completed. O(own_count * size^2).
void keep_needed(std::uint32_t* up, std::uint32_t* down, std::uint32_t own_count,
                 std::uint32_t size, TrueCosts& truth);

}  // namespace stope::planner
