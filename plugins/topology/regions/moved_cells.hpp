#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/regions/changed_squares.hpp"
#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// What a change has done to the cells of regions: where they differ, and which regions have
/// others than before.
class MovedCells {
 public:
  /// `squares` are those where the ground differs.
  explicit MovedCells(ChangedSquares squares) : squares_(std::move(squares)) {}

  /// A cell of region `before` is one of region `now`; 0 is none.
  void note(const Ground& ground, CellIndex cell, std::int32_t before, std::int32_t now) {
    if (before == now) return;
    squares_.add(ground.column(cell), ground.row(cell));
    note_name(before);
    note_name(now);
  }
  bool has_name(std::int32_t name) const {
    const auto place = static_cast<std::size_t>(name);
    return place < names_.size() && names_[place] != 0;
  }
  const ChangedSquares& squares() const { return squares_; }

 private:
  void note_name(std::int32_t name) {
    const auto place = static_cast<std::size_t>(name);
    if (place >= names_.size()) names_.resize(place + 1, 0);
    names_[place] = 1;
  }

  ChangedSquares squares_;
  std::vector<std::uint8_t> names_;
};

}  // namespace stope::topology
