// Problem: what grew on a ground, grown again after a change, without growing all of it again.
// Idea: the earlier regions are followed in their order, which is that of the points: one that read
// no cell that differs is as it was, any other is grown again, and cells that only one of the old
// and the new one has differ from then on. What is open to a region depends on those before it; so
// tiles are put back to that moment when something first happens there, by who had their cells, and
// follow from then on.
// Cost: a look at each point and round, the tiles around what is grown again, and that growth.
#include "plugins/topology/regions/regrow_regions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stope::topology {
namespace {

constexpr std::size_t kPointsBetweenCheckpoints = 4096;

class Regrowing {
 public:
  Regrowing(const Ground& ground, const GrowthRule& rule, GrownRegions& grown,
            ChangedSquares& changed, MovedCells& moved)
      : ground_(ground),
        grower_(rule),
        grown_(grown),
        old_(std::move(grown.list)),
        changed_(changed),
        moved_(moved),
        reach_(static_cast<std::int32_t>(std::ceil(rule.max_radius)) + 1),
        has_grown_(static_cast<std::size_t>(grown.names_given) + 1, 0),
        following_(ground.width(), ground.height()),
        in_reach_(ground.width(), ground.height()),
        tiles_across_((ground.stride() + TileSet::kSide - 1) / TileSet::kSide) {
    grown_.list.clear();
    grown_.list.reserve(old_.size() + old_.size() / 8);
    // Here cells may have become free or obstacles, which put_back could not tell later.
    for (const std::int32_t tile : changed.tiles()) {
      following_.add(tile);
      put_back(tile);
    }
  }

  void grow_round(std::int32_t round, double own_room, const std::vector<GrowthPoint>& points,
                  const Checkpoint& checkpoint) {
    std::size_t tried = 0;
    for (const GrowthPoint& point : points) {
      if (tried++ % kPointsBetweenCheckpoints == 0) checkpoint();
      try_point(round, point, own_room * std::sqrt(static_cast<double>(point.squared)));
    }
  }

  std::size_t finish() {
    while (next_ < old_.size()) give_up(old_[next_++]);
    grown_.unused.insert(grown_.unused.end(), gone_.begin(), gone_.end());
    return as_they_were_;
  }

 private:
  bool changed_near(const GrowthPoint& point, std::int32_t reach) const {
    return changed_.touch(point.column, point.row, reach);
  }

  void try_point(std::int32_t round, const GrowthPoint& point, double room) {
    const auto before = [&](const GrownRegion& old) {
      return old.round != round ? old.round < round : tried_before(old.point, point);
    };
    while (next_ < old_.size() && before(old_[next_])) give_up(old_[next_++]);
    const bool was =
        next_ < old_.size() && old_[next_].round == round && old_[next_].point == point;
    const std::int32_t read = static_cast<std::int32_t>(room) + 1;
    const bool unchanged =
        !may_read_changes(point) ||
        !(changed_near(point, read) || (was && changed_near(point, old_[next_].growth.scanned)));
    if (unchanged) {
      if (!was) return;
      keep(std::move(old_[next_++]));
      ++as_they_were_;
      return;
    }
    follow_around(point, read);
    if (!has_room_(grown_.open, point.cell, room)) {
      if (was) give_up(old_[next_++]);
      return;
    }
    follow_around(point, reach_);
    GrownRegion region{0, round, point, grower_.grow(grown_.open, point.cell)};
    if (was && old_[next_].growth.cells == region.growth.cells) {
      region.name = old_[next_++].name;  // it may have looked further or less far
      keep(std::move(region));
    } else if (was) {
      replace(old_[next_++], std::move(region));
    } else {
      region.name = new_name();
      for (const CellIndex cell : region.growth.cells) note_change(cell);
      take_cells(region);
    }
  }

  /// Quick to ask of the many points that are far from all changes.
  bool may_read_changes(const GrowthPoint& point) {
    constexpr std::int32_t kSide = TileSet::kSide, kFar = 16 * kSide;
    if (reach_ > kFar) return true;  // or there would be many tiles in reach of each
    for (; seen_ < changed_.tiles().size(); ++seen_) {
      const std::int32_t tile = changed_.tiles()[seen_];
      const std::int32_t left = tile % tiles_across_ * kSide - 1 - reach_;
      const std::int32_t bottom = tile / tiles_across_ * kSide - 1 - reach_;
      in_reach_.add(left, bottom, left + kSide - 1 + 2 * reach_, bottom + kSide - 1 + 2 * reach_);
    }
    return in_reach_.has((point.row + 1) / kSide * tiles_across_ + (point.column + 1) / kSide);
  }

  /// One that is as it was. Where tiles are not followed its cells are taken already.
  void keep(GrownRegion region) {
    const std::int32_t column = region.point.column, row = region.point.row;
    const std::int32_t reach = region.growth.scanned;
    has_grown_[static_cast<std::size_t>(region.name)] = 1;
    if (following_.has_any(column - reach, row - reach, column + reach, row + reach))
      for (const CellIndex cell : region.growth.cells) grown_.open[cell] = 0;
    grown_.list.push_back(std::move(region));
  }

  /// One that has not grown this time.
  void give_up(const GrownRegion& old) {
    follow_around(old.point, old.growth.scanned);
    for (const CellIndex cell : old.growth.cells) note_change(cell);
    gone_.push_back(old.name);
  }

  /// From the same point: the name stays, and so do cells that both have.
  void replace(const GrownRegion& old, GrownRegion region) {
    constexpr std::uint8_t kWas = 2;
    follow_around(old.point, old.growth.scanned);
    region.name = old.name;
    for (const CellIndex cell : old.growth.cells) grown_.open[cell] |= kWas;
    for (const CellIndex cell : region.growth.cells)
      if (!(grown_.open[cell] & kWas)) note_change(cell);
    take_cells(region);  // and with them the marks
    for (const CellIndex cell : old.growth.cells) {
      if (!(grown_.open[cell] & kWas)) continue;
      grown_.open[cell] &= static_cast<std::uint8_t>(~kWas);
      note_change(cell);
    }
  }

  void take_cells(GrownRegion& region) {
    for (const CellIndex cell : region.growth.cells) {
      grown_.open[cell] = 0;
      moved_.note(ground_, cell, grown_.names[cell], region.name);
      grown_.names[cell] = region.name;
    }
    grown_.list.push_back(std::move(region));
  }

  std::int32_t new_name() {
    if (grown_.unused.empty()) return ++grown_.names_given;
    const std::int32_t name = grown_.unused.back();
    grown_.unused.pop_back();
    return name;
  }

  void note_change(CellIndex cell) { changed_.add(ground_.column(cell), ground_.row(cell)); }

  void follow_around(const GrowthPoint& point, std::int32_t reach) {
    const std::size_t followed = following_.list().size();
    following_.add(point.column - reach, point.row - reach, point.column + reach,
                   point.row + reach);
    for (std::size_t i = followed; i < following_.list().size(); ++i)
      put_back(following_.list()[i]);
  }

  /// From now on `open` is in this tile what it is to the next region to grow.
  void put_back(std::int32_t tile) {
    following_.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      for (CellIndex cell = first; cell < first + count; ++cell) {
        if (!ground_.free(cell)) {
          grown_.open[cell] = 0;
          moved_.note(ground_, cell, grown_.names[cell], 0);
          grown_.names[cell] = 0;
        } else if (!grown_.open[cell]) {
          grown_.open[cell] = has_grown_[static_cast<std::size_t>(grown_.names[cell])] ? 0 : 1;
        }
      }
    });
  }

  const Ground& ground_;
  RegionGrower grower_;
  RoomToGrow has_room_;
  GrownRegions& grown_;
  std::vector<GrownRegion> old_;
  ChangedSquares& changed_;
  MovedCells& moved_;
  std::int32_t reach_;                   ///< of a growth
  std::vector<std::uint8_t> has_grown_;  ///< by name of an old region: its turn came, and it stayed
  TileSet following_;
  TileSet in_reach_;  ///< of the first `seen_` changed tiles
  std::int32_t tiles_across_;
  std::size_t seen_ = 0;
  std::vector<std::int32_t> gone_;  ///< names
  std::size_t next_ = 0, as_they_were_ = 0;
};

}  // namespace

std::size_t regrow_regions(const Ground& ground,
                           const std::vector<std::vector<GrowthPoint>>& groups,
                           const GrowthRule& rule, const Checkpoint& checkpoint,
                           GrownRegions& grown, ChangedSquares& changed, MovedCells& moved) {
  Regrowing growing(ground, rule, grown, changed, moved);
  std::int32_t round = 0;
  for (const auto& points : groups)
    for (const double own_room : kOwnRoom)
      growing.grow_round(round++, own_room, points, checkpoint);
  return growing.finish();
}

}  // namespace stope::topology
