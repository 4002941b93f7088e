#pragma once

#include <vector>

#include "plugins/planner/shortcut_ground.hpp"

namespace stope::planner {

/// A chain of lines between the same ends, pulled straight wherever a line of sight may take the
/// place of what lies between and is no dearer.
std::vector<Vector2> pulled_straight(ShortcutGround& ground, std::vector<Vector2> points);

}  // namespace stope::planner
