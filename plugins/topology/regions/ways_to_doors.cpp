// Problem: from the centre of a region to each place where it can be left, keep to the middle.
// Idea: the straight line, if it stays in the region and about as clear as its ends; else the way
// of least length over clearance, by Dijkstra's algorithm over the region's cells. In a corridor,
// straight or bent round a centre, that way is the middle line however wide the rest of the region
// is. Cells that are too narrow are walls, so a way is missing only if there is none.
// Cost: a region's cells times the logarithm of their number at worst, and the box around it; most
// regions need only lines.
#include "plugins/topology/regions/ways_to_doors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "plugins/topology/tile_set.hpp"

namespace stope::topology {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// Share of the clearance at its ends that a straight line keeps, so that it leaves the middle of
/// a road by little.
constexpr double kStraightShare = 0.9;

/// Clearance of a cell from the obstacle's edge, in cells.
float clearance_of(std::int32_t squared) { return std::sqrt(static_cast<float>(squared)) - 0.5F; }

}  // namespace

std::vector<std::vector<CellIndex>> WaysToDoors::find(CellIndex centre,
                                                      const std::vector<CellIndex>& doors,
                                                      const std::vector<std::int32_t>& tiles) {
  std::vector<std::vector<CellIndex>> ways;
  std::vector<CellIndex> hidden;
  for (const CellIndex door : doors) {
    const bool wide = ground_.squared(door) >= least_ && ground_.squared(centre) >= least_;
    ways.push_back(wide ? straight(door, centre) : std::vector<CellIndex>{});
    if (wide && ways.back().empty()) hidden.push_back(door);
  }
  if (hidden.empty()) return ways;
  std::sort(hidden.begin(), hidden.end());
  enclose(tiles);
  search(centre, hidden);
  const auto steps = neighbour_steps(ground_.stride());
  const auto place = [&](CellIndex cell) { return static_cast<std::size_t>(place_of(cell)); };
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (!std::binary_search(hidden.begin(), hidden.end(), doors[i])) continue;
    if (cost_[place(doors[i])] == kUnreached) continue;
    for (CellIndex cell = doors[i]; cell != centre; cell -= steps[back_[place(cell)]])
      ways[i].push_back(cell);
    ways[i].push_back(centre);
  }
  return ways;
}

void WaysToDoors::enclose(const std::vector<std::int32_t>& tiles) {
  const TileSet geometry(ground_.width(), ground_.height());
  std::int32_t right = -2, top = -2;
  left_ = ground_.width(), bottom_ = ground_.height();
  for (const std::int32_t tile : tiles)
    geometry.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      left_ = std::min(left_, ground_.column(first));
      right = std::max(right, ground_.column(first) + count - 1);
      bottom_ = std::min(bottom_, ground_.row(first));
      top = std::max(top, ground_.row(first));
    });
  width_ = right - left_ + 1;
  height_ = top - bottom_ + 1;
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

void WaysToDoors::search(CellIndex centre, std::vector<CellIndex> doors) {
  const auto steps = neighbour_steps(ground_.stride());
  const auto places = neighbour_steps(width_);
  const std::int32_t region = region_of(centre);
  const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  cost_.assign(cells, kUnreached);
  back_.resize(cells);
  using Entry = std::pair<float, std::int32_t>;  // cost, place
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost_[static_cast<std::size_t>(place_of(centre))] = 0;
  open.push({0.0F, place_of(centre)});
  std::size_t left =
      static_cast<std::size_t>(std::unique(doors.begin(), doors.end()) - doors.begin());
  doors.resize(left);
  while (!open.empty() && left > 0) {
    const auto [cost, place] = open.top();
    open.pop();
    if (cost > cost_[static_cast<std::size_t>(place)]) continue;
    const CellIndex cell = cell_at(place);
    if (std::binary_search(doors.begin(), doors.end(), cell)) --left;
    const float slowness = 0.5F / clearance_of(ground_.squared(cell));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const CellIndex next = cell + steps[i];
      if (region_of(next) != region || ground_.squared(next) < least_) continue;
      const auto there = static_cast<std::size_t>(place + places[i]);
      const float length = i < 4 ? 1.0F : 1.41421356F;
      const float total = cost + length * (slowness + 0.5F / clearance_of(ground_.squared(next)));
      if (total >= cost_[there]) continue;
      cost_[there] = total;
      back_[there] = static_cast<std::uint8_t>(i);
      open.push({total, static_cast<std::int32_t>(there)});
    }
  }
}

}  // namespace stope::topology
