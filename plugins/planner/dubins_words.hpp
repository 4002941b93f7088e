#pragma once

#include <vector>

#include "plugins/planner/steering_word.hpp"

namespace stope::planner {

/// Every word of Dubins' six (1957) between two poses: forwards only. Shortest first, equals by
/// name.
std::vector<SteeringWord> dubins_words(const Pose2& from, const Pose2& to, double radius);

}  // namespace stope::planner
