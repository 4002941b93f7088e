#pragma once

#include <optional>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::planner {

/// Where a truck may stand at the end: anywhere in a polygon x, y, x, y, …
struct GoalArea {
  std::vector<double> polygon;    ///< metres; empty: there is none
  std::optional<double> heading;  ///< radians; none: any will do
  bool holds(const Pose2& pose) const;
};

/// Poses in a polygon (x, y, x, y, …), nearest to its middle first, in this heading or, without it,
/// in eight. Throws Error, a sentence, if it holds no place.
std::vector<Pose2> poses_in(const std::vector<double>& polygon, std::optional<double> heading);

}  // namespace stope::planner
