#include "plugins/planner/steering_word.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace stope::planner {
namespace {

bool arrives(const SteeringWord& word, const WordGoal& goal) {
  double x = 0, y = 0, yaw = 0, sine = 0, cosine = 1;
  for (std::size_t i = 0; i < word.steer.size() && word.steer[i] != 0; ++i) {
    if (word.steer[i] == 'S') {
      x += word.length[i] * cosine, y += word.length[i] * sine;
      continue;
    }
    const double side = word.steer[i] == 'L' ? 1 : -1;
    yaw += side * word.length[i];
    const double sine_before = sine, cosine_before = cosine;
    sine = std::sin(yaw), cosine = std::cos(yaw);
    x += side * (sine - sine_before), y += side * (cosine_before - cosine);
  }
  return std::hypot(x - goal.x, y - goal.y) < 1e-6 &&
         std::abs(std::remainder(yaw - goal.yaw, 2 * std::numbers::pi)) < 1e-6;
}

}  // namespace

std::string SteeringWord::name() const {
  std::string text;
  for (std::size_t i = 0; i < steer.size() && steer[i] != 0; ++i)
    text.append(1, steer[i]).append(length[i] < 0 ? "-" : "+");
  return text;
}

DriveCurve curve_of(const SteeringWord& word, const Pose2& from, double radius) {
  DriveCurve curve{from, {}};
  for (std::size_t i = 0; i < word.steer.size() && word.steer[i] != 0; ++i) {
    if (std::abs(word.length[i]) < kNoLength) continue;
    const double curvature = word.steer[i] == 'S' ? 0.0 : (word.steer[i] == 'L' ? 1 : -1) / radius;
    curve.pieces.push_back({word.length[i] * radius, curvature, curvature});
  }
  return curve;
}

WordGoal goal_seen_from(const Pose2& from, const Pose2& to, double radius) {
  const double dx = (to.x - from.x) / radius, dy = (to.y - from.y) / radius;
  const double c = std::cos(from.yaw), s = std::sin(from.yaw);
  return {c * dx + s * dy, -s * dx + c * dy,
          std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi)};
}

void keep_if_it_arrives(std::vector<SteeringWord>& words, SteeringWord word, const WordGoal& goal) {
  word.total = 0;
  for (const double length : word.length) word.total += std::abs(length);
  if (arrives(word, goal)) words.push_back(word);
}

void sort_words(std::vector<SteeringWord>& words) {
  std::sort(words.begin(), words.end(), [](const SteeringWord& a, const SteeringWord& b) {
    return std::tie(a.total, a.steer, a.length) < std::tie(b.total, b.steer, b.length);
  });
}

}  // namespace stope::planner
