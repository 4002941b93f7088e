#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plugins/export/region_pieces.hpp"

namespace stope::exports {

/// Hues, evenly spaced around the circle, such that no two pieces that touch have the same.
struct RegionColours {
  int hues = 6;                        ///< 6, 12 or 18
  std::vector<std::uint8_t> of_piece;  ///< 0 … hues-1, in steps of 360/hues degrees from red
  std::vector<std::uint8_t> of_region;
};

/// Colours regions so that those which touch (also at a corner) or are adjacent by the map's own
/// list differ as much as few hues allow. Where regions of many pieces make that impossible, pieces
/// are coloured one by one: those that touch still differ.
RegionColours colour_regions(const RegionMap& map, const RegionPieces& pieces);

}  // namespace stope::exports
