#pragma once

#include "plugins/topology/extraction_method.hpp"
#include "plugins/topology/named_outlines.hpp"
#include "plugins/topology/seen_from.hpp"

namespace stope::topology {

/// Where a method's rule can tell that outlines have changed: names the tiles with all neighbouring
/// cells that see the edges they saw but may be divided now if they were not, or no longer.
/// `outlines` and `rule` are those of now. Leaves out cells that were given a neighbour's edge.
/// Cost: linear in the edges of which the change is felt and, where outlines were joined or split,
/// in all of them but the largest part's.
void add_tiles_of_felt_changes(const ExtractionMethod& method, const NamedOutlines& outlines,
                               const DividingRule& rule, const OutlineChange& change,
                               const SeenFrom& seen, TileSet& tiles);

}  // namespace stope::topology
