#include "plugins/planner/free_ground_distance.hpp"

#include <limits>
#include <numbers>

namespace stope::planner {

FreeGroundDistance::FreeGroundDistance(const ClearanceField& field, const std::vector<Pose2>& goals,
                                       double clearance)
    : field_(field),
      clearance_(clearance),
      metres_(static_cast<std::size_t>(field.width()) * static_cast<std::size_t>(field.height()),
              std::numeric_limits<float>::infinity()) {
  for (const Pose2& goal : goals) {
    const Vector2 at = field.to_field(goal.x, goal.y);
    if (at.x() >= 0 && at.y() >= 0 && at.x() < field.width() && at.y() < field.height())
      reach(static_cast<std::int32_t>(at.x()), static_cast<std::int32_t>(at.y()), 0);
  }
}

void FreeGroundDistance::reach(std::int32_t column, std::int32_t row, float metres) {
  const auto place = static_cast<std::uint32_t>(row * field_.width() + column);
  if (metres >= metres_[place]) return;
  metres_[place] = metres;
  queue_.push({metres, place});
}

void FreeGroundDistance::expand(float metres, std::uint32_t place) {
  const auto straight = static_cast<float>(field_.cell());
  const auto diagonal = static_cast<float>(field_.cell() * std::numbers::sqrt2);
  const auto column = static_cast<std::int32_t>(place) % field_.width();
  const auto row = static_cast<std::int32_t>(place) / field_.width();
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      const std::int32_t c = column + dx, r = row + dy;
      if (c < 0 || r < 0 || c >= field_.width() || r >= field_.height()) continue;
      // Half a cell of mercy: the field errs by that.
      if (field_.distance(c, r) < clearance_ - field_.cell()) continue;
      reach(c, r, metres + (dx != 0 && dy != 0 ? diagonal : straight));
    }
  }
}

double FreeGroundDistance::at(double x, double y) {
  const Vector2 at = field_.to_field(x, y);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < field_.width() && at.y() < field_.height()))
    return std::numeric_limits<double>::infinity();
  const float& wanted =
      metres_[static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(field_.width()) +
              static_cast<std::size_t>(at.x())];
  while (!queue_.empty() && queue_.top().first < wanted) {
    const auto [metres, place] = queue_.top();
    queue_.pop();
    if (metres <= metres_[place]) expand(metres, place);
  }
  return wanted;
}

}  // namespace stope::planner
