// Problem: a way that is smooth, arrives and keeps off obstacles, from a line that is none of it.
// Idea: a simple driver (pure pursuit) follows the line with the truck's limits; the optimizer
// improves what comes out, first gently, then with obstacles weighed heavier. Where that goes
// astray it is first held to the line, then let go.
// Cost: O(pieces) a round of the optimizer, up to 360 rounds.
#include "plugins/planner/drive_smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/planner/steer_along.hpp"

namespace stope::planner {
namespace {

constexpr double kWeights[] = {50, 500};

Path path_of(const DriveCurve& curve) {
  Path path;
  for (const CurvePlace& place : places_along(curve, 0.5)) {
    PathPoint point;
    point.x = place.pose.x, point.y = place.pose.y;
    path.points.push_back(point);
  }
  return path;
}

}  // namespace

bool arrives(const DriveCurve& curve, const DriveEnds& ends) {
  constexpr double kNear = 0.25, kTurned = 0.02;
  const Pose2 end = curve.end();
  return std::hypot(end.x - ends.goal.x, end.y - ends.goal.y) < kNear &&
         (!ends.goal_heading ||
          std::abs(std::remainder(end.yaw - *ends.goal_heading, 2 * M_PI)) < kTurned);
}

std::optional<Obstruction> obstruction_of(const DriveSite& site, const DriveCurve& curve,
                                          const DriveEnds& ends) {
  if (auto found = site.ground.first_obstruction(curve)) return found;
  if (!arrives(curve, ends))
    return Obstruction{Obstruction::Kind::kTurn, curve.length(), curve.end(), 0, Vector2::Zero()};
  return std::nullopt;
}

DriveCurve smoothed(const DriveSite& site, const DriveCurve& first, const RouteLine& line,
                    const DriveEnds& ends, const CurveWishes& wishes, int most_rounds) {
  CurveRequest request;
  request.most_rounds = most_rounds;
  request.free_heading = ends.free_heading;
  request.start_curvature_held = ends.start_curvature.has_value();
  request.goal = {ends.goal.x, ends.goal.y};
  request.goal_heading = ends.goal_heading;
  DriveCurve curve = first;
  for (const double weight : kWeights) {
    request.obstacle_weight = weight;
    curve = optimize_curve(curve, line, site.request.vehicle, site.field, request, wishes,
                           site.checkpoint);
    if (arrives(curve, ends) && !site.ground.first_obstruction(curve)) break;
  }
  return curve;
}

std::optional<DriveCurve> smoothed_along(const DriveSite& site, const RouteLine& line,
                                         const DriveEnds& ends) {
  const auto first =
      steer_along(line, ends.start, site.request.vehicle, 8, ends.start_curvature.value_or(0));
  if (!first) return std::nullopt;
  DriveCurve curve = smoothed(site, *first, line, ends, site.request.wishes, 40);
  if (arrives(curve, ends)) return curve;
  // Far from a good drive the shortcut of wide bends can lead astray: first hold to the line, then
  // let go.
  CurveWishes held = site.request.wishes;
  held.off_line *= 50;
  curve = smoothed(site, *first, line, ends, held, 100);
  if (arrives(curve, ends)) curve = smoothed(site, curve, line, ends, site.request.wishes, 40);
  return curve;
}

std::optional<DriveCurve> smoothed_again(const DriveSite& site, const DriveCurve& curve,
                                         const DriveEnds& ends) {
  const bool backwards = std::any_of(curve.pieces.begin(), curve.pieces.end(),
                                     [](const CurvePiece& piece) { return piece.length < 0; });
  if (backwards || curve.length() < 1) return std::nullopt;
  const RouteLine own(path_of(curve));
  const auto first =
      steer_along(own, curve.start, site.request.vehicle, 4, ends.start_curvature.value_or(0));
  if (!first) return std::nullopt;
  DriveCurve again = smoothed(site, *first, own, ends, site.request.wishes, 40);
  if (!arrives(again, ends) || site.ground.first_obstruction(again)) return std::nullopt;
  return again;
}

}  // namespace stope::planner
