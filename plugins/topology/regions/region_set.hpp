#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plugins/topology/regions/tile_parts.hpp"

namespace stope::topology {

/// Regions as sets of the names that cells have. Regions count from 1; a name of none has 0.
struct RegionSet {
  std::int32_t count = 0;
  std::vector<std::int32_t> of_name;
  /// By name: a cell that tells which it is, also after a change of the map.
  std::vector<CellIndex> key_of_name;
  /// By name, or none at all: whether only ways too narrow for roads join it with the rest of its
  /// region. Those that are have no other wide way out.
  std::vector<std::uint8_t> cut_off = {};
  /// Whether all free cells of a name are in one piece of free space.
  bool in_one_piece = true;

  bool is_cut_off(std::int32_t name) const {
    return !cut_off.empty() && cut_off[static_cast<std::size_t>(name)] != 0;
  }
  std::int32_t of(std::int32_t name) const { return of_name[static_cast<std::size_t>(name)]; }
};

/// What regions 1 … count consist of.
struct RegionParts {
  std::vector<std::vector<std::int32_t>> names;  ///< increasing
  std::vector<std::vector<CellIndex>> members;   ///< the names' keys, increasing
  std::vector<std::vector<CellIndex>> cut_off;   ///< … of those that are
  std::vector<std::int64_t> free_cells;

  /// In which tiles a region has cells, increasing.
  std::vector<std::int32_t> tiles_of(const TileParts& tiles, std::size_t region) const;

  /// Leaves out the regions, by place, that are not `wanted`.
  template <class Wanted>
  void keep(Wanted wanted) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!wanted(i)) continue;
      if (kept != i) {
        names[kept] = std::move(names[i]);
        members[kept] = std::move(members[i]);
        cut_off[kept] = std::move(cut_off[i]);
        free_cells[kept] = free_cells[i];
      }
      ++kept;
    }
    names.resize(kept);
    members.resize(kept);
    cut_off.resize(kept);
    free_cells.resize(kept);
  }
};

RegionParts parts_of_regions(const TileParts& tiles, const RegionSet& set);

}  // namespace stope::topology
