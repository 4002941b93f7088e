// Problem: the shortest ways of a car that drives forwards only between two poses.
// Idea: Dubins (1957) proved that one of six words of two arcs and a straight or three arcs is the
// shortest; mirroring left and right leaves three formulas. Cost: constant.
#include "plugins/planner/dubins_words.hpp"

#include <cmath>
#include <numbers>

namespace stope::planner {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

std::vector<SteeringWord> dubins_words(const Pose2& from, const Pose2& to, double radius) {
  const WordGoal goal = goal_seen_from(from, to, radius);
  const auto round = [](double angle) {
    const double positive = std::fmod(angle, 2 * kPi);
    const double result = positive < 0 ? positive + 2 * kPi : positive;
    return result > 2 * kPi - kNoLength ? 0.0 : result;
  };
  std::vector<SteeringWord> words;
  for (const bool mirror : {false, true}) {
    const double y = mirror ? -goal.y : goal.y, yaw = mirror ? -goal.yaw : goal.yaw;
    const char left = mirror ? 'R' : 'L', right = mirror ? 'L' : 'R';
    // From the middle of the first arc to that of the last: turning to the same side, and not.
    const double same_x = goal.x - std::sin(yaw), same_y = y - 1 + std::cos(yaw);
    const double other_x = goal.x + std::sin(yaw), other_y = y - 1 - std::cos(yaw);
    const double same = std::hypot(same_x, same_y), other = std::hypot(other_x, other_y);
    const double angle = std::atan2(same_y, same_x), t = round(angle);
    keep_if_it_arrives(words, {{left, 'S', left}, {t, same, round(yaw - t)}, 0}, goal);
    if (other >= 2) {
      const double u = std::sqrt(other * other - 4);
      const double first = round(std::atan2(other_y, other_x) + std::atan2(2, u));
      keep_if_it_arrives(words, {{left, 'S', right}, {first, u, round(first - yaw)}, 0}, goal);
    }
    if (same <= 4) {
      const double half = std::asin(0.25 * same);
      // The middle arc is the long way round: the short one is never part of a shortest way.
      const double u = 2 * kPi - 2 * half;
      const double first = round(angle + kPi / 2 + (kPi / 2 - half));
      keep_if_it_arrives(words, {{left, right, left}, {first, u, round(yaw - first + u)}, 0}, goal);
    }
  }
  sort_words(words);
  return words;
}

}  // namespace stope::planner
