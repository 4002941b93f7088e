#pragma once

#include <optional>

#include "plugins/planner/drive_guess.hpp"

namespace stope::planner {

/// A way along a line, or as much of it as could be driven.
struct DrivenInParts {
  DriveCurve curve;                 ///< all of it, where it arrives
  std::optional<DriveGuess> stuck;  ///< where no way on was found
};

/// A way along a line that is smooth wherever it can be: part after part, with arcs and stops for
/// the wheels only about the places where smoothing fails, and reversing only where no way forwards
/// was found.
DrivenInParts drive_in_parts(const DriveSite& site, const RouteLine& line, const DriveEnds& ends);

}  // namespace stope::planner
