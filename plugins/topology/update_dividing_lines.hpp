#pragma once

#include <vector>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/named_outlines.hpp"
#include "plugins/topology/tile_set.hpp"

namespace stope::topology {

/// Brings the marks of dividing lines up to date, with the result that find_dividing_lines has.
///
/// `edges` holds the nearest edges of all cells as they are now, by name: what `replaced` says was
/// replaced before is undone, and `replacement` (of the same cells) says by what. `rule` knows
/// edges by number. Cells in other tiles than the `stale` ones, or at their border, see what they
/// saw, and are divided from their neighbours as they were. Sets `replaced` to what is replaced
/// now, adds to `touched` the tiles with corners where marks or what the cells around see are
/// others than before, as far as that is not known already. Cost: linear in the stale tiles' area,
/// and n log n in the number of cells that are cut off.
void update_dividing_lines(FreeSpace& space, const NamedOutlines& outlines, const SideRule& rule,
                           EdgeGrid& edges, const TileSet& stale,
                           const std::vector<OutlineEdge>& replacement,
                           std::vector<ReplacedEdge>& replaced, TileSet& touched);

}  // namespace stope::topology
