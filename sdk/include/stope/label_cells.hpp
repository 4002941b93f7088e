#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "stope/error.hpp"

namespace stope {

/// The label of each cell of a grid, row-major, row 0 lowest: an array of its own, or one that
/// costs a grid little where it is as an earlier one was. Then cells have names, in square tiles
/// that never change and belong to all who hold them, and a table says what label each name has:
/// labels that count the regions shift wherever one comes or goes, names need not. Both are encoded
/// as the vector of labels.
class LabelCells {
 public:
  static constexpr std::size_t kTileSide = 64;         ///< cells
  static constexpr std::size_t kTilesAcrossBlock = 4;  ///< and upward
  static constexpr std::size_t kBlockSide = kTileSide * kTilesAcrossBlock;
  /// Names of the cells of a square; past the grid's sides nobody reads.
  using Tile = std::array<std::int32_t, kTileSide * kTileSide>;
  /// Tiles of a square, null past the grid's sides. Shared as such: to count the holders of some
  /// thousand tiles that are far apart in memory takes milliseconds.
  using Block = std::array<std::shared_ptr<const Tile>, kTilesAcrossBlock * kTilesAcrossBlock>;
  using Blocks = std::vector<std::shared_ptr<const Block>>;

  LabelCells() = default;
  LabelCells(std::vector<std::int32_t> labels) : labels_(std::move(labels)) {}
  /// Blocks and what is in them are row-major too, row 0 lowest; each name is a place in
  /// `label_of_name`. Throws Error if there are not as many blocks as the grid has.
  LabelCells(std::int32_t width, std::int32_t height, Blocks blocks,
             std::vector<std::int32_t> label_of_name)
      : labels_(std::move(label_of_name)),
        width_(static_cast<std::size_t>(std::max(width, 0))),
        height_(static_cast<std::size_t>(std::max(height, 0))),
        blocks_(std::move(blocks)) {
    if (blocks_.empty() || blocks_.size() != blocks_along(width_) * blocks_along(height_))
      throw Error("shared labels need as many blocks as their grid has");
  }

  std::size_t size() const { return is_shared() ? width_ * height_ : labels_.size(); }
  bool empty() const { return size() == 0; }

  /// For a few cells here and there.
  std::int32_t operator[](std::size_t place) const {
    return is_shared() ? label(*run_at(place / width_, place % width_)) : labels_[place];
  }
  /// `count` labels from a place on: where they are, else written to `room`. Valid as long as both.
  std::span<const std::int32_t> read(std::size_t begin, std::size_t count,
                                     std::vector<std::int32_t>& room) const {
    if (!is_shared()) return std::span(labels_).subspan(begin, count);
    room.resize(count);
    write_to(room.data(), begin, count);
    return room;
  }
  /// Calls visit(labels) with all of them from the first on, in one piece if they are an array.
  template <class Visit>
  void for_each_piece(Visit visit) const {
    const std::size_t piece = is_shared() ? kPiece : size();
    std::vector<std::int32_t> room;
    for (std::size_t begin = 0; begin < size(); begin += piece)
      visit(read(begin, std::min(piece, size() - begin), room));
  }
  std::vector<std::int32_t> to_vector() const {
    if (!is_shared()) return labels_;
    std::vector<std::int32_t> all;
    read(0, size(), all);
    return all;
  }
  /// The labels to be changed: makes them an array of its own.
  std::vector<std::int32_t>& dense() {
    if (is_shared()) *this = LabelCells(to_vector());
    return labels_;
  }

  /// How many blocks there are along a side of so many cells.
  static constexpr std::size_t blocks_along(std::size_t cells) {
    return (cells + kBlockSide - 1) / kBlockSide;
  }

 private:
  static constexpr std::size_t kPiece = 16384;  ///< what an inner cache holds

  bool is_shared() const { return !blocks_.empty(); }
  std::int32_t label(std::int32_t name) const { return labels_[static_cast<std::size_t>(name)]; }
  /// The names from a cell on to where its tile ends.
  const std::int32_t* run_at(std::size_t row, std::size_t column) const {
    const Block& block = *blocks_[row / kBlockSide * blocks_along(width_) + column / kBlockSide];
    const std::size_t tile =
        row % kBlockSide / kTileSide * kTilesAcrossBlock + column % kBlockSide / kTileSide;
    return block[tile]->data() + row % kTileSide * kTileSide + column % kTileSide;
  }
  void write_to(std::int32_t* to, std::size_t begin, std::size_t count) const {
    std::size_t row = begin / width_, column = begin % width_;
    while (count > 0) {
      const std::size_t run = std::min({count, width_ - column, kTileSide - column % kTileSide});
      const std::int32_t* from = run_at(row, column);
      to = std::transform(from, from + run, to, [&](std::int32_t name) { return label(name); });
      count -= run;
      column += run;
      if (column == width_) column = 0, ++row;
    }
  }

  std::vector<std::int32_t> labels_;  ///< by cell, or if there are blocks by name
  std::size_t width_ = 0, height_ = 0;
  Blocks blocks_;
};

}  // namespace stope
