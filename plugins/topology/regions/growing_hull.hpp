#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "plugins/topology/regions/convex_hull.hpp"

namespace stope::topology {

/// A convex hull of cells around the cell (0, 0) that cells are added to one by one. It knows the
/// cells it holds by rows.
class GrowingHull {
 public:
  /// The disc of rings 0 … radius.
  void start(std::int32_t radius);
  /// From now on cells may be up to so many rows away.
  void reach(std::int32_t rows);

  bool holds(const HullPoint& point) const {
    const Row& row = rows_[place(point.y)];
    return point.x >= row.first && point.x <= row.last;
  }
  /// What a point outside would add.
  struct Addition {
    std::int32_t from = 0, to = 0;  ///< its tangents, counter-clockwise: the sides between them go
    bool is_alone = false;          ///< the hull would hold no other cell that it does not hold now
    std::int32_t steps_from = 1, steps_to = 1;  ///< from cell to cell on the sides that come
  };
  Addition see(const HullPoint& point);
  /// Before a point that is not alone is added: takes in its cells and calls
  /// visit(y, first x, last x) for them.
  template <class Visit>
  void take_cells(const HullPoint& point, Addition& addition, Visit visit) {
    before_.clear();
    widen_last(point.y, point.x, visit);
    widen_first(point.y, point.x, visit);
    addition.steps_from = take_side(corner(addition.from).point, point, visit);
    addition.steps_to = take_side(point, corner(addition.to).point, visit);
  }
  /// Gives back the cells that were taken last; then the point must not be added.
  void give_back();
  void add(const HullPoint& point, const Addition& addition);
  std::vector<HullPoint> corners() const;  ///< counter-clockwise

 private:
  /// The cells of a row between the sides; `first` may be last + 1 where the hull is thin.
  struct Row {
    std::int32_t first = std::numeric_limits<std::int32_t>::max();
    std::int32_t last = std::numeric_limits<std::int32_t>::min();
  };
  struct Corner {
    HullPoint point;
    std::int32_t next = 0, before = 0;  ///< counter-clockwise
    std::int32_t steps = 0;             ///< of the side to the next: from cell to cell on it
  };

  std::size_t place(std::int32_t y) const { return static_cast<std::size_t>(y + reach_); }
  Corner& corner(std::int32_t at) { return corners_[static_cast<std::size_t>(at)]; }
  const Corner& corner(std::int32_t at) const { return corners_[static_cast<std::size_t>(at)]; }
  /// Twice the area of the triangle of a side and a point that sees it from outside, else not
  /// above 0.
  std::int64_t seen_from(const HullPoint& point, std::int32_t side) const {
    return -cross(corner(side).point, corner(corner(side).next).point, point);
  }
  template <class Visit>
  void widen_first(std::int32_t y, std::int32_t x, Visit& visit) {
    Row& row = rows_[place(y)];
    if (x >= row.first) return;
    before_.push_back({y, row});
    const std::int32_t last = std::min(row.first - 1, row.last);
    row.first = x;
    if (x <= last) visit(y, x, last);
  }
  template <class Visit>
  void widen_last(std::int32_t y, std::int32_t x, Visit& visit) {
    Row& row = rows_[place(y)];
    if (x <= row.last) return;
    before_.push_back({y, row});
    const std::int32_t first = std::max(row.last + 1, row.first);
    row.last = x;
    if (first <= x) visit(y, first, x);
  }
  /// The rows strictly between the ends of a new side, what is inside being left of it. Gives the
  /// number of steps from cell to cell on it.
  template <class Visit>
  std::int32_t take_side(const HullPoint& from, const HullPoint& to, Visit& visit) {
    const bool rises = to.y > from.y;
    const HullPoint &low = rises ? from : to, &high = rises ? to : from;
    const std::int32_t height = high.y - low.y, width = high.x - low.x;
    if (height == 0) return std::abs(width);
    std::int32_t slant = width / height, part = width % height;
    if (part < 0) --slant, part += height;
    std::int32_t x = low.x, rest = 0, steps = 1;  // the side is at x + rest / height
    for (std::int32_t y = low.y + 1; y < high.y; ++y) {
      x += slant, rest += part;
      if (rest >= height) ++x, rest -= height;
      if (rest == 0) ++steps;
      if (rises) {
        widen_last(y, x, visit);
      } else {
        widen_first(y, rest > 0 ? x + 1 : x, visit);
      }
    }
    return steps;
  }
  std::int32_t new_corner(const HullPoint& point);
  void set_side(std::int32_t from, std::int32_t to, std::int32_t steps);

  std::vector<Corner> corners_;
  std::vector<std::int32_t> unused_;  ///< of those
  std::int32_t count_ = 0;
  std::int32_t at_ = 0;       ///< a corner near where something was added last
  std::vector<Row> rows_{1};  ///< from -reach_ to reach_
  std::int32_t reach_ = 0;
  std::int32_t low_ = 0, high_ = -1;  ///< rows that the hull has
  struct RowBefore {
    std::int32_t y = 0;
    Row row;
  };
  std::vector<RowBefore> before_;  ///< rows before their cells were taken, in that order
};

}  // namespace stope::topology
