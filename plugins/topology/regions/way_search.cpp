// Problem: the way of least length over clearance from a cell of a region to one or several others.
// Idea: Dijkstra's algorithm (1959) over the region's cells with buckets for a queue (Dial 1969).
// To one cell it is A* (Hart, Nilsson and Raphael 1968): clearance grows by no more than one goes,
// so between two clearances a distance costs at least so much, which keeps the search out of
// whatever is not on the way to a narrow place. Cost: linear in the cells looked at, at worst in
// the tiles a region has cells in.
#include "plugins/topology/regions/way_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace stope::topology {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity(), kWall = 0;
constexpr std::int32_t kSide = TileSet::kSide;
constexpr std::int32_t kNoTile = -1, kNotYet = -2;
constexpr float kDiagonal = 1.41421356F;
// As neighbour_steps.
constexpr std::array<std::int32_t, 8> kX{1, 0, -1, 0, 1, -1, -1, 1}, kY{0, 1, 0, -1, 1, 1, -1, -1};

/// Clearance of a cell from the obstacle's edge, in cells.
float clearance_of(std::int32_t squared) { return std::sqrt(static_cast<float>(squared)) - 0.5F; }

bool is_at_side(std::int32_t place) {
  constexpr std::int32_t kLast = kSide - 1;
  const std::int32_t x = place % kSide, y = place / kSide % kSide;
  return x == 0 || y == 0 || x == kLast || y == kLast;
}

}  // namespace

void WaySearch::enter(std::int32_t region, const std::vector<std::int32_t>& tiles) {
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
  reached_.clear();
}

/// Which of the blocks of cells a tile of the box has become, or kNoTile.
std::int32_t WaySearch::block_at(std::int32_t box_place) {
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

std::int32_t WaySearch::place_of(CellIndex cell) {
  const std::int32_t x = ground_.column(cell) + 1, y = ground_.row(cell) + 1;
  const std::int32_t block = block_at((y / kSide - bottom_) * across_ + x / kSide - left_);
  return (block * kSide + y % kSide) * kSide + x % kSide;
}

/// The place beside one, or kNoTile where the region has no cell in the tile there.
std::int32_t WaySearch::beside(std::int32_t place, std::int32_t dx, std::int32_t dy) {
  const std::int32_t x = place % kSide + dx, y = place / kSide % kSide + dy;
  if (x >= 0 && y >= 0 && x < kSide && y < kSide) return place + dy * kSide + dx;
  const auto over = [](std::int32_t at) { return at < 0 ? -1 : at >= kSide ? 1 : 0; };
  const std::int32_t from = box_place_[static_cast<std::size_t>(place / (kSide * kSide))];
  const std::int32_t block = block_at(from + over(y) * across_ + over(x));
  if (block == kNoTile) return kNoTile;
  return (block * kSide + (y + kSide) % kSide) * kSide + (x + kSide) % kSide;
}

/// A lower bound of what is left of a way. Clearance grows by no more than one goes, so between
/// clearances a and b that are L apart a way costs at least what it does if the clearance is
/// min(a + s, widest, b + L - s) after a length of s, which is ln(p^2 / (a b)) with p = (a + b + L)
/// / 2, and more where p is beyond the widest; and by the triangle inequality no step costs less
/// than it takes off this.
float WaySearch::least_cost_on(std::int32_t place) const {
  if (!goal_.is_one) return 0;
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

void WaySearch::towards(CellIndex from, CellIndex to, std::int32_t widest) {
  const float clearance = clearance_of(ground_.squared(to)), most = clearance_of(widest);
  goal_ = {true,
           static_cast<float>(ground_.column(to) + 1 - left_ * kSide),
           static_cast<float>(ground_.row(to) + 1 - bottom_ * kSide),
           clearance,
           std::log(clearance),
           most,
           std::log(most)};
  spread(from, {place_of(to)}, clearance);
}

void WaySearch::to_all(CellIndex from, const std::vector<CellIndex>& cells) {
  goal_ = {};
  std::vector<std::int32_t> wanted;
  for (const CellIndex cell : cells) wanted.push_back(place_of(cell));
  spread(from, std::move(wanted), clearance_of(ground_.squared(from)));
}

/// Buckets of any width will do that is more than rounding.
void WaySearch::spread(CellIndex from, std::vector<std::int32_t> wanted, float to_bucket) {
  for (const std::int32_t place : reached_) {
    Cell& cell = cells_[static_cast<std::size_t>(place)];
    cell.cost = cell.gone_on = kUnreached;
  }
  // A step costs as much as the narrowest cells at most, and takes the same off what is left at
  // most.
  const float slowest = 0.5F / clearance_of(least_);
  const auto bucket_of = [&](float cost) { return static_cast<std::size_t>(cost * to_bucket); };
  const std::size_t count = bucket_of(2 * kDiagonal * 2 * slowest) + 8;
  for (auto& bucket : buckets_) bucket.clear();
  buckets_.resize(std::max(count, buckets_.size()));
  from_ = from;
  const std::int32_t first = place_of(from);
  cells_[static_cast<std::size_t>(first)].cost = 0;
  reached_.assign(1, first);
  std::size_t at = bucket_of(least_cost_on(first));
  buckets_[at % count].push_back(first);
  std::array<std::int32_t, 8> within{};  // places of the neighbours, but for cells at a tile's side
  for (std::size_t i = 0; i < 8; ++i) within[i] = kY[i] * kSide + kX[i];
  for (std::size_t waiting = 1; waiting > 0 && !wanted.empty(); ++at) {
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
    std::erase_if(wanted, [&](std::int32_t place) {
      const float cost = cells_[static_cast<std::size_t>(place)].cost;
      return cost != kUnreached && bucket_of(cost) < at;  // rounding may cost one bucket
    });
  }
}

std::vector<CellIndex> WaySearch::way_back(CellIndex to) {
  std::vector<CellIndex> way;
  if (cells_[static_cast<std::size_t>(place_of(to))].cost == kUnreached) return way;
  const auto steps = neighbour_steps(ground_.stride());
  for (CellIndex cell = to; cell != from_;
       cell -= steps[back_[static_cast<std::size_t>(place_of(cell))]])
    way.push_back(cell);
  way.push_back(from_);
  return way;
}

}  // namespace stope::topology
