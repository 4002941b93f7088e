// Problem: from the centre of a region to each place where it can be left, keep to the middle.
// Idea: the straight line, if it stays in the region and about as clear as its ends; else the way
// of least length over clearance. In a corridor, straight or bent round a centre, that way is the
// middle line however wide the rest of the region is. A few doors are searched from one by one:
// there it is narrow, where a bound is worst and cells are few. Where there are many, from the
// centre to all. Cells that are too narrow are walls, so a way is missing only if there is none.
// Cost: that of the searches; most regions need only lines.
#include "plugins/topology/regions/ways_to_doors.hpp"

#include <algorithm>
#include <cstdlib>

namespace stope::topology {
namespace {

/// Share of the clearance at its ends that a straight line keeps, so that it leaves the middle of
/// a road by little.
constexpr double kStraightShare = 0.9;

}  // namespace

std::vector<std::vector<CellIndex>> WaysToDoors::find(
    CellIndex centre, const std::vector<CellIndex>& doors, bool many, std::int32_t widest,
    const std::function<std::vector<std::int32_t>()>& tiles) {
  std::vector<std::vector<CellIndex>> ways;
  std::vector<CellIndex> hidden;
  for (const CellIndex door : doors) {
    const bool wide = ground_.squared(door) >= least_ && ground_.squared(centre) >= least_;
    ways.push_back(wide ? straight(door, centre) : std::vector<CellIndex>{});
    if (wide && ways.back().empty()) hidden.push_back(door);
  }
  if (hidden.empty()) return ways;
  search_.enter(region_of(centre), tiles());
  if (many) search_.to_all(centre, hidden);
  auto next = hidden.cbegin();
  for (std::size_t i = 0; i < doors.size() && next != hidden.cend(); ++i) {
    if (doors[i] != *next || !ways[i].empty()) continue;
    ++next;
    if (many) {
      ways[i] = search_.way_back(doors[i]);
    } else {
      search_.towards(doors[i], centre, widest);
      ways[i] = search_.way_back(centre);
      std::reverse(ways[i].begin(), ways[i].end());
    }
  }
  return ways;
}

std::vector<CellIndex> WaysToDoors::straight(CellIndex from, CellIndex to) const {
  const std::int32_t region = region_of(from);
  const std::int32_t least = std::max(
      least_, share_of(std::min(ground_.squared(from), ground_.squared(to)), kStraightShare));
  const std::int32_t x0 = ground_.column(from), y0 = ground_.row(from);
  const std::int32_t dx = ground_.column(to) - x0, dy = ground_.row(to) - y0;
  const std::int32_t count = std::max(std::abs(dx), std::abs(dy));
  std::vector<CellIndex> cells{from};
  for (std::int32_t i = 1; i <= count; ++i) {
    const auto part = [&](std::int64_t whole) {
      const std::int64_t twice = 2 * whole * i + (whole < 0 ? -count : count);
      return static_cast<std::int32_t>(twice / (2 * count));
    };
    const CellIndex cell = ground_.index(x0 + part(dx), y0 + part(dy));
    if (region_of(cell) != region || !ground_.free(cell) || ground_.squared(cell) < least)
      return {};
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace stope::topology
