#pragma once

#include <optional>

#include "plugins/planner/drive_smoothing.hpp"

namespace stope::planner {

/// A way along a line that is smooth wherever it can be: part after part, with arcs and stops for
/// the wheels only about the places where smoothing fails. None if one of them cannot be passed.
std::optional<DriveCurve> drive_in_parts(const DriveSite& site, const RouteLine& line,
                                         const DriveEnds& ends);

}  // namespace stope::planner
