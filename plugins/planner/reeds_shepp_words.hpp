#pragma once

#include <vector>

#include "plugins/planner/steering_word.hpp"

namespace stope::planner {

/// Every word of the 48 (Reeds and Shepp 1990) that leads from the first pose to the second, with
/// arcs of this radius, shortest first, equals by name. The first is the shortest way of all.
std::vector<SteeringWord> reeds_shepp_words(const Pose2& from, const Pose2& to, double radius);

}  // namespace stope::planner
