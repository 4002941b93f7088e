// Problem: after a change most regions are as they were; do not measure them again.
// Idea: a region is the same if it is made of the same names and no cell has changed in any square
// of eight cells that it, or what its roads depend on around it, has cells in.
// Cost: linear in the names and in the tiles with changes, and measuring the other regions.
#include "plugins/topology/regions/known_regions.hpp"

#include <utility>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/regions/region_centre.hpp"

namespace stope::topology {
namespace {

/// By region, from 0 for none on: whether something has changed where it can tell.
std::vector<std::uint8_t> regions_that_see(const ChangedSquares& changed, const TileParts& tiles,
                                           const RegionSet& set) {
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(set.count) + 1, 0);
  for (const std::int32_t tile : changed.tiles())
    for (const TilePart& part : tiles.parts(static_cast<std::size_t>(tile)))
      if (part.squares & changed.of(tile)) seen[static_cast<std::size_t>(set.of(part.name))] = 1;
  return seen;
}

/// Takes from the memo the regions that are as they were.
SameRegions take_same(const RegionParts& parts, const std::vector<std::uint8_t>& seen,
                      RegionMemo& memo, std::vector<KnownRegion>& known) {
  SameRegions found{std::vector<std::uint8_t>(known.size(), 0),
                    std::vector<std::int32_t>(memo.regions.size(), 0)};
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (seen[i + 1]) continue;
    const auto at = memo.place_of.find(parts.members[i].front());
    if (at == memo.place_of.end()) continue;
    KnownRegion& before = memo.regions[static_cast<std::size_t>(at->second)];
    if (before.members != parts.members[i] || before.cut_off != parts.cut_off[i]) continue;
    known[i] = std::move(before);
    found.same[i] = 1;
    found.now[static_cast<std::size_t>(at->second)] = static_cast<std::int32_t>(i) + 1;
    ++memo.reused;
  }
  return found;
}

}  // namespace

std::vector<KnownRegion> know_regions(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                      const TileParts& tiles, const RegionSet& set,
                                      RegionParts& parts, RegionMemo& memo,
                                      const ChangedSquares* changed, const RegionRoadsRule& rule,
                                      SameRegions& same, const Checkpoint& checkpoint) {
  std::vector<KnownRegion> known(static_cast<std::size_t>(set.count));
  memo.reused = 0;
  same = {std::vector<std::uint8_t>(known.size(), 0), {}};
  if (changed)
    same = take_same(
        parts,
        regions_that_see(changed->widened(rule.reach(ground.frame().resolution)), tiles, set), memo,
        known);
  for_each_band(set.count, checkpoint, [&] {
    return [&](std::int32_t band) {
      const auto i = static_cast<std::size_t>(band);
      if (same.same[i]) return;
      const std::vector<std::int32_t> own = parts.tiles_of(tiles, i);
      const RegionShape shape = shape_of(ground, names, set, band + 1, own);
      known[i].members = std::move(parts.members[i]);
      known[i].cut_off = std::move(parts.cut_off[i]);
      known[i].cells = shape.cells;
      known[i].axes = shape.axes();
      const RegionCentre centre =
          centre_of_region(ground, names, tiles, set, band + 1, own, shape, rule);
      known[i].centre = centre.place;
      known[i].widest = centre.widest;
    };
  });
  return known;
}

void remember_regions(std::vector<KnownRegion> known, const std::vector<Door>& doors,
                      std::vector<RegionRoad> roads, RegionMemo& memo) {
  memo.doors.clear();
  memo.doors.reserve(doors.size());
  for (const Door& door : doors) memo.doors.push_back(door.border);
  memo.roads = std::move(roads);
  memo.regions = std::move(known);
  memo.place_of.clear();
  memo.place_of.reserve(memo.regions.size());
  for (std::size_t i = 0; i < memo.regions.size(); ++i)
    memo.place_of.emplace(memo.regions[i].members.front(), static_cast<std::int32_t>(i));
}

}  // namespace stope::topology
