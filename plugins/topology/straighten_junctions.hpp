#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Lets roads meet where their own centre lines cross. In a junction the line that is equally far
/// from all obstacles bends towards every opening; within the junction's inscribed circle it is
/// replaced by straight pieces to the place that is nearest to the continuations of all roads, in
/// the sense of least squares. Everything stays within the circle, so in free space.
void straighten_junctions(LineNetwork& network);

}  // namespace stope::topology
