#pragma once

#include <cstdint>
#include <vector>

namespace stope::planner {

/// Links between the nodes of two sides, each side numbered from 0.
struct TwoSides {
  std::vector<std::uint32_t> first{0};  ///< of each left node among `right`; left count + 1
  std::vector<std::uint32_t> right;     ///< the right node of each link
  std::uint32_t right_count = 0;
};

/// Nodes of both sides.
struct Cover {
  std::vector<bool> left, right;
};

/// The fewest nodes that touch all links. O(left nodes * links) at worst.
Cover least_cover(const TwoSides& links);

}  // namespace stope::planner
