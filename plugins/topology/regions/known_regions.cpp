// Problem: after a change most regions are as they were; do not measure them again.
// Idea: a region is the same if it is made of the same names and no cell has changed in any square
// of eight cells that it, or what its roads depend on around it, has cells in.
// Cost: linear in the regions and the tiles they have cells in, and measuring the others.
#include "plugins/topology/regions/known_regions.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/regions/region_centre.hpp"

namespace stope::topology {

std::vector<RegionMemo::Known> know_regions(
    const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
    RegionParts& parts, RegionMemo& memo, const ChangedSquares* changed,
    const RegionRoadsRule& rule, std::vector<std::uint8_t>& same, const Checkpoint& checkpoint) {
  std::vector<RegionMemo::Known> known(static_cast<std::size_t>(set.count));
  std::optional<ChangedSquares> near;
  if (changed) near = changed->widened(rule.reach(ground.frame().resolution));
  const auto has_changed = [&](std::size_t region) {
    const auto& tiles = parts.tiles[region];
    for (std::size_t i = 0; i < tiles.size(); ++i)
      if (near->of(tiles[i]) & parts.squares[region][i]) return true;
    return false;
  };
  memo.reused = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto found = memo.regions.find(parts.members[i].front());
    same[i] = near && found != memo.regions.end() && found->second.members == parts.members[i] &&
              found->second.cut_off == parts.cut_off[i] && !has_changed(i);
    if (same[i]) {
      known[i] = std::move(found->second);
      ++memo.reused;
    } else {
      known[i].members = std::move(parts.members[i]);
      known[i].cut_off = std::move(parts.cut_off[i]);
    }
  }
  for_each_band(set.count, checkpoint, [&] {
    return [&](std::int32_t band) {
      const auto i = static_cast<std::size_t>(band);
      if (same[i]) return;
      const RegionShape shape = shape_of(ground, names, set, band + 1, parts.tiles[i]);
      known[i].cells = shape.cells;
      known[i].axes = shape.axes();
      known[i].centre = centre_of_region(ground, names, set, band + 1, parts.tiles[i], shape, rule);
    };
  });
  return known;
}

void remember_regions(std::vector<RegionMemo::Known> known, std::vector<RegionRoad> roads,
                      const std::vector<Border>& borders, RegionMemo& memo) {
  memo.roads.clear();
  for (std::size_t i = 0; i < borders.size(); ++i)
    memo.roads[{borders[i].low, borders[i].high}] = std::move(roads[i]);
  memo.regions.clear();
  for (RegionMemo::Known& region : known) {
    const CellIndex lowest = region.members.front();
    memo.regions[lowest] = std::move(region);
  }
}

}  // namespace stope::topology
