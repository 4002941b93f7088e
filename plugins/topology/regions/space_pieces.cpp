// Problem: regions that do not touch may lie in one piece of free space or in several.
// Idea: names that touch are in one piece, and so are names and cells without a name beside them,
// of which there are few. Where there are many: runs of free cells in a row, joined with those of
// the row before that they touch.
// Cost: linear in the contacts and the tiles with such cells; by rows, one look at every cell.
#include "plugins/topology/regions/space_pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

struct Run {
  std::int32_t begin = 0, end = 0;  ///< columns, the end is beyond
  std::int32_t number = 0;
};

constexpr std::size_t kCellsForANameless = 1000;

/// The free cells that have no name, in increasing order.
std::vector<CellIndex> nameless_cells(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                      const TileParts& tiles) {
  const TileSet geometry(ground.width(), ground.height());
  std::vector<CellIndex> cells;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    if (tiles.nameless(tile) == 0) continue;
    geometry.for_each_row(static_cast<std::int32_t>(tile), [&](CellIndex first, auto count) {
      for (CellIndex cell = first; cell < first + count; ++cell)
        if (names[cell] == 0 && ground.free(cell)) cells.push_back(cell);
    });
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// How many of the sets that the first members are in have one of them that counts.
std::size_t count_sets(DisjointSets& sets, std::size_t members, auto counts) {
  std::vector<std::uint8_t> counted(sets.size(), 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < members; ++i) {
    if (!counts(i)) continue;
    auto& set = counted[static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(i)))];
    count += set ? 0U : 1U;
    set = 1;
  }
  return count;
}

}  // namespace

std::size_t count_space_pieces(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const TileParts& tiles, const std::vector<Contact>& contacts,
                               const RegionSet& set, const Checkpoint& checkpoint) {
  std::size_t nameless = 0;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    nameless += static_cast<std::size_t>(tiles.nameless(tile));
  if (!set.in_one_piece || nameless > ground.size() / kCellsForANameless)
    return count_pieces_by_rows(ground, names, set, checkpoint);
  const std::vector<CellIndex> cells = nameless_cells(ground, names, tiles);
  // Names, and then those cells.
  const std::size_t named = set.of_name.size();
  DisjointSets pieces(named + cells.size());
  for (const Contact& contact : contacts) pieces.join(contact.a, contact.b);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const CellIndex step : neighbour_steps(ground.stride())) {
      const CellIndex there = cells[i] + step;
      if (!ground.free(there)) continue;
      const auto at = std::lower_bound(cells.begin(), cells.end(), there) - cells.begin();
      pieces.join(static_cast<std::int32_t>(named + i),
                  names[there] != 0
                      ? names[there]
                      : static_cast<std::int32_t>(named) + static_cast<std::int32_t>(at));
    }
  }
  return count_sets(pieces, named, [&](std::size_t name) { return set.of_name[name] != 0; });
}

std::size_t count_pieces_by_rows(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                 const RegionSet& set, const Checkpoint& checkpoint) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;  // numbers of runs
  std::vector<std::uint8_t> has_region;                         // by number
  std::vector<Run> before, runs;
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    std::swap(before, runs);
    runs.clear();
    std::size_t below = 0;
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      if (!ground.free(ground.index(column, row))) continue;
      Run run{column, column, static_cast<std::int32_t>(has_region.size())};
      has_region.push_back(0);
      for (; run.end < ground.width() && ground.free(ground.index(run.end, row)); ++run.end)
        if (set.of(names[ground.index(run.end, row)]) != 0) has_region.back() = 1;
      column = run.end;
      while (below < before.size() && before[below].end < run.begin) ++below;
      for (std::size_t i = below; i < before.size() && before[i].begin <= run.end; ++i)
        touching.emplace_back(before[i].number, run.number);
      runs.push_back(run);
    }
  }
  DisjointSets pieces(has_region.size());
  for (const auto& [a, b] : touching) pieces.join(a, b);
  return count_sets(pieces, has_region.size(),
                    [&](std::size_t run) { return has_region[run] != 0; });
}

}  // namespace stope::topology
