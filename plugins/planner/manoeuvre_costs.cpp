#include "plugins/planner/manoeuvre_costs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/planner/dubins_words.hpp"
#include "plugins/planner/reeds_shepp_words.hpp"

namespace stope::planner {
namespace {

constexpr double kReverseFactor = 2, kCusp = 25, kBend = 0.15, kSteer = 0.3, kTight = 1;
constexpr double kComfort = 2;  // metres of clearance beyond which walls do not matter

}  // namespace

double ManoeuvreCosts::of(const CurvePiece& piece, const CurvePiece& before,
                          const Pose2& end) const {
  const double bend = std::abs(piece.curvature) * turning_radius_;
  const double tight = std::clamp(1 - footprint_.quick_clearance(end) / kComfort, 0.0, 1.0);
  double cost = std::abs(piece.length) * (1 + kBend * bend + kTight * tight);
  if (piece.length < 0) cost *= kReverseFactor;
  cost += kSteer * std::abs(piece.curvature - before.curvature) * turning_radius_;
  if (before.length != 0 && (before.length < 0) != (piece.length < 0)) cost += kCusp;
  return cost;
}

double ManoeuvreCosts::of(const SteeringWord& word, bool backwards) const {
  double cost = 0, bend = 0;
  for (std::size_t i = 0; i < word.steer.size() && word.steer[i] != 0; ++i) {
    const bool back = word.length[i] < 0;
    const double now = word.steer[i] == 'S' ? 0 : word.steer[i] == 'L' ? 1 : -1;
    cost += std::abs(word.length[i]) * turning_radius_ * (1 + kBend * std::abs(now)) *
                (back ? kReverseFactor : 1) +
            kSteer * std::abs(now - bend) + (back != backwards ? kCusp : 0);
    bend = now, backwards = back;
  }
  return cost;
}

std::vector<SteeringWord> ManoeuvreCosts::words_to(const Pose2& from, const Pose2& goal) const {
  return allow_reverse_ ? reeds_shepp_words(from, goal, turning_radius_)
                        : dubins_words(from, goal, turning_radius_);
}

double ManoeuvreCosts::without_walls(const Pose2& from, bool backwards_before,
                                     const std::vector<Pose2>& goals, double enough) const {
  double least = std::numeric_limits<double>::infinity();
  const std::size_t stride = std::max<std::size_t>(1, goals.size() / 3);
  for (std::size_t i = 0; i < goals.size() && least > enough; i += stride) {
    for (const SteeringWord& word : words_to(from, goals[i]))
      least = std::min(least, of(word, backwards_before));
  }
  return std::isfinite(least) ? least : 0;
}

}  // namespace stope::planner
