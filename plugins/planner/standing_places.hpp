#pragma once

#include <functional>
#include <string_view>

#include "plugins/planner/drive_site.hpp"

namespace stope::planner {

/// How the truck stands at the start of a route: as asked, or as the route suggests turned by as
/// little as makes room. Throws Error, a sentence, if it cannot stand there.
Pose2 standing_start(const DriveSite& site, const RouteLine& line);

/// The last place along a route where the truck has room, within the goal's tolerance; the line is
/// cut there, which is said. Throws Error, a sentence, if there is none.
Pose2 standing_goal(const DriveSite& site, RouteLine& line,
                    const std::function<void(std::string_view)>& say);

}  // namespace stope::planner
