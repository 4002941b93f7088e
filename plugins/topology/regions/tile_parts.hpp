#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/topology/regions/ground.hpp"
#include "plugins/topology/tile_set.hpp"

namespace stope::topology {

/// Cells of a region (or of what regions are made of) within a tile.
struct TilePart {
  std::int32_t name = 0;
  std::uint16_t free_cells = 0;
  TileSquares squares = 0;  ///< in which it has cells, free or not
  std::int32_t widest = 0;  ///< squared clearance
};

/// Where two regions touch. `low` and `high` are the neighbouring cells, one in each, of which the
/// lower one is clearest: `low` is the one that is not uphill of the other.
struct Contact {
  std::int32_t a = 0, b = 0;  ///< the lower name first
  std::int32_t steps = 0;     ///< pairs of neighbouring cells
  std::int32_t squared = 0;   ///< squared clearance of `low`
  CellIndex low = 0, high = 0;
};

/// Whether the cells of a contact are a better way through than those of another; a strict order
/// of all pairs of neighbouring cells of a grid, whatever regions are called.
inline bool is_clearer(const Contact& x, const Contact& y) {
  if (x.squared != y.squared) return x.squared > y.squared;
  return x.low != y.low ? x.low < y.low : x.high < y.high;
}

/// Which regions have cells in each tile of a grid, and touch there: all that is asked of cells to
/// merge, measure and connect regions, so that after a change only some tiles are looked at.
class TileParts {
 public:
  TileParts(std::int32_t width, std::int32_t height) : tiles_(TileSet(width, height).size()) {}

  /// Looks at some tiles anew, side by side. `names` of 0 are no region. Contacts across a tile's
  /// upper and right side are in it, those across the lower and left side in the tile beyond.
  void look_at(const Ground& ground, const PaddedGrid<std::int32_t>& names,
               const std::vector<std::int32_t>& tiles, const Checkpoint& checkpoint);

  std::size_t size() const { return tiles_.size(); }
  const std::vector<TilePart>& parts(std::size_t tile) const { return tiles_[tile].parts; }
  const std::vector<Contact>& contacts(std::size_t tile) const { return tiles_[tile].contacts; }
  /// How many free cells of a tile have no name.
  std::int32_t nameless(std::size_t tile) const { return tiles_[tile].nameless; }
  /// In which tiles a name has cells, increasing, and how many of them are free.
  std::span<const std::int32_t> tiles_of(std::int32_t name) const {
    const auto place = static_cast<std::size_t>(name);
    return place < tiles_of_.size() ? tiles_of_[place] : std::span<const std::int32_t>();
  }
  std::int64_t free_cells_of(std::int32_t name) const {
    const auto place = static_cast<std::size_t>(name);
    return place < free_cells_of_.size() ? free_cells_of_[place] : 0;
  }

 private:
  void forget(std::int32_t tile);
  void remember(std::int32_t tile);

  struct Tile {
    std::vector<TilePart> parts;
    std::vector<Contact> contacts;
    std::int32_t nameless = 0;
  };
  std::vector<Tile> tiles_;
  std::vector<std::vector<std::int32_t>> tiles_of_;  ///< by name
  std::vector<std::int64_t> free_cells_of_;          ///< by name
};

/// All tiles of a grid.
std::vector<std::int32_t> all_tiles(const Ground& ground);

/// The tiles whose parts and contacts can be others after cells of some squares have changed.
inline std::vector<std::int32_t> tiles_that_see(const ChangedSquares& changed) {
  return changed.widened(1).tiles();
}

}  // namespace stope::topology
