#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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

/// A convex hull that points are added to one by one: what a point outside would add is the
/// triangle of it and its two tangents, less what the hull holds already.
class GrowingHull {
 public:
  void start(std::span<const HullPoint> points);
  /// The triangle that a point would add; none (false) if the hull holds the point.
  struct Addition {
    std::array<HullPoint, 3> triangle;
    std::size_t first = 0, count = 0;  ///< the sides that would go, from corner `first`
  };
  bool see(const HullPoint& point, Addition& addition) const;
  void add(const HullPoint& point, const Addition& addition);
  const std::vector<HullPoint>& corners() const { return corners_; }

 private:
  std::vector<HullPoint> corners_;
};

}  // namespace stope::topology
