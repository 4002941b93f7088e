#pragma once

#include <vector>

#include "plugins/planner/clearance_field.hpp"
#include "stope/geometry.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

/// A planned path as a line without repeated points, by distance along it.
class RouteLine {
 public:
  /// Throws Error, a sentence, if the path has fewer than two different points or one that is not
  /// finite.
  explicit RouteLine(const Path& path);

  /// The line's first `along` metres.
  RouteLine until(double along) const;

  /// The line between two distances along it, at least a millimetre apart.
  RouteLine between(double from, double to) const;

  double length() const { return along_.back(); }
  Vector2 at(double along) const;
  /// Radians, of the line from `along` to `ahead` metres further (or to its end).
  double heading(double along, double ahead) const;
  /// The distance along the line of the place nearest to a point, looked for between two distances.
  double nearest(const Vector2& point, double from, double to) const;
  MapBox box() const;
  /// Places along the line, `apart` metres from each other or less, both ends among them.
  std::vector<Vector2> places(double apart) const;

 private:
  RouteLine() = default;
  std::size_t segment(double along) const;
  std::vector<Vector2> points_;
  std::vector<double> along_;
};

}  // namespace stope::planner
