#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "stope/payloads/region_map.hpp"

namespace stope::exports {

/// A grid of labels taken apart into its connected pieces (8 neighbours), numbered as they begin in
/// a picture of it: from the top row down, from left to right.
struct RegionPieces {
  std::vector<std::int32_t> of_cell;  ///< by cell of the grid; -1: no region
  std::vector<std::uint32_t> region;  ///< by piece: place in RegionMap::regions
  std::vector<std::size_t> cells;     ///< by region
  /// Pairs of pieces that touch along a side or at a corner, lower first, in increasing order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts;
};

/// Throws Error where a cell's label is no region's.
RegionPieces region_pieces(const RegionMap& map);

}  // namespace stope::exports
