#pragma once

namespace stope::benchmark {

/// Kills a comparison of 8 arms x 5 recordings with SIGKILL at random points of its time, goes on
/// with it, and prints how much was computed twice. False if anything differs from an undisturbed
/// comparison in a byte, if a stage ran again that the store had whole, or if more than 10 % of
/// what all stages take can have gone into doing things again.
bool kill_comparisons(int times);

}  // namespace stope::benchmark
