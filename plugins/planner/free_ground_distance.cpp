#include "plugins/planner/free_ground_distance.hpp"

#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace stope::planner {

FreeGroundDistance::FreeGroundDistance(const ClearanceField& field, const std::vector<Pose2>& goals,
                                       double clearance)
    : field_(field),
      metres_(static_cast<std::size_t>(field.width()) * static_cast<std::size_t>(field.height()),
              std::numeric_limits<float>::infinity()) {
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const std::int32_t width = field.width(), height = field.height();
  const auto reach = [&](std::int32_t column, std::int32_t row, float metres) {
    const auto place = static_cast<std::uint32_t>(row * width + column);
    if (metres >= metres_[place]) return;
    metres_[place] = metres;
    queue.push({metres, place});
  };
  for (const Pose2& goal : goals) {
    const Vector2 at = field.to_field(goal.x, goal.y);
    if (at.x() >= 0 && at.y() >= 0 && at.x() < width && at.y() < height)
      reach(static_cast<std::int32_t>(at.x()), static_cast<std::int32_t>(at.y()), 0);
  }
  const auto straight = static_cast<float>(field.cell());
  const auto diagonal = static_cast<float>(field.cell() * std::numbers::sqrt2);
  while (!queue.empty()) {
    const auto [metres, place] = queue.top();
    queue.pop();
    if (metres > metres_[place]) continue;
    const auto column = static_cast<std::int32_t>(place) % width;
    const auto row = static_cast<std::int32_t>(place) / width;
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const std::int32_t c = column + dx, r = row + dy;
        if (c < 0 || r < 0 || c >= width || r >= height) continue;
        // Half a cell of mercy: the field errs by that.
        if (field.distance(c, r) < clearance - field.cell()) continue;
        reach(c, r, metres + (dx != 0 && dy != 0 ? diagonal : straight));
      }
    }
  }
}

double FreeGroundDistance::at(double x, double y) const {
  const Vector2 at = field_.to_field(x, y);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < field_.width() && at.y() < field_.height()))
    return std::numeric_limits<double>::infinity();
  return metres_[static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(field_.width()) +
                 static_cast<std::size_t>(at.x())];
}

}  // namespace stope::planner
