#include "plugins/map_source/colour_pieces.hpp"

#include <algorithm>

namespace stope::map_source {

ColourPieces colour_pieces(const std::vector<std::int16_t>& hues, std::int32_t width,
                           std::int32_t height) {
  ColourPieces pieces;
  pieces.of_pixel.assign(hues.size(), -1);
  std::vector<std::size_t> open;
  const auto columns = static_cast<std::size_t>(width);
  for (std::size_t start = 0; start < hues.size(); ++start) {
    if (hues[start] < 0 || pieces.of_pixel[start] >= 0) continue;
    const auto piece = static_cast<std::int32_t>(pieces.hue.size());
    pieces.hue.push_back(hues[start]);
    pieces.first.push_back(start);
    pieces.of_pixel[start] = piece;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const auto column = static_cast<std::int32_t>(at % columns);
      const auto row = static_cast<std::int32_t>(at / columns);
      for (std::int32_t y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y) {
        for (std::int32_t x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x) {
          const std::size_t next =
              static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x);
          if (hues[next] != hues[start] || pieces.of_pixel[next] >= 0) continue;
          pieces.of_pixel[next] = piece;
          open.push_back(next);
        }
      }
    }
  }
  return pieces;
}

}  // namespace stope::map_source
