#pragma once

#include <algorithm>
#include <cstdint>
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
  std::vector<std::vector<CellIndex>> members;    ///< keys of their names, increasing
  std::vector<std::vector<CellIndex>> cut_off;    ///< … of those that are
  std::vector<std::vector<std::int32_t>> tiles;   ///< in which they have cells, increasing
  std::vector<std::vector<TileSquares>> squares;  ///< of each of those
  std::vector<std::int64_t> free_cells;
};

inline RegionParts parts_of_regions(const TileParts& tiles, const RegionSet& set) {
  RegionParts parts;
  const auto count = static_cast<std::size_t>(set.count);
  parts.members.resize(count);
  parts.cut_off.resize(count);
  parts.tiles.resize(count);
  parts.squares.resize(count);
  parts.free_cells.resize(count, 0);
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    for (const TilePart& part : tiles.parts(tile)) {
      const std::int32_t region = set.of(part.name);
      if (region == 0) continue;
      const auto place = static_cast<std::size_t>(region) - 1;
      parts.free_cells[place] += part.free_cells;
      auto& own = parts.tiles[place];
      auto& squares = parts.squares[place];
      if (own.empty() || own.back() != static_cast<std::int32_t>(tile)) {
        own.push_back(static_cast<std::int32_t>(tile));
        squares.push_back(0);
      }
      squares.back() |= part.squares;
    }
  }
  for (std::size_t name = 0; name < set.of_name.size(); ++name) {
    const std::int32_t region = set.of_name[name];
    if (region == 0) continue;
    const auto place = static_cast<std::size_t>(region) - 1;
    parts.members[place].push_back(set.key_of_name[name]);
    if (set.is_cut_off(static_cast<std::int32_t>(name)))
      parts.cut_off[place].push_back(set.key_of_name[name]);
  }
  for (auto& members : parts.members) std::sort(members.begin(), members.end());
  for (auto& members : parts.cut_off) std::sort(members.begin(), members.end());
  return parts;
}

}  // namespace stope::topology
