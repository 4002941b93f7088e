#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "plugins/planner/drivability.hpp"

namespace stope::planner {

struct HybridRules {
  bool allow_reverse = false;
  double turning_radius = 12;       ///< metres, of the arcs driven
  std::size_t most_poses = 150000;  ///< looked at before giving up
};

struct HybridResult {
  std::optional<DriveCurve> curve;  ///< none: no way was found
  Pose2 nearest;                    ///< the pose reached that was nearest to a goal by free ground
  std::size_t poses = 0;            ///< looked at
};

/// A way from a pose to one of several, over ground the truck may drive, with arcs of one radius,
/// of twice that, and straights; ends exactly in a goal. `field` bounds where it looks.
HybridResult hybrid_search(const Pose2& start, const std::vector<Pose2>& goals,
                           const Drivability& ground, const ClearanceField& field,
                           const HybridRules& rules, const std::function<void()>& checkpoint);

}  // namespace stope::planner
