// Problem: at how many places apart from each other do two regions touch.
// Idea: free space is the union of its closed cells, so two regions have edges and corners of cells
// in common, and a ring of both is closed once more by each further connected piece of these: it
// goes around an obstacle or a third region. Pairs of cells that touch at one corner are in one
// piece, and an edge leads from corner to corner.
// Cost: a look at every cell of the tiles where regions touch of which one is not as it was in the
// map before, and sorting the pairs found there.
#include "plugins/topology/regions/doors.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/tile_set.hpp"

namespace stope::topology {
namespace {

/// Two cells that touch, and where: the ends of their common edge, or twice their common corner. A
/// corner is named by the cell above it to the right.
struct Touch {
  Border cells;
  std::array<CellIndex, 2> corners{};
};

/// One end of a touch.
struct End {
  std::int32_t a = 0, b = 0;
  CellIndex corner = 0;
  std::int32_t touch = 0;
};

class DoorScan {
 public:
  DoorScan(const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
           const SameRegions& same)
      : ground_(ground), names_(names), set_(set), same_(same) {}

  std::vector<Touch> tile(const TileSet& geometry, std::int32_t tile) const {
    std::vector<Touch> found;
    geometry.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      const std::int32_t row = ground_.row(first);
      if (row < 0 || row >= ground_.height()) return;
      for (CellIndex cell = first; cell < first + count; ++cell)
        if (names_[cell] != 0) look_from(cell, found);
    });
    return found;
  }

 private:
  void look_from(CellIndex cell, std::vector<Touch>& found) const {
    const CellIndex up = ground_.stride();
    look(cell, cell + 1, {cell + 1, cell + up + 1}, found);
    look(cell, cell + up - 1, {cell + up, cell + up}, found);
    look(cell, cell + up, {cell + up, cell + up + 1}, found);
    look(cell, cell + up + 1, {cell + up + 1, cell + up + 1}, found);
  }

  void look(CellIndex cell, CellIndex there, std::array<CellIndex, 2> corners,
            std::vector<Touch>& found) const {
    const std::int32_t name = names_[cell], other = names_[there];
    if (name == other || other == 0) return;
    const std::int32_t own = set_.of(name), beyond = set_.of(other);
    if (own == beyond || own == 0 || beyond == 0) return;
    if (same_.has(own) && same_.has(beyond)) return;
    if (!ground_.free(cell) || !ground_.free(there)) return;
    Border cells{std::min(own, beyond), std::max(own, beyond), 1, 0, cell, there};
    if (is_uphill(ground_, cell, there)) std::swap(cells.low, cells.high);
    cells.squared = ground_.squared(cells.low);
    found.push_back({cells, corners});
  }

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  const SameRegions& same_;
};

/// All touches, tile by tile.
std::vector<Touch> touches(const DoorScan& scan, const TileSet& tiles,
                           const Checkpoint& checkpoint) {
  constexpr std::int32_t kTogether = 8;
  const auto count = static_cast<std::int32_t>(tiles.list().size());
  std::vector<std::vector<Touch>> found(tiles.list().size());
  for_each_band((count + kTogether - 1) / kTogether, checkpoint, [&] {
    return [&](std::int32_t band) {
      const std::int32_t end = std::min(count, (band + 1) * kTogether);
      for (auto i = static_cast<std::size_t>(band * kTogether); i < static_cast<std::size_t>(end);
           ++i)
        found[i] = scan.tile(tiles, tiles.list()[i]);
    };
  });
  std::vector<Touch> all;
  for (const std::vector<Touch>& those : found) all.insert(all.end(), those.begin(), those.end());
  return all;
}

/// Joins the touches of the same two regions that have a corner in common.
DisjointSets joined_at_corners(const std::vector<Touch>& all) {
  std::vector<End> ends;
  ends.reserve(2 * all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const CellIndex corner : all[i].corners)
      ends.push_back({all[i].cells.a, all[i].cells.b, corner, static_cast<std::int32_t>(i)});
  const auto where = [](const End& end) { return std::tie(end.a, end.b, end.corner); };
  std::sort(ends.begin(), ends.end(),
            [&](const End& x, const End& y) { return where(x) < where(y); });
  DisjointSets pieces(all.size());
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (where(ends[i - 1]) == where(ends[i])) pieces.join(ends[i - 1].touch, ends[i].touch);
  return pieces;
}

/// Where regions touch that are not both as they were.
std::vector<Border> new_doors(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                              const RegionSet& set, const std::vector<Contact>& contacts,
                              const SameRegions& same, const Checkpoint& checkpoint) {
  // A contact is in the tile of the earlier of its cells, and so are all that it stands for.
  TileSet tiles(ground.width(), ground.height());
  for (const Contact& contact : contacts)
    if (const std::int32_t a = set.of(contact.a), b = set.of(contact.b);
        a != b && a != 0 && b != 0 && !(same.has(a) && same.has(b)))
      tiles.add(tiles.tile_of(std::min(contact.low, contact.high)));
  const std::vector<Touch> all = touches(DoorScan(ground, names, set, same), tiles, checkpoint);
  DisjointSets pieces = joined_at_corners(all);
  std::vector<Border> doors;
  std::vector<std::size_t> door_of(all.size());  // by the touch that a piece is named by
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto piece = static_cast<std::size_t>(pieces.find(static_cast<std::int32_t>(i)));
    if (piece == i) {
      door_of[i] = doors.size();
      doors.push_back(all[i].cells);
      continue;
    }
    Border& door = doors[door_of[piece]];
    const std::int32_t steps = door.steps + 1;
    if (is_clearer(all[i].cells, door)) door = all[i].cells;
    door.steps = steps;
  }
  return doors;
}

/// The doors of the map before whose regions are both as they were, by their numbers now.
std::vector<Door> doors_as_before(const SameRegions& same, const RegionMemo& memo) {
  std::vector<Door> doors;
  if (same.now.empty()) return doors;
  const auto now = [&](std::int32_t region) {
    return same.now[static_cast<std::size_t>(region) - 1];
  };
  for (std::size_t i = 0; i < memo.doors.size(); ++i) {
    Border border = memo.doors[i];
    border.a = now(border.a), border.b = now(border.b);
    if (border.a == 0 || border.b == 0) continue;
    if (border.a > border.b) std::swap(border.a, border.b);
    doors.push_back({border, static_cast<std::int32_t>(i)});
  }
  return doors;
}

void sort_doors(std::vector<Door>& doors) {
  std::sort(doors.begin(), doors.end(),
            [](const Door& x, const Door& y) { return is_before(x.border, y.border); });
}

}  // namespace

std::vector<Door> find_doors(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                             const RegionSet& set, const std::vector<Contact>& contacts,
                             std::int32_t least, const SameRegions& same, const RegionMemo& memo,
                             const Checkpoint& checkpoint) {
  std::vector<Door> doors = doors_as_before(same, memo);
  for (const Border& border : new_doors(ground, names, set, contacts, same, checkpoint))
    doors.push_back({border, -1});
  sort_doors(doors);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    const Border& border = doors[i].border;
    const bool first =
        kept == 0 || doors[kept - 1].border.a != border.a || doors[kept - 1].border.b != border.b;
    if (first || border.squared >= least) doors[kept++] = doors[i];
  }
  doors.resize(kept);
  return doors;
}

std::vector<Door> doors_at_borders(const std::vector<Border>& borders, const SameRegions& same,
                                   const RegionMemo& memo) {
  std::vector<Door> before = doors_as_before(same, memo), doors;
  sort_doors(before);
  doors.reserve(borders.size());
  auto at = before.cbegin();
  for (const Border& border : borders) {
    while (at != before.cend() && is_before(at->border, border)) ++at;
    const bool known = at != before.cend() && !is_before(border, at->border);
    doors.push_back({border, known ? at->before : -1});
  }
  return doors;
}

}  // namespace stope::topology
