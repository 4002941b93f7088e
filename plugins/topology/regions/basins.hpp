#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// The basins of the clearance: the free cells from which going uphill ends at the same peak. A
/// basin has a number from 1 on, which it keeps as long as its peak is one; numbers may be unused.
class Basins {
 public:
  explicit Basins(const Ground& ground, const Checkpoint& checkpoint = never_stop);

  /// Become those of a ground that differs from before in the cells of some tiles. Names the tiles
  /// with cells that are in another basin now. Cost: linear in these tiles and in the cells that
  /// are uphill from nowhere but through them.
  void update(const Ground& ground, const TileSet& differs, TileSet& changed);

  /// Basin of each cell, 0 in obstacles.
  const PaddedGrid<std::int32_t>& cells() const { return cells_; }
  /// By number: the clearest cell, or 0 if the number is not used.
  const std::vector<CellIndex>& peaks() const { return peaks_; }

 private:
  void find_uphill(const Ground& ground, CellIndex first, std::int32_t count, std::uint8_t* uphill);
  std::int32_t new_number(CellIndex peak);

  PaddedGrid<std::uint8_t> uphill_;  ///< which of neighbour_steps leads uphill, or one of the below
  PaddedGrid<std::int32_t> cells_;
  std::vector<CellIndex> peaks_;
  std::vector<std::int32_t> unused_;
};

}  // namespace stope::topology
