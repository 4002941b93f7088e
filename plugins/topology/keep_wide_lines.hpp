#pragma once

#include <vector>

#include "plugins/topology/line_network.hpp"
#include "plugins/topology/trace_lines.hpp"

namespace stope::topology {

/// Keeps of each piece of a network the steps that are not narrow and, where that would tear them
/// apart, the narrow ones between them; all others lie on branches, which are cut. Steps that are
/// not narrow but hang together with at most `few` of their kind, without a cycle, do not count,
/// unless they are the most of their piece: a bay in a slot is no road. Of a piece that is narrow
/// everywhere one node is left, at its widest place.
///
/// `narrow` tells the narrow steps of each line, as ConnectedLines does; cycles have none. Pieces
/// and cycles stay. Cost: linear in the lines.
void keep_wide_lines(LineNetwork& network, const std::vector<std::vector<StepRange>>& narrow,
                     std::int32_t few);

}  // namespace stope::topology
