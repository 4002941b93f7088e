#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "plugins/planner/clearance_field.hpp"

namespace stope::planner {

/// How far each place of a clearance field is from the nearest of several goals, over cells whose
/// distance to obstacles is at least `clearance`: Dijkstra's search over 8-connected cells, which
/// goes on as far as it is asked. Up to 8 % too long, as steps go in eight directions. Keeps a
/// reference to the field.
class FreeGroundDistance {
 public:
  FreeGroundDistance(const ClearanceField& field, const std::vector<Pose2>& goals,
                     double clearance);
  /// Metres; infinite where no goal can be reached.
  double at(double x, double y);

 private:
  using Entry = std::pair<float, std::uint32_t>;
  void reach(std::int32_t column, std::int32_t row, float metres);
  void expand(float metres, std::uint32_t place);

  const ClearanceField& field_;
  const double clearance_;
  std::vector<float> metres_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace stope::planner
