// Problem: from the centre of a region to each place where it can be left, keep to the middle.
// Idea: the straight line, if it stays in the region and about as clear as its ends; else the way
// of least length over clearance, by Dijkstra's algorithm over the region's cells, with buckets for
// a queue (Dial 1969). In a corridor, straight or bent round a centre, that way is the middle line
// however wide the rest of the region is. Cells that are too narrow are walls, so a way is missing
// only if there is none.
// Cost: linear in the tiles a region has cells in at worst; most regions need only lines.
#include "plugins/topology/regions/ways_to_doors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "plugins/topology/tile_set.hpp"

namespace stope::topology {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity(), kWall = 0;
constexpr std::int32_t kNoTile = -1;

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
  spread(region_of(centre), tiles);
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

void WaysToDoors::spread(std::int32_t region, const std::vector<std::int32_t>& tiles) {
  constexpr std::int32_t kSide = TileSet::kSide;
  const std::int32_t across = (ground_.stride() + kSide - 1) / kSide;
  std::int32_t right = 0, top = 0;
  left_ = bottom_ = INT32_MAX;
  for (const std::int32_t tile : tiles) {
    left_ = std::min(left_, tile % across), right = std::max(right, tile % across);
    bottom_ = std::min(bottom_, tile / across), top = std::max(top, tile / across);
  }
  --left_, --bottom_;  // a margin of tiles without the region
  across_ = right - left_ + 2;
  number_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(top - bottom_ + 2),
                 kNoTile);
  box_place_.clear();
  slowness_.assign(tiles.size() * kSide * kSide, kWall);
  cost_.assign(slowness_.size(), kUnreached);
  back_.resize(slowness_.size());
  slowest_ = 0, quickest_ = kUnreached;
  const TileSet geometry(ground_.width(), ground_.height());
  for (const std::int32_t tile : tiles) {
    float* row = slowness_.data() + box_place_.size() * kSide * kSide;
    const std::int32_t place = (tile / across - bottom_) * across_ + tile % across - left_;
    number_[static_cast<std::size_t>(place)] = static_cast<std::int32_t>(box_place_.size());
    box_place_.push_back(place);
    geometry.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      std::int32_t name = 0;
      bool own = false;
      for (std::int32_t i = 0; i < count; ++i) {
        const CellIndex cell = first + i;
        if (names_[cell] != name) name = names_[cell], own = set_.of(name) == region;
        if (!own || ground_.squared(cell) < least_) continue;
        row[i] = 0.5F / clearance_of(ground_.squared(cell));
        slowest_ = std::max(slowest_, row[i]);
        quickest_ = std::min(quickest_, row[i]);
      }
      row += kSide;
    });
  }
}

std::int32_t WaysToDoors::place_of(CellIndex cell) const {
  constexpr std::int32_t kSide = TileSet::kSide;
  const std::int32_t x = ground_.column(cell) + 1, y = ground_.row(cell) + 1;
  const std::int32_t tile =
      number_[static_cast<std::size_t>((y / kSide - bottom_) * across_ + x / kSide - left_)];
  return (tile * kSide + y % kSide) * kSide + x % kSide;
}

/// The place beside one, or kNoTile where the region has no cell in the tile there.
std::int32_t WaysToDoors::beside(std::int32_t place, std::int32_t dx, std::int32_t dy) const {
  constexpr std::int32_t kSide = TileSet::kSide;
  const std::int32_t x = place % kSide + dx, y = place / kSide % kSide + dy;
  if (x >= 0 && y >= 0 && x < kSide && y < kSide) return place + dy * kSide + dx;
  const auto over = [](std::int32_t at) { return at < 0 ? -1 : at >= kSide ? 1 : 0; };
  const std::int32_t from = box_place_[static_cast<std::size_t>(place / (kSide * kSide))];
  const std::int32_t tile = number_[static_cast<std::size_t>(from + over(y) * across_ + over(x))];
  if (tile == kNoTile) return kNoTile;
  return (tile * kSide + (y + kSide) % kSide) * kSide + (x + kSide) % kSide;
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
  constexpr float kDiagonal = 1.41421356F;
  // As neighbour_steps.
  constexpr std::array<std::int32_t, 8> kX{1, 0, -1, 0, 1, -1, -1, 1},
      kY{0, 1, 0, -1, 1, 1, -1, -1};
  // A step costs at least what a bucket holds, so cells in the lowest one are done, and at most
  // what all of them do.
  const float bucket = 2 * quickest_;
  const auto bucket_of = [&](float cost) { return static_cast<std::size_t>(cost / bucket); };
  const std::size_t count = bucket_of(kDiagonal * 2 * slowest_) + 8;
  std::vector<std::vector<std::int32_t>> buckets(count);
  cost_[static_cast<std::size_t>(place_of(centre))] = 0;
  buckets[0].push_back(place_of(centre));
  doors.erase(std::unique(doors.begin(), doors.end()), doors.end());
  std::size_t waiting = 1;
  for (std::size_t at = 0; waiting > 0 && !doors.empty(); ++at) {
    std::vector<std::int32_t>& now = buckets[at % count];
    for (std::size_t k = 0; k < now.size(); ++k) {  // rounding may add one to it meanwhile
      const std::int32_t place = now[k];
      const float cost = cost_[static_cast<std::size_t>(place)];
      if (bucket_of(cost) != at) continue;  // a better way to it was found since
      const float own = slowness_[static_cast<std::size_t>(place)];
      for (std::size_t i = 0; i < 8; ++i) {
        const std::int32_t next = beside(place, kX[i], kY[i]);
        if (next == kNoTile) continue;
        const auto there = static_cast<std::size_t>(next);
        if (slowness_[there] == kWall) continue;
        const float total = cost + (i < 4 ? 1.0F : kDiagonal) * (own + slowness_[there]);
        // Of equally good ways the one that is kept does not depend on which is found first.
        if (total > cost_[there] || (total == cost_[there] && i >= back_[there])) continue;
        back_[there] = static_cast<std::uint8_t>(i);
        if (total == cost_[there]) continue;
        cost_[there] = total;
        buckets[bucket_of(total) % count].push_back(next);
        ++waiting;
      }
    }
    waiting -= now.size();
    now.clear();
    std::erase_if(doors, [&](CellIndex door) {
      const float cost = cost_[static_cast<std::size_t>(place_of(door))];
      return cost != kUnreached && bucket_of(cost) <= at;
    });
  }
}

}  // namespace stope::topology
