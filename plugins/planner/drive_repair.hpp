#pragma once

#include <optional>

#include "plugins/planner/drive_site.hpp"
#include "plugins/planner/refusal.hpp"

namespace stope::planner {

/// What of a curve was driven anew, in metres along it as it is now.
struct DrivenAnew {
  double from = 0, to = 0;
};

/// Drives anew what is obstructed, forwards only or also backwards: from some way before an
/// obstruction of a curve to some way behind it, farther and farther. `goal` is where the curve is
/// to end. None if no way was found; the curve is as it was then.
std::optional<DrivenAnew> repair_drive(const DriveSite& site, DriveCurve& curve,
                                       const Obstruction& obstruction, const Pose2& goal,
                                       bool reverse);

/// What would help where that failed.
Remedies remedies_at(const DriveSite& site, const DriveCurve& curve, const Obstruction& obstruction,
                     const Pose2& goal);

}  // namespace stope::planner
