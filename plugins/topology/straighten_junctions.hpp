#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Lets roads meet where their own centre lines cross. In a junction the line that is equally far
/// from all obstacles bends towards every opening; within the junction's inscribed circle it is
/// replaced: the two roads that continue each other best are joined by a curve that keeps their
/// directions, and the others run straight to the place of that curve nearest to their own
/// continuations. Where no two roads continue each other (a fork), all run straight to the place
/// nearest to all continuations, in the sense of least squares. What is new stays within the
/// circle, so in free space; its distances to obstacles are lower bounds.
void straighten_junctions(LineNetwork& network);

}  // namespace stope::topology
