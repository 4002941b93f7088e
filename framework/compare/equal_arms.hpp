#pragma once

#include "framework/compare/comparison.hpp"

namespace stope {

/// Finds arms whose cells have the keys of an earlier arm's throughout: sets ComparedArm::same_as
/// and warns of each, once.
void note_equal_arms(Comparison& comparison);

}  // namespace stope
