#include "plugins/planner/goal_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stope/error.hpp"

namespace stope::planner {
namespace {

bool inside(const std::vector<double>& polygon, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 2; i < polygon.size(); j = i, i += 2) {
    const double xi = polygon[i], yi = polygon[i + 1], xj = polygon[j], yj = polygon[j + 1];
    if ((yi > y) != (yj > y) && x < xi + (y - yi) / (yj - yi) * (xj - xi)) in = !in;
  }
  return in;
}

}  // namespace

bool GoalArea::holds(const Pose2& pose) const {
  constexpr double kTurned = 0.02;  // radians, as planner/smooth arrives
  return !polygon.empty() && inside(polygon, pose.x, pose.y) &&
         (!heading ||
          std::abs(std::remainder(pose.yaw - *heading, 2 * std::numbers::pi)) < kTurned);
}

std::vector<Pose2> poses_in(const std::vector<double>& polygon, std::optional<double> heading) {
  if (polygon.size() < 6 || polygon.size() % 2 != 0)
    throw Error("the goal_area needs three corners or more, as x, y, x, y, …");
  for (const double number : polygon)
    if (!std::isfinite(number)) throw Error("the goal_area has a corner that is not finite");
  double left = polygon[0], right = left, bottom = polygon[1], top = bottom, x = 0, y = 0;
  for (std::size_t i = 0; i < polygon.size(); i += 2) {
    left = std::min(left, polygon[i]), right = std::max(right, polygon[i]);
    bottom = std::min(bottom, polygon[i + 1]), top = std::max(top, polygon[i + 1]);
    x += 2 * polygon[i] / static_cast<double>(polygon.size());
    y += 2 * polygon[i + 1] / static_cast<double>(polygon.size());
  }
  std::vector<Vector2> places;
  if (inside(polygon, x, y)) places.emplace_back(x, y);
  for (int i = 1; i < 8; ++i) {
    for (int j = 1; j < 8; ++j) {
      const Vector2 place(left + (right - left) * i / 8, bottom + (top - bottom) * j / 8);
      if (inside(polygon, place.x(), place.y())) places.push_back(place);
    }
  }
  if (places.empty())
    throw Error("the goal_area holds no place: give its corners in order around it");
  std::stable_sort(places.begin(), places.end(), [&](const Vector2& a, const Vector2& b) {
    return (a - Vector2(x, y)).squaredNorm() < (b - Vector2(x, y)).squaredNorm();
  });
  places.resize(std::min<std::size_t>(places.size(), heading ? 16 : 3));
  std::vector<Pose2> poses;
  for (const Vector2& place : places) {
    for (int turn = 0; turn < (heading ? 1 : 8); ++turn)
      poses.push_back({place.x(), place.y(), heading.value_or(turn * std::numbers::pi / 4)});
  }
  return poses;
}

}  // namespace stope::planner
