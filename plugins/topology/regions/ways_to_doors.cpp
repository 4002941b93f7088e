// Problem: from the centre of a region to each place where it can be left, keep to the middle.
// Idea: the straight line, if it stays in the region and about as clear as its ends; else the way
// of least length over clearance, by Dijkstra's algorithm over the region's cells. In a corridor,
// straight or bent round a centre, that way is the middle line however wide the rest of the region
// is. Cells that are too narrow are walls, so a way is missing only if there is none.
// Cost: a region's cells times the logarithm of their number at worst; most regions need only
// lines.
#include "plugins/topology/regions/ways_to_doors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace stope::topology {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Share of the clearance at its ends that a straight line keeps, so that it leaves the middle of
/// a road by little.
constexpr double kStraightShare = 0.9;

/// Clearance of a cell from the obstacle's edge, in cells.
float clearance_of(std::int32_t squared) { return std::sqrt(static_cast<float>(squared)) - 0.5F; }

}  // namespace

WaySearchCells::WaySearchCells(std::int32_t width, std::int32_t height)
    : cost_(width, height), back_(width, height) {
  std::fill_n(cost_.data(), cost_.size(), kUnreached);
}

std::vector<std::vector<CellIndex>> WaysToDoors::find(CellIndex centre,
                                                      const std::vector<CellIndex>& doors) {
  std::vector<std::vector<CellIndex>> ways;
  std::vector<CellIndex> hidden;
  for (const CellIndex door : doors) {
    const bool wide = ground_.squared(door) >= least_ && ground_.squared(centre) >= least_;
    ways.push_back(wide ? straight(door, centre) : std::vector<CellIndex>{});
    if (wide && ways.back().empty()) hidden.push_back(door);
  }
  if (hidden.empty()) return ways;
  search(centre, hidden);
  const auto steps = neighbour_steps(ground_.stride());
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (!ways[i].empty() || cost_[doors[i]] == kUnreached) continue;
    for (CellIndex cell = doors[i]; cell != centre; cell -= steps[back_[cell]])
      ways[i].push_back(cell);
    ways[i].push_back(centre);
  }
  for (const CellIndex cell : reached_) cost_[cell] = kUnreached;
  reached_.clear();
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

void WaysToDoors::search(CellIndex centre, const std::vector<CellIndex>& doors) {
  const auto steps = neighbour_steps(ground_.stride());
  const std::int32_t region = region_of(centre);
  using Entry = std::pair<float, CellIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost_[centre] = 0;
  reached_.push_back(centre);
  open.push({0.0F, centre});
  std::vector<CellIndex> wanted = doors;
  std::sort(wanted.begin(), wanted.end());
  std::size_t left =
      static_cast<std::size_t>(std::unique(wanted.begin(), wanted.end()) - wanted.begin());
  wanted.resize(left);
  while (!open.empty() && left > 0) {
    const auto [cost, cell] = open.top();
    open.pop();
    if (cost > cost_[cell]) continue;
    if (std::binary_search(wanted.begin(), wanted.end(), cell)) --left;
    const float slowness = 0.5F / clearance_of(ground_.squared(cell));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const CellIndex next = cell + steps[i];
      if (region_of(next) != region || ground_.squared(next) < least_) continue;
      const float length = i < 4 ? 1.0F : 1.41421356F;
      const float there = cost + length * (slowness + 0.5F / clearance_of(ground_.squared(next)));
      if (there >= cost_[next]) continue;
      if (cost_[next] == kUnreached) reached_.push_back(next);
      cost_[next] = there;
      back_[next] = static_cast<std::uint8_t>(i);
      open.push({there, next});
    }
  }
}

}  // namespace stope::topology
