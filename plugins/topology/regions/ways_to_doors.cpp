// Problem: from the centre of a region to each place where it can be left, keep to the middle.
// Idea: the straight line, if it stays in the region and about as clear as its ends; else the way
// of least length over clearance, over the region's cells. In a corridor, straight or bent round a
// centre, that way is the middle line however wide the rest of the region is. It is searched for by
// A* (Hart, Nilsson and Raphael 1968) with buckets for a queue (Dial 1969): clearance grows by no
// more than one goes, so between two clearances a distance costs at least so much, which keeps the
// search out of whatever is not on the way to a narrow door. Cells that are too narrow are walls,
// so a way is missing only if there is none. Cost: linear in the cells around the ways, at worst in
// the tiles a region has cells in; most regions need only lines.
#include "plugins/topology/regions/ways_to_doors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

#include "plugins/topology/tile_set.hpp"

namespace stope::topology {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity(), kWall = 0;
constexpr std::int32_t kSide = TileSet::kSide;
constexpr std::int32_t kNoTile = -1, kNotYet = -2;
constexpr float kDiagonal = 1.41421356F;
// As neighbour_steps.
constexpr std::array<std::int32_t, 8> kX{1, 0, -1, 0, 1, -1, -1, 1}, kY{0, 1, 0, -1, 1, 1, -1, -1};

/// Share of the clearance at its ends that a straight line keeps, so that it leaves the middle of
/// a road by little.
constexpr double kStraightShare = 0.9;

/// Clearance of a cell from the obstacle's edge, in cells.
float clearance_of(std::int32_t squared) { return std::sqrt(static_cast<float>(squared)) - 0.5F; }

bool is_at_side(std::int32_t place) {
  constexpr std::int32_t kLast = kSide - 1;
  const std::int32_t x = place % kSide, y = place / kSide % kSide;
  return x == 0 || y == 0 || x == kLast || y == kLast;
}

}  // namespace

std::vector<std::vector<CellIndex>> WaysToDoors::find(
    CellIndex centre, const std::vector<CellIndex>& doors, std::int32_t widest,
    const std::function<std::vector<std::int32_t>()>& tiles) {
  std::vector<std::vector<CellIndex>> ways;
  bool boxed = false;
  for (const CellIndex door : doors) {
    const bool wide = ground_.squared(door) >= least_ && ground_.squared(centre) >= least_;
    ways.push_back(wide ? straight(door, centre) : std::vector<CellIndex>{});
    if (!wide || !ways.back().empty()) continue;
    if (!boxed) {
      box_tiles(region_of(centre), tiles());
      const float clearance = clearance_of(ground_.squared(centre)), most = clearance_of(widest);
      goal_ = {static_cast<float>(ground_.column(centre) + 1 - left_ * kSide),
               static_cast<float>(ground_.row(centre) + 1 - bottom_ * kSide),
               clearance,
               std::log(clearance),
               most,
               std::log(most)};
      boxed = true;
    }
    ways.back() = search(door, centre);
  }
  return ways;
}

void WaysToDoors::box_tiles(std::int32_t region, const std::vector<std::int32_t>& tiles) {
  const std::int32_t across = (ground_.stride() + kSide - 1) / kSide;
  std::int32_t right = 0, top = 0;
  left_ = bottom_ = INT32_MAX;
  for (const std::int32_t tile : tiles) {
    left_ = std::min(left_, tile % across), right = std::max(right, tile % across);
    bottom_ = std::min(bottom_, tile / across), top = std::max(top, tile / across);
  }
  --left_, --bottom_;  // a margin of tiles without the region
  region_ = region;
  across_ = right - left_ + 2;
  number_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(top - bottom_ + 2),
                 kNoTile);
  for (const std::int32_t tile : tiles)
    number_[static_cast<std::size_t>((tile / across - bottom_) * across_ + tile % across - left_)] =
        kNotYet;
  box_place_.clear();
  cells_.clear();
  back_.clear();
}

/// Which of the blocks of cells a tile of the box has become, or kNoTile.
std::int32_t WaysToDoors::block_at(std::int32_t box_place) {
  std::int32_t& number = number_[static_cast<std::size_t>(box_place)];
  if (number != kNotYet) return number;
  number = static_cast<std::int32_t>(box_place_.size());
  box_place_.push_back(box_place);
  const std::size_t first_place = cells_.size();
  cells_.resize(first_place + kSide * kSide, {kWall, kUnreached, 0, kUnreached});
  back_.resize(cells_.size());
  const std::int32_t across = (ground_.stride() + kSide - 1) / kSide;
  const std::int32_t tile = (box_place / across_ + bottom_) * across + box_place % across_ + left_;
  Cell* row = cells_.data() + first_place;
  geometry_.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
    std::int32_t name = 0;
    bool own = false;
    for (std::int32_t i = 0; i < count; ++i) {
      const CellIndex cell = first + i;
      if (names_[cell] != name) name = names_[cell], own = set_.of(name) == region_;
      if (own && ground_.squared(cell) >= least_)
        row[i].slowness = 0.5F / clearance_of(ground_.squared(cell));
    }
    row += kSide;
  });
  return number;
}

std::int32_t WaysToDoors::place_of(CellIndex cell) {
  const std::int32_t x = ground_.column(cell) + 1, y = ground_.row(cell) + 1;
  const std::int32_t block = block_at((y / kSide - bottom_) * across_ + x / kSide - left_);
  return (block * kSide + y % kSide) * kSide + x % kSide;
}

/// The place beside one, or kNoTile where the region has no cell in the tile there.
std::int32_t WaysToDoors::beside(std::int32_t place, std::int32_t dx, std::int32_t dy) {
  const std::int32_t x = place % kSide + dx, y = place / kSide % kSide + dy;
  if (x >= 0 && y >= 0 && x < kSide && y < kSide) return place + dy * kSide + dx;
  const auto over = [](std::int32_t at) { return at < 0 ? -1 : at >= kSide ? 1 : 0; };
  const std::int32_t from = box_place_[static_cast<std::size_t>(place / (kSide * kSide))];
  const std::int32_t block = block_at(from + over(y) * across_ + over(x));
  if (block == kNoTile) return kNoTile;
  return (block * kSide + (y + kSide) % kSide) * kSide + (x + kSide) % kSide;
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

/// A lower bound of what is left of a way. Clearance grows by no more than one goes, so between
/// clearances a and b that are L apart a way costs at least what it does if the clearance is
/// min(a + s, widest, b + L - s) after a length of s, which is ln(p^2 / (a b)) with p = (a + b + L)
/// / 2, and more where p is beyond the widest; and by the triangle inequality no step costs less
/// than it takes off this.
float WaysToDoors::least_cost_on(std::int32_t place) const {
  const std::int32_t box = box_place_[static_cast<std::size_t>(place / (kSide * kSide))];
  const auto x = static_cast<float>((box % across_) * kSide + place % kSide);
  const auto y = static_cast<float>((box / across_) * kSide + place / kSide % kSide);
  const float own = 0.5F / cells_[static_cast<std::size_t>(place)].slowness;
  const float dx = x - goal_.x, dy = y - goal_.y;
  const float p = 0.5F * (std::sqrt(dx * dx + dy * dy) + own + goal_.clearance);
  const float half =
      p < goal_.widest ? std::log(p) : goal_.log_widest + (p - goal_.widest) / goal_.widest;
  return std::max(0.0F, 2 * half - goal_.log_clearance - std::log(own));
}

/// From the door, where it is narrow: there the bound is worst, and there are the fewest cells.
std::vector<CellIndex> WaysToDoors::search(CellIndex door, CellIndex centre) {
  // Any width will do that is more than rounding. A step costs as much as the narrowest cells at
  // most, and takes the same off what is left at most.
  const float slowest = 0.5F / clearance_of(least_);
  const float to_bucket = clearance_of(ground_.squared(centre));
  const auto bucket_of = [&](float cost) { return static_cast<std::size_t>(cost * to_bucket); };
  const std::size_t count = bucket_of(2 * kDiagonal * 2 * slowest) + 8;
  for (auto& left : buckets_) left.clear();
  buckets_.resize(std::max(count, buckets_.size()));
  const std::int32_t first = place_of(door), last = place_of(centre);
  cells_[static_cast<std::size_t>(first)].cost = 0;
  reached_.assign(1, first);
  std::size_t at = bucket_of(least_cost_on(first));
  buckets_[at % count].push_back(first);
  std::array<std::int32_t, 8> within{};  // places of the neighbours, but for cells at a tile's side
  for (std::size_t i = 0; i < 8; ++i) within[i] = kY[i] * kSide + kX[i];
  bool arrived = first == last;
  for (std::size_t waiting = 1; waiting > 0 && !arrived; ++at) {
    std::vector<std::int32_t>& now = buckets_[at % count];
    for (std::size_t k = 0; k < now.size(); ++k) {
      const std::int32_t place = now[k];
      Cell& here = cells_[static_cast<std::size_t>(place)];
      if (here.gone_on == here.cost) continue;
      here.gone_on = here.cost;
      const Cell own = here;  // there may be more blocks soon
      const bool at_side = is_at_side(place);
      for (std::size_t i = 0; i < 8; ++i) {
        const std::int32_t next = at_side ? beside(place, kX[i], kY[i]) : place + within[i];
        if (next == kNoTile) continue;
        Cell& there = cells_[static_cast<std::size_t>(next)];
        if (there.slowness == kWall) continue;
        const float total = own.cost + (i < 4 ? 1.0F : kDiagonal) * (own.slowness + there.slowness);
        if (total > there.cost) continue;
        // Of equally good ways the one that is kept does not depend on which is found first.
        std::uint8_t& back = back_[static_cast<std::size_t>(next)];
        if (total == there.cost) {
          back = std::min(back, static_cast<std::uint8_t>(i));
          continue;
        }
        back = static_cast<std::uint8_t>(i);
        if (there.cost == kUnreached) {
          reached_.push_back(next);
          there.left = least_cost_on(next);
        }
        there.cost = total;
        buckets_[std::max(at, bucket_of(total + there.left)) % count].push_back(next);
        ++waiting;
      }
    }
    waiting -= now.size();
    now.clear();
    const float cost = cells_[static_cast<std::size_t>(last)].cost;
    arrived = cost != kUnreached && bucket_of(cost) < at;  // rounding may cost one bucket
  }
  std::vector<CellIndex> way;
  if (cells_[static_cast<std::size_t>(last)].cost != kUnreached) {
    const auto steps = neighbour_steps(ground_.stride());
    CellIndex cell = centre;
    for (; cell != door; cell -= steps[back_[static_cast<std::size_t>(place_of(cell))]])
      way.push_back(cell);
    way.push_back(door);
    std::reverse(way.begin(), way.end());
  }
  for (const std::int32_t place : reached_) {
    Cell& cell = cells_[static_cast<std::size_t>(place)];
    cell.cost = cell.gone_on = kUnreached;
  }
  return way;
}

}  // namespace stope::topology
