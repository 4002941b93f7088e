#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "framework/report/picture.hpp"
#include "stope/label_cells.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::report {

/// The longer side of a picture is at most this.
inline constexpr int kLongestSide = 1400;

/// How a grid of `width` x `height` cells becomes a picture: a pixel a cell if it is small, else
/// each pixel stands for a block of cells. Row 0 of the picture is the top.
struct Blocks {
  int columns = 0, rows = 0;  ///< of the grid
  int picture_width = 0, picture_height = 0;

  explicit Blocks(const GridFrame& frame, int longest = kLongestSide);
  /// First cell of a pixel column, and of the one after it.
  int column_begin(int pixel) const { return scaled(pixel, columns, picture_width); }
  /// Of the picture's row from the top: the lowest row of cells in it, and one above the highest.
  int row_begin(int pixel) const {
    return scaled(picture_height - 1 - pixel, rows, picture_height);
  }
  int row_end(int pixel) const { return scaled(picture_height - pixel, rows, picture_height); }
  /// Every how many rows of cells are looked at, so that the cost stays near that of the picture.
  int row_step(int pixel) const { return std::max(1, (row_end(pixel) - row_begin(pixel)) / 4); }

 private:
  static int scaled(int pixel, int cells, int pixels) {
    return static_cast<int>(static_cast<std::int64_t>(pixel) * cells / pixels);
  }
};

/// Cells of a grid from a place on: where they are, else written to `room`.
template <class Cell>
std::span<const Cell> cells_at(const std::vector<Cell>& cells, std::size_t begin, std::size_t count,
                               std::vector<Cell>&) {
  return std::span(cells).subspan(begin, count);
}
inline std::span<const std::int32_t> cells_at(const LabelCells& cells, std::size_t begin,
                                              std::size_t count, std::vector<std::int32_t>& room) {
  return cells.read(begin, count, room);
}

/// Draws a grid; each pixel is the mean colour of its cells, weighted by opacity.
template <class Cells, class ColourOf>
Picture grid_picture(const GridFrame& frame, const Cells& cells, ColourOf&& colour_of) {
  using Cell = std::decay_t<decltype(cells[0])>;
  const Blocks blocks(frame);
  Picture picture{blocks.picture_width, blocks.picture_height, {}};
  picture.pixels.resize(static_cast<std::size_t>(picture.width) *
                        static_cast<std::size_t>(picture.height));
  std::vector<std::span<const Cell>> rows;
  std::vector<std::vector<Cell>> rooms;
  for (int y = 0; y < picture.height; ++y) {
    rows.clear();
    for (int row = blocks.row_begin(y); row < blocks.row_end(y); row += blocks.row_step(y)) {
      if (rooms.size() == rows.size()) rooms.emplace_back();
      rows.push_back(cells_at(cells, frame.place({0, row}), static_cast<std::size_t>(frame.width),
                              rooms[rows.size()]));
    }
    for (int x = 0; x < picture.width; ++x) {
      std::array<std::uint64_t, 3> sum{};
      std::uint64_t opacity = 0, count = 0;
      for (const std::span<const Cell> row : rows) {
        const Cell* cell = row.data() + blocks.column_begin(x);
        const Cell* const end = row.data() + blocks.column_begin(x + 1);
        for (; cell != end; ++cell, ++count) {
          const Colour colour = colour_of(*cell);
          for (std::size_t k = 0; k < 3; ++k) sum[k] += std::uint64_t{colour[k]} * colour[3];
          opacity += colour[3];
        }
      }
      if (opacity == 0) continue;
      Colour& pixel = picture.at(x, y);
      for (std::size_t k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>((sum[k] + opacity / 2) / opacity);
      pixel[3] = static_cast<std::uint8_t>((opacity + count / 2) / count);
    }
  }
  return picture;
}

/// `4 216 × 2 591 cells of 0.5 m, 2.11 × 1.30 km`.
std::string grid_size_text(const GridFrame& frame);

/// Whether a grid has cells and as many as its frame says; a sketch of another would read beyond
/// its end.
template <class Grid>
bool is_whole(const Grid& grid) {
  return grid.frame.width > 0 && grid.frame.height > 0 && grid.cells.size() == grid.frame.size();
}

}  // namespace stope::report
