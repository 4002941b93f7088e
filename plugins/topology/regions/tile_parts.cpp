#include "plugins/topology/regions/tile_parts.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {
namespace {

/// Finds the entry of one or two names in the list of a tile, in a table that is as quick with two
/// regions as with a thousand.
template <class Entry>
class TileList {
 public:
  /// The entry that `is_it`, else a new one.
  template <class IsIt, class Make>
  Entry& find(std::uint32_t hash, IsIt is_it, Make make) {
    std::size_t slot = hash * 2654435761U >> (32 - kBits);
    for (; slots_[slot] != 0; slot = (slot + 1) % kSlots)
      if (Entry& entry = list_[slots_[slot] - 1U]; is_it(entry)) return entry;
    list_.push_back(make());
    slots_[slot] = static_cast<std::uint16_t>(list_.size());
    used_.push_back(static_cast<std::uint16_t>(slot));
    return list_.back();
  }
  std::vector<Entry> take() {
    for (const std::uint16_t slot : used_) slots_[slot] = 0;
    used_.clear();
    std::vector<Entry> list(list_.begin(), list_.end());  // no larger than it need be
    list_.clear();
    return list;
  }

 private:
  // More than there are pairs of cells in a tile.
  static constexpr int kBits = 13;
  static constexpr std::size_t kSlots = std::size_t{1} << kBits;
  static_assert(4 * TileSet::kSide * TileSet::kSide < kSlots);
  std::array<std::uint16_t, kSlots> slots_{};
  std::vector<std::uint16_t> used_;
  std::vector<Entry> list_;
};

class TileScan {
 public:
  TileScan(const Ground& ground, const PaddedGrid<std::int32_t>& names)
      : ground_(ground),
        names_(names),
        steps_{1, ground.stride() - 1, ground.stride(), ground.stride() + 1} {}

  void row(CellIndex first, std::int32_t count) {
    const std::int32_t row = ground_.row(first);
    if (row < 0 || row >= ground_.height()) return;
    constexpr std::int32_t kAcross = ChangedSquares::kAcross, kSide = ChangedSquares::kSide;
    const std::int32_t below = (row + 1) % TileSet::kSide / kSide * kAcross;  // squares
    for (CellIndex cell = first; cell < first + count;) {
      const std::int32_t name = names_[cell];
      const CellIndex begin = cell;
      std::uint16_t free = 0;
      std::int32_t widest = 0;
      for (; cell < first + count && names_[cell] == name; ++cell) {
        const std::int32_t squared = ground_.squared(cell);  // 0 in obstacles
        free = static_cast<std::uint16_t>(free + (squared != 0 ? 1 : 0));
        widest = std::max(widest, squared);
        if (name == 0) continue;
        for (const CellIndex step : steps_)
          if (const std::int32_t other = names_[cell + step]; other != name && other != 0)
            touch(cell, name, cell + step, other);
      }
      if (name == 0) {
        nameless_ += free;
        continue;
      }
      TilePart& own = part(name);
      own.free_cells = static_cast<std::uint16_t>(own.free_cells + free);
      const unsigned squares = (2U << (cell - 1 - first) / kSide) - (1U << (begin - first) / kSide);
      own.squares |= static_cast<TileSquares>(squares << below);
      own.widest = std::max(own.widest, widest);
    }
  }

  std::vector<TilePart> parts() { return parts_.take(); }
  std::vector<Contact> contacts() { return contacts_.take(); }
  std::int32_t nameless() { return std::exchange(nameless_, 0); }

 private:
  TilePart& part(std::int32_t name) {
    return parts_.find(
        static_cast<std::uint32_t>(name), [&](const TilePart& p) { return p.name == name; },
        [&] {
          return TilePart{name, 0, 0, 0};
        });
  }

  void touch(CellIndex cell, std::int32_t name, CellIndex there, std::int32_t other) {
    if (!ground_.free(cell) || !ground_.free(there)) return;
    Contact found{std::min(name, other), std::max(name, other), 0, 0, cell, there};
    if (is_uphill(ground_, cell, there)) std::swap(found.low, found.high);
    found.squared = ground_.squared(found.low);
    Contact& contact = contacts_.find(
        static_cast<std::uint32_t>(found.a) * 40503U + static_cast<std::uint32_t>(found.b),
        [&](const Contact& c) { return c.a == found.a && c.b == found.b; }, [&] { return found; });
    found.steps = contact.steps + 1;
    if (contact.steps == 0 || is_clearer(found, contact)) contact = found;
    contact.steps = found.steps;
  }

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  std::array<CellIndex, 4> steps_;
  TileList<TilePart> parts_;
  TileList<Contact> contacts_;
  std::int32_t nameless_ = 0;
};

}  // namespace

void TileParts::look_at(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                        const std::vector<std::int32_t>& tiles, const Checkpoint& checkpoint) {
  constexpr std::int32_t kTogether = 32;
  const TileSet geometry(ground.width(), ground.height());
  const auto count = static_cast<std::int32_t>(tiles.size());
  for (const std::int32_t tile : tiles) forget(tile);
  for_each_band((count + kTogether - 1) / kTogether, checkpoint, [&] {
    return [&, scan = std::make_shared<TileScan>(ground, names)](std::int32_t band) {
      for (std::int32_t i = band * kTogether; i < std::min(count, (band + 1) * kTogether); ++i) {
        const std::int32_t tile = tiles[static_cast<std::size_t>(i)];
        geometry.for_each_row(
            tile, [&](CellIndex first, std::int32_t cells) { scan->row(first, cells); });
        tiles_[static_cast<std::size_t>(tile)] = {scan->parts(), scan->contacts(),
                                                  scan->nameless()};
      }
    };
  });
  for (const std::int32_t tile : tiles) remember(tile);
}

void TileParts::forget(std::int32_t tile) {
  for (const TilePart& part : parts(static_cast<std::size_t>(tile))) {
    const auto name = static_cast<std::size_t>(part.name);
    free_cells_of_[name] -= part.free_cells;
    auto& own = tiles_of_[name];
    own.erase(std::lower_bound(own.begin(), own.end(), tile));
  }
}

void TileParts::remember(std::int32_t tile) {
  for (const TilePart& part : parts(static_cast<std::size_t>(tile))) {
    const auto name = static_cast<std::size_t>(part.name);
    if (name >= tiles_of_.size()) tiles_of_.resize(name + 1), free_cells_of_.resize(name + 1, 0);
    free_cells_of_[name] += part.free_cells;
    auto& own = tiles_of_[name];
    own.insert(std::lower_bound(own.begin(), own.end(), tile), tile);
  }
}

std::vector<std::int32_t> all_tiles(const Ground& ground) {
  std::vector<std::int32_t> tiles(TileSet(ground.width(), ground.height()).size());
  std::iota(tiles.begin(), tiles.end(), 0);
  return tiles;
}

}  // namespace stope::topology
