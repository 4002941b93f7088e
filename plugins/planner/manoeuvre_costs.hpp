#pragma once

#include <vector>

#include "plugins/planner/footprint.hpp"
#include "plugins/planner/steering_word.hpp"

namespace stope::planner {

/// What a truck's manoeuvres cost a hybrid search, in metres of straight driving: bends, turning
/// the wheels, walls that are near and reversing are dearer, a change of direction most of all.
class ManoeuvreCosts {
 public:
  ManoeuvreCosts(const Footprint& footprint, double turning_radius, bool allow_reverse)
      : footprint_(footprint), turning_radius_(turning_radius), allow_reverse_(allow_reverse) {}

  /// Of a piece that ends at a pose, driven after another one.
  double of(const CurvePiece& piece, const CurvePiece& before, const Pose2& end) const;
  /// Of a word, as if it were driven far from walls.
  double of(const SteeringWord& word, bool backwards_before) const;
  /// Words from one pose to another that the truck may drive.
  std::vector<SteeringWord> words_to(const Pose2& from, const Pose2& goal) const;
  /// What the cheapest word to any of some goals costs; 0 if there is none. Of many goals a few
  /// stand for the others: a guess that is a little too high does no harm. If it is no more than
  /// `enough`, anything up to that may be given.
  double without_walls(const Pose2& from, bool backwards_before, const std::vector<Pose2>& goals,
                       double enough) const;

 private:
  const Footprint& footprint_;
  const double turning_radius_;
  const bool allow_reverse_;
};

}  // namespace stope::planner
