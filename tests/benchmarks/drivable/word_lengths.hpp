#pragma once

namespace stope::testing {

/// Compares the shortest word of Reeds and Shepp with OMPL's distance on `pairs` random pairs of
/// poses and prints the greatest difference and both times.
void compare_with_ompl(int pairs);

}  // namespace stope::testing
