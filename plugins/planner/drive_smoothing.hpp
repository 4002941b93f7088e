#pragma once

#include <optional>

#include "plugins/planner/drive_site.hpp"

namespace stope::planner {

/// What of a drive's ends is given to smoothing: none of the heading at the goal and of the wheels
/// at the start where those are left out.
struct DriveEnds {
  Pose2 start, goal;
  bool free_heading = false;  ///< the start's heading may be chosen
  std::optional<double> start_curvature, goal_heading;
};

/// Whether a curve ends at a goal: within a quarter of a metre and, if a heading is given, 0.02
/// rad.
bool arrives(const DriveCurve& curve, const DriveEnds& ends);

/// The first place where a curve cannot be driven, its end if that is not where it must arrive.
std::optional<Obstruction> obstruction_of(const DriveSite& site, const DriveCurve& curve,
                                          const DriveEnds& ends);

/// A curve smoothed along a line, obstacles pushed away from harder if that helps.
DriveCurve smoothed(const DriveSite& site, const DriveCurve& first, const RouteLine& line,
                    const DriveEnds& ends, const CurveWishes& wishes, int most_rounds);

/// A simple driver's way along a line, smoothed. It may end elsewhere or touch what it must not;
/// none if the driver does not come through.
std::optional<DriveCurve> smoothed_along(const DriveSite& site, const RouteLine& line,
                                         const DriveEnds& ends);

/// A curve smoothed once more along its own way; none if that cannot be driven or does not arrive.
std::optional<DriveCurve> smoothed_again(const DriveSite& site, const DriveCurve& curve,
                                         const DriveEnds& ends);

}  // namespace stope::planner
