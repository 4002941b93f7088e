#pragma once

#include <cstdint>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::metric {

/// A true point and the found one that stands for it, by their places in the lists.
struct MatchedPair {
  std::uint32_t truth = 0, found = 0;
  double distance = 0;  ///< metres
};

/// Joins as many true points as can be with found points at most `within` metres away, each with
/// one only: a matching of greatest size, the same for the same lists. In the order of the true
/// points.
std::vector<MatchedPair> match_points(const std::vector<Vector2>& truth,
                                      const std::vector<Vector2>& found, double within);

}  // namespace stope::metric
