#pragma once

#include <span>
#include <vector>

namespace stope {

/// Chances adjusted for having looked at several measures at once (Holm 1979): if those below 0.05
/// are believed, the chance that any of them is a false alarm is below 0.05. In the order given.
std::vector<double> holm(std::span<const double> probabilities);

}  // namespace stope
