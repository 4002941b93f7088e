#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/trace_lines.hpp"

namespace stope::topology {

/// Lines that hang together.
struct LineGroup {
  std::int32_t piece = 0;          ///< of free space, by any number
  std::vector<CellIndex> corners;  ///< that they pass, some more than once
};

/// Links that make one of all groups of a piece. Cost: for each group but one of a piece, a search
/// through the cells around it up to the next one.
std::vector<Link> link_groups(const FreeSpace& space, const Outlines& outlines,
                              const EdgeGrid& edges, std::vector<LineGroup> groups,
                              const Checkpoint& checkpoint);

}  // namespace stope::topology
