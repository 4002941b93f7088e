#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Makes one node of two junctions whose line between them is shorter than `share` times the
/// smaller of their distances to the obstacle: roads that cross in one inscribed circle meet in one
/// place. The new node lies in the middle of that line. Lines between two junctions that another
/// line joins as well stay, so that every cycle keeps its shape.
void merge_junctions(LineNetwork& network, double share);

}  // namespace stope::topology
