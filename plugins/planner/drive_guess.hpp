#pragma once

#include <optional>

#include "plugins/planner/drive_smoothing.hpp"

namespace stope::planner {

/// A curve that is obstructed somewhere, to be driven anew there: what lies before it can be
/// driven, what lies behind says where to go on.
struct DriveGuess {
  DriveCurve curve;
  Obstruction obstruction;
};

/// The line itself as if it could be driven, in straight pieces with jumps of heading taken as
/// bends of a millimetre: a check refuses it where the line bends first.
DriveCurve straight_guess(const RouteLine& line, const Pose2& start, const Pose2& goal);

/// A smoothed curve until it is obstructed, and the line itself from there: where smoothing went
/// astray, so may all that lies behind.
DriveGuess back_to_line(const DriveCurve& curve, const Obstruction& obstruction,
                        const RouteLine& line, const Pose2& goal);

/// The first place where a smoothed curve is obstructed; one that is may have gone astray before,
/// and then that is the place.
std::optional<Obstruction> obstruction_or_stray(const DriveSite& site, const DriveCurve& curve,
                                                const RouteLine& line, const DriveEnds& ends);

}  // namespace stope::planner
