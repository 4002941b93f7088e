#pragma once

#include "plugins/metric/drive_validity.hpp"

namespace stope::metric {

/// The area of the parallelogram of two vectors, positive if `b` lies to the left of `a`.
inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The motion between two points of a path in a row, an arc.
struct PathMotion {
  double length = 0;     ///< metres, along the arc
  double turn = 0;       ///< radians
  double curvature = 0;  ///< 1/m, as the wheels stand
  double slide = 0;      ///< metres across the heading
  bool backwards = false;
};

/// From headings: how a truck gets from `a` to `b` if it turns evenly.
PathMotion motion_between(const PathPoint& a, const PathPoint& b);

/// From positions alone: 1/m of the circle through three points, 0 if two of them are the same.
double circle_through(const Vector2& a, const Vector2& b, const Vector2& c);

}  // namespace stope::metric
