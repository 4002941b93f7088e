#pragma once

#include <array>
#include <string>
#include <vector>

#include "plugins/planner/drive_curve.hpp"

namespace stope::planner {

/// A word of Reeds and Shepp: up to five pieces, each full left, full right or straight.
struct SteeringWord {
  std::array<char, 5> steer{};     ///< 'L', 'R', 'S'; 0 after the last
  std::array<double, 5> length{};  ///< in turning radii (radians of an arc); negative: backwards
  double total = 0;                ///< sum of the magnitudes
  std::string name() const;        ///< such as "L+R-S-L-"
};

/// Every word of the 48 (Reeds and Shepp 1990) that leads from the first pose to the second, with
/// arcs of this radius, shortest first, equals by name. The first is the shortest way of all.
std::vector<SteeringWord> reeds_shepp_words(const Pose2& from, const Pose2& to, double radius);

/// Every word of Dubins' six (1957) between two poses: forwards only.
std::vector<SteeringWord> dubins_words(const Pose2& from, const Pose2& to, double radius);

DriveCurve curve_of(const SteeringWord& word, const Pose2& from, double radius);

}  // namespace stope::planner
