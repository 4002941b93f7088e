#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Makes one node of two junctions whose line between them is shorter than `share` times the
/// smaller of their distances to the obstacle: roads that cross in one inscribed circle meet in one
/// place. The new node lies in the middle of that line. Lines between two junctions that another
/// line joins as well stay, so that every cycle keeps its shape. The lines that meet in it leave it
/// straight, from where they pass the places of the two; with `to_rim`, from where they pass the
/// rim of its inscribed circle.
void merge_junctions(LineNetwork& network, double share, bool to_rim = false);

}  // namespace stope::topology
