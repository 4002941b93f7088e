#pragma once

#include <vector>

#include "plugins/planner/clearance_field.hpp"

namespace stope::planner {

/// How far each place of a clearance field is from the nearest of several goals, over cells whose
/// distance to obstacles is at least `clearance`: Dijkstra's search over 8-connected cells. Up to 8
/// % too long, as steps go in eight directions.
class FreeGroundDistance {
 public:
  FreeGroundDistance(const ClearanceField& field, const std::vector<Pose2>& goals,
                     double clearance);
  /// Metres; infinite where no goal can be reached.
  double at(double x, double y) const;

 private:
  const ClearanceField& field_;
  std::vector<float> metres_;
};

}  // namespace stope::planner
