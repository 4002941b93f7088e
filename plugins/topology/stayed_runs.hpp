#pragma once

#include <vector>

#include "plugins/topology/number_outlines.hpp"

namespace stope::topology {

/// Whether a ring is an outline as it was.
bool stays(const OutlineRing& ring, const NamedOutlines& outlines);

/// The runs of edges that were in a row before the outlines became these rings, whose places in the
/// list stand for those of the outlines. `outlines` still has the numbers of before, -1 of new
/// edges. Cost: linear in the rings' breaks.
std::vector<StayedRun> find_stayed_runs(const std::vector<OutlineRing>& rings,
                                        const NamedOutlines& outlines);

}  // namespace stope::topology
