#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/padded_grid.hpp"
#include "plugins/topology/regions/changed_squares.hpp"
#include "stope/label_cells.hpp"

namespace stope::topology {

/// The names of a map's cells as payloads share them. What a payload has stays as it is: after a
/// change there are new tiles where names differ.
class SharedNames {
 public:
  SharedNames(const PaddedGrid<std::int32_t>& names, const Checkpoint& checkpoint);

  /// Become those of `names`, which differ from before in `changed` squares only. If the checkpoint
  /// throws, some are and some are not.
  void update(const PaddedGrid<std::int32_t>& names, const ChangedSquares& changed,
              const Checkpoint& checkpoint);

  /// The cells' labels. Cost: a pointer for each block of tiles.
  LabelCells labelled(std::vector<std::int32_t> label_of_name) const;

 private:
  /// Some tiles of a block, as bits.
  using TileBits = std::uint16_t;
  static_assert(std::tuple_size_v<LabelCells::Block> == 16);

  void renew(const PaddedGrid<std::int32_t>& names, std::size_t place, TileBits tiles);

  std::int32_t width_, height_;
  std::size_t blocks_across_;
  LabelCells::Blocks blocks_;
};

}  // namespace stope::topology
