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
#include <limits>
#include <utility>

namespace stope::topology {
namespace {

constexpr std::size_t kPointsBetweenCheckpoints = 4096;

class Regrowing {
 public:
  Regrowing(const Ground& ground, const GrowthRule& rule, GrownRegions& grown,
            ChangedSquares& changed, MovedCells& moved)
      : ground_(ground),
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
    GrownRegion region{0, round, point,
                       grown_.grower.grow(grown_.open, point.cell, [&](std::int32_t reach) {
                         follow_around(point, reach);
                       })};
    if (was && old_[next_].growth.runs == region.growth.runs) {
      region.name = old_[next_++].name;  // it may have looked further or less far
      keep(std::move(region));
    } else if (was) {
      replace(old_[next_++], std::move(region));
    } else {
      region.name = new_name();
      for (const CellRun& run : region.growth.runs) note_change(run);
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
      for (const CellRun& run : region.growth.runs)
        std::fill_n(grown_.open.data() + run.first, run.count, std::uint8_t{0});
    grown_.list.push_back(std::move(region));
  }

  /// One that has not grown this time.
  void give_up(const GrownRegion& old) {
    follow_around(old.point, old.growth.scanned);
    for (const CellRun& run : old.growth.runs) note_change(run);
    gone_.push_back(old.name);
  }

  /// From the same point: the name stays, and so do cells that both have.
  void replace(const GrownRegion& old, GrownRegion region) {
    follow_around(old.point, old.growth.scanned);
    region.name = old.name;
    note_difference(old.growth.runs, region.growth.runs);
    take_cells(region);
  }

  /// What only one of two has. Where both have begun or neither has, they are the same up to the
  /// next end of a run.
  void note_difference(const std::vector<CellRun>& a, const std::vector<CellRun>& b) {
    std::size_t i = 0, k = 0;  // ends of runs: the begin of run n is 2 n, its end 2 n + 1
    CellIndex cell = 0;
    while (i < 2 * a.size() || k < 2 * b.size()) {
      const CellIndex next_a = end_of_run(a, i), next_b = end_of_run(b, k);
      const CellIndex next = std::min(next_a, next_b);
      if (i % 2 != k % 2) note_change({cell, next - cell});
      i += next_a == next ? 1 : 0, k += next_b == next ? 1 : 0;
      cell = next;
    }
  }
  static CellIndex end_of_run(const std::vector<CellRun>& runs, std::size_t which) {
    if (which >= 2 * runs.size()) return std::numeric_limits<CellIndex>::max();
    return which % 2 == 0 ? runs[which / 2].first : runs[which / 2].end();
  }

  void take_cells(GrownRegion& region) {
    for (const CellRun& run : region.growth.runs) {
      std::fill_n(grown_.open.data() + run.first, run.count, std::uint8_t{0});
      for (CellIndex cell = run.first; cell < run.end();) {
        // Of cells with the same name before, one in each square stands for the others.
        const std::int32_t before = grown_.names[cell];
        const CellIndex begin = cell;
        while (cell < run.end() && grown_.names[cell] == before) ++cell;
        if (before == region.name) continue;
        for (CellIndex at = begin; at < cell; at += ChangedSquares::kSide)
          moved_.note(ground_, at, before, region.name);
        moved_.note(ground_, cell - 1, before, region.name);
      }
      std::fill_n(grown_.names.data() + run.first, run.count, region.name);
    }
    grown_.list.push_back(std::move(region));
  }

  std::int32_t new_name() {
    if (grown_.unused.empty()) return ++grown_.names_given;
    const std::int32_t name = grown_.unused.back();
    grown_.unused.pop_back();
    return name;
  }

  void note_change(const CellRun& run) {
    const std::int32_t column = ground_.column(run.first), row = ground_.row(run.first);
    for (std::int32_t x = column; x < column + run.count; x += ChangedSquares::kSide)
      changed_.add(x, row);
    changed_.add(column + run.count - 1, row);
  }

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
      std::uint8_t* const open = grown_.open.data() + first;
      std::int32_t* const names = grown_.names.data() + first;
      for (std::int32_t i = 0; i < count; ++i) {
        const bool free = ground_.free(first + i);
        if (!free && names[i] != 0) {
          moved_.note(ground_, first + i, names[i], 0);
          names[i] = 0;
        }
        // Nobody's cells are open: no region has the name 0.
        const std::uint8_t taken = has_grown_[static_cast<std::size_t>(names[i])];
        open[i] = free ? static_cast<std::uint8_t>(open[i] | (taken ^ 1U)) : std::uint8_t{0};
      }
    });
  }

  const Ground& ground_;
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
