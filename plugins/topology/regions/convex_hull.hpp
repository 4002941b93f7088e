#pragma once

#include <cstdint>
#include <vector>

namespace stope::topology {

/// A cell's centre in whole cells.
struct HullPoint {
  std::int32_t x = 0, y = 0;
  bool operator==(const HullPoint&) const = default;
};

/// Twice the signed area of the triangle: positive if a, b, c run counter-clockwise.
inline std::int64_t cross(const HullPoint& a, const HullPoint& b, const HullPoint& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Corners of the convex hull, counter-clockwise from the lowest left one, without those on a
/// straight side (Graham 1972, in Andrew's 1979 order). One point or two give themselves.
std::vector<HullPoint> convex_hull(std::vector<HullPoint> points);

/// The convex hull of the corners of two convex hulls. Cost: linear in them, for each has its
/// corners in order already.
std::vector<HullPoint> joined_hull(const std::vector<HullPoint>& a,
                                   const std::vector<HullPoint>& b);

}  // namespace stope::topology
