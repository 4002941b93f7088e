#pragma once

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Lets roads meet where their own centre lines cross. In a junction the line that is equally far
/// from all obstacles bends towards every opening, up to where roads are no longer widened by the
/// junction's corners; from there on it is replaced. The two roads that continue each other best,
/// by direction and curvature, are joined by a curve that keeps their directions; the others run
/// straight to the place of that curve nearest to their own continuations. Where no two roads
/// continue each other (a fork), all run straight from the rim of the junction's circle to the
/// place nearest to all continuations, in the sense of least squares. What is new stays in circles
/// round the old lines that are free; its distances to obstacles are lower bounds.
void straighten_junctions(LineNetwork& network);

}  // namespace stope::topology
