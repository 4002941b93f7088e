// Problem: a convex hull that grows by single cells, ring by ring, must tell whether it holds a
// cell, and which others a cell beside it would bring in.
// Idea: the hull knows first and last cell of each row. The sides that a new cell sees are looked
// for from where the last was added, and the cell takes their place. It brings in no other cell
// just if it is in the first line of cells beyond each of these sides (by Pick's theorem, 1899);
// this is so for most, and saves the walk along the new sides.
// Cost: the sides seen, and for cells that bring in others the rows of the new sides.
#include "plugins/topology/regions/growing_hull.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "plugins/topology/regions/ring_table.hpp"

namespace stope::topology {
namespace {

std::int32_t steps_between(const HullPoint& a, const HullPoint& b) {
  return std::gcd(b.x - a.x, b.y - a.y);
}

}  // namespace

void GrowingHull::reach(std::int32_t rows) {
  if (rows <= reach_) return;
  const std::int32_t more = std::max(rows, 2 * reach_) - reach_;
  rows_.insert(rows_.begin(), static_cast<std::size_t>(more), Row());
  rows_.insert(rows_.end(), static_cast<std::size_t>(more), Row());
  reach_ += more;
}

void GrowingHull::start(std::int32_t radius) {
  reach(radius);
  for (std::int32_t y = low_; y <= high_; ++y) rows_[place(y)] = Row();
  low_ = -radius, high_ = radius;
  corners_.clear();
  unused_.clear();
  // The right half from below; Andrew's chain, as the rows are in order.
  for (std::int32_t y = low_; y <= high_; ++y) {
    const HullPoint point{disc_reach(radius, y), y};
    rows_[place(y)] = {-point.x, point.x};
    while (corners_.size() > 1 &&
           cross(corners_[corners_.size() - 2].point, corners_.back().point, point) <= 0)
      corners_.pop_back();
    corners_.push_back({point});
  }
  if (radius > 0)
    for (std::size_t i = corners_.size(); i-- > 0;)
      corners_.push_back({{-corners_[i].point.x, corners_[i].point.y}});
  count_ = static_cast<std::int32_t>(corners_.size());
  for (std::int32_t i = 0; i < count_; ++i) {
    const std::int32_t next = (i + 1) % count_;
    set_side(i, next, steps_between(corner(i).point, corner(next).point));
  }
  at_ = 0;
}

GrowingHull::Addition GrowingHull::see(const HullPoint& point) {
  if (count_ == 1) return {at_, at_};
  if (count_ == 2 && seen_from(point, at_) == 0) {
    // Straight on: it takes the place of the nearer end.
    const auto distance = [&](std::int32_t end) {
      return std::abs(corner(end).point.x - point.x) + std::abs(corner(end).point.y - point.y);
    };
    const std::int32_t other = corner(at_).next;
    const std::int32_t end = distance(at_) < distance(other) ? at_ : other;
    return {end, end};
  }
  std::int32_t side = at_, back = at_;
  while (true) {
    if (seen_from(point, side) > 0) break;
    back = corner(back).before;
    if (seen_from(point, back) > 0) {
      side = back;
      break;
    }
    side = corner(side).next;
  }
  bool is_alone = point.y >= low_ - 1 && point.y <= high_ + 1;
  const auto is_seen = [&](std::int32_t which) {
    const std::int64_t area = seen_from(point, which);
    if (area <= 0) return false;
    is_alone = is_alone && area == corner(which).steps;
    return true;
  };
  Addition addition{side, corner(side).next};
  is_seen(side);
  while (is_seen(corner(addition.from).before)) addition.from = corner(addition.from).before;
  while (is_seen(addition.to)) addition.to = corner(addition.to).next;
  addition.is_alone = is_alone;
  return addition;
}

void GrowingHull::add(const HullPoint& point, const Addition& addition) {
  const bool is_straight = addition.from == addition.to;
  if (is_straight && count_ == 2) {
    corner(addition.from).point = point;
    const std::int32_t other = corner(addition.from).next;
    const std::int32_t steps = steps_between(point, corner(other).point);
    set_side(addition.from, other, steps);
    set_side(other, addition.from, steps);
  } else {
    for (std::int32_t i = corner(addition.from).next; !is_straight && i != addition.to;
         i = corner(i).next) {
      unused_.push_back(i);
      --count_;
    }
    const std::int32_t own = new_corner(point);
    set_side(addition.from, own, addition.steps_from);
    set_side(own, addition.to, addition.steps_to);
    at_ = own;
  }
  if (addition.is_alone) {
    Row& row = rows_[place(point.y)];
    row.first = std::min(row.first, point.x);
    row.last = std::max(row.last, point.x);
  }
  low_ = std::min(low_, point.y);
  high_ = std::max(high_, point.y);
}

void GrowingHull::give_back() {
  for (std::size_t i = before_.size(); i-- > 0;) rows_[place(before_[i].y)] = before_[i].row;
}

std::int32_t GrowingHull::new_corner(const HullPoint& point) {
  ++count_;
  if (unused_.empty()) {
    corners_.push_back({point});
    return static_cast<std::int32_t>(corners_.size()) - 1;
  }
  const std::int32_t at = unused_.back();
  unused_.pop_back();
  corner(at) = {point};
  return at;
}

void GrowingHull::set_side(std::int32_t from, std::int32_t to, std::int32_t steps) {
  Corner &a = corner(from), &b = corner(to);
  a.next = to, a.steps = steps;
  b.before = from;
}

std::vector<HullPoint> GrowingHull::corners() const {
  std::vector<HullPoint> all;
  for (std::int32_t at = at_, left = count_; left > 0; --left, at = corner(at).next)
    all.push_back(corner(at).point);
  return all;
}

}  // namespace stope::topology
