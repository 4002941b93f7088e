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

DriveCurve curve_of(const SteeringWord& word, const Pose2& from, double radius);

/// The pose that a word is to lead to, seen from where it begins: x ahead and y to the left, in
/// turning radii.
struct WordGoal {
  double x, y, yaw;
};
WordGoal goal_seen_from(const Pose2& from, const Pose2& to, double radius);

/// Lengths of arcs and straights that come to less are none.
constexpr double kNoLength = 1e-10;

/// Drives a word and adds it, with its total, if it arrives.
void keep_if_it_arrives(std::vector<SteeringWord>& words, SteeringWord word, const WordGoal& goal);
/// Shortest first, equals by name.
void sort_words(std::vector<SteeringWord>& words);

}  // namespace stope::planner
