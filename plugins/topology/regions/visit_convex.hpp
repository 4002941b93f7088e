#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "plugins/topology/regions/convex_hull.hpp"

namespace stope::topology {

inline std::int64_t floor_division(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient - ((a % b != 0) && ((a < 0) != (b < 0)) ? 1 : 0);
}

/// Calls visit(y, first x, last x) for the rows of whole points in a convex polygon, sides
/// included; its corners run counter-clockwise, and one or two stand for a point or a line.
template <class Visit>
void visit_convex(std::span<const HullPoint> corners, Visit&& visit) {
  std::int32_t low = corners[0].y, high = low, left = corners[0].x, right = left;
  for (const HullPoint& corner : corners) {
    low = std::min(low, corner.y);
    high = std::max(high, corner.y);
    left = std::min(left, corner.x);
    right = std::max(right, corner.x);
  }
  for (std::int32_t y = low; y <= high; ++y) {
    std::int64_t first = left, last = right;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const HullPoint &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
      // Inside is left of a -> b: (b.x - a.x) (y - a.y) - (b.y - a.y) (x - a.x) >= 0.
      const std::int64_t rise = std::int64_t{b.y} - a.y;
      const std::int64_t run = (std::int64_t{b.x} - a.x) * (std::int64_t{y} - a.y);
      if (rise > 0) {
        last = std::min(last, a.x + floor_division(run, rise));
      } else if (rise < 0) {
        first = std::max(first, a.x - floor_division(-run, rise));
      } else if (run < 0) {
        last = first - 1;
      }
    }
    if (first <= last) visit(y, static_cast<std::int32_t>(first), static_cast<std::int32_t>(last));
  }
}

}  // namespace stope::topology
