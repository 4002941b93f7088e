#pragma once

#include <cstdint>
#include <vector>

namespace stope::map_source {

/// A picture of hues taken apart into connected pieces (8 neighbours) of one hue, numbered as they
/// begin: from the top row down, from left to right.
struct ColourPieces {
  std::vector<std::int32_t> of_pixel;  ///< -1: no hue
  std::vector<std::int16_t> hue;       ///< by piece
  std::vector<std::uint64_t> first;    ///< by piece: its first pixel
};

/// `hues` is row-major, row 0 at the top; -1 is no hue.
ColourPieces colour_pieces(const std::vector<std::int16_t>& hues, std::int32_t width,
                           std::int32_t height);

}  // namespace stope::map_source
