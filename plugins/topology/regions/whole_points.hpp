#pragma once

#include <cstdint>
#include <numeric>
#include <span>

#include "plugins/topology/regions/convex_hull.hpp"

namespace stope::topology {

/// How many whole points a convex polygon holds, sides included, by Pick's theorem (1899): its
/// area, half the points on its sides, and one. Its corners, of which there is one at least, run
/// counter-clockwise; one or two stand for a point or a line.
inline std::int64_t whole_points_in(std::span<const HullPoint> corners) {
  std::int64_t twice_area = 0, on_sides = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const HullPoint &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
    twice_area += cross(corners.front(), a, b);
    on_sides += std::gcd(b.x - a.x, b.y - a.y);
  }
  return (twice_area + on_sides) / 2 + 1;
}

}  // namespace stope::topology
