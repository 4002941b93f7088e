#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// The basins of the clearance: the free cells from which going uphill ends at the same peak. A
/// basin has a number from 1 on, which it keeps as long as its peak is one; numbers may be unused.
class Basins {
 public:
  /// `keep` is for those that are to be updated, and takes a byte a cell.
  explicit Basins(const Ground& ground, bool keep = false,
                  const Checkpoint& checkpoint = never_stop);

  /// Become those of a ground that differs from before in some squares. Adds those with cells that
  /// are in another basin now. Cost: linear in these squares and in the cells that are uphill from
  /// nowhere but through them.
  void update(const Ground& ground, const ChangedSquares& differs, ChangedSquares& changed);

  /// Basin of each cell, 0 in obstacles.
  const PaddedGrid<std::int32_t>& cells() const { return cells_; }
  PaddedGrid<std::int32_t> take_cells() && { return std::move(cells_); }
  /// By number: the clearest cell, or 0 if the number is not used.
  const std::vector<CellIndex>& peaks() const { return peaks_; }

 private:
  class Climb;  ///< finds the basins of a whole ground

  std::int32_t new_number(CellIndex peak);

  /// Which of neighbour_steps leads uphill, or that none does; of those that are kept.
  std::optional<PaddedGrid<std::uint8_t>> uphill_;
  PaddedGrid<std::int32_t> cells_;
  std::vector<CellIndex> peaks_;
  std::vector<std::int32_t> unused_;
};

}  // namespace stope::topology
