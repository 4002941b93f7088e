#include "plugins/planner/drive_guess.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {
namespace {

constexpr double kAstray = 15;  // metres beside the line

}  // namespace

DriveCurve straight_guess(const RouteLine& line, const Pose2& start, const Pose2& goal) {
  DriveCurve curve{start, {}};
  Pose2 pose = start;
  for (double along = 1; along <= line.length(); along += 1) {
    const Vector2 next = along + 1 > line.length() ? Vector2(goal.x, goal.y) : line.at(along);
    const Vector2 way = next - Vector2(pose.x, pose.y);
    if (way.norm() < 1e-3) continue;
    const double turn = std::remainder(std::atan2(way.y(), way.x()) - pose.yaw, 2 * M_PI);
    if (std::abs(turn) > 1e-6) curve.pieces.push_back({1e-3, turn / 1e-3, turn / 1e-3});
    curve.pieces.push_back({way.norm(), 0, 0});
    pose = {next.x(), next.y(), pose.yaw + turn};
  }
  return curve;
}

DriveGuess back_to_line(const DriveCurve& curve, const Obstruction& obstruction,
                        const RouteLine& line, const Pose2& goal) {
  const Pose2& pose = obstruction.pose;
  DriveGuess guess{part_of(curve, 0, obstruction.along), obstruction};
  // No farther than was driven: another leg of the line may be nearer.
  const double most = std::min(line.length(), obstruction.along + kAstray);
  const double along = line.nearest({pose.x, pose.y}, 0, most);
  if (along + 1 < line.length())
    append(guess.curve, straight_guess(line.between(along, line.length()), pose, goal));
  return guess;
}

std::optional<Obstruction> obstruction_or_stray(const DriveSite& site, const DriveCurve& curve,
                                                const RouteLine& line, const DriveEnds& ends) {
  const auto obstruction = obstruction_of(site, curve, ends);
  if (!obstruction) return std::nullopt;
  constexpr double kBack = 5, kOn = 20;  // metres along the line, for a metre driven
  double foot = 0;
  for (const CurvePlace& place : places_along(curve, 1)) {
    if (place.along >= obstruction->along) break;
    const Vector2 at(place.pose.x, place.pose.y);
    foot = line.nearest(at, std::max(0.0, foot - kBack), std::min(line.length(), foot + kOn));
    if ((line.at(foot) - at).norm() > kAstray)
      return Obstruction{Obstruction::Kind::kTurn, place.along, place.pose, 0, Vector2::Zero()};
  }
  return obstruction;
}

}  // namespace stope::planner
