#pragma once

#include "plugins/planner/drive_site.hpp"
#include "plugins/planner/refusal.hpp"

namespace stope::planner {

/// Drives anew what is obstructed: from some way before an obstruction of a curve to some way
/// behind it, farther and farther. `goal` is where the curve is to end. Whether a way was found;
/// the curve is as it was if not.
bool repair_drive(const DriveSite& site, DriveCurve& curve, const Obstruction& obstruction,
                  const Pose2& goal);

/// What would help where that failed.
Remedies remedies_at(const DriveSite& site, const DriveCurve& curve, const Obstruction& obstruction,
                     const Pose2& goal);

}  // namespace stope::planner
