#pragma once

#include <vector>

#include "plugins/topology/dividing_lines.hpp"

namespace stope::topology {

/// All divides between two free cells, by place, the one to the east before that to the north.
/// Cost: two subtractions a free cell.
std::vector<Divide> find_divides_between_free_cells(const FreeSpace& space,
                                                    const Outlines& outlines, const SideRule& rule,
                                                    const EdgeGrid& edges,
                                                    const Checkpoint& checkpoint);

}  // namespace stope::topology
