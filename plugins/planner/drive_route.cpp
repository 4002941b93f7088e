// Problem: turn a planned line into a way a truck can drive, or say where and why it cannot.
// Idea: a simple driver follows the line, and the optimizer smooths what comes out; mostly that is
// all. What the check then refuses is driven anew by a hybrid search from some way before it to
// some way behind, farther and farther, and the whole is smoothed once more. Nothing leaves here
// that the check has not passed. Cost: O(pieces) for each round of smoothing; a search where it
// fails.
#include "plugins/planner/drive_route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "plugins/planner/drive_repair.hpp"
#include "plugins/planner/refusal.hpp"
#include "plugins/planner/standing_places.hpp"
#include "plugins/planner/steer_along.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

constexpr double kWeights[] = {50, 500};
constexpr int kFewRepairs = 20;  // and one more for each 10 m

Path path_of(const DriveCurve& curve) {
  Path path;
  for (const CurvePlace& place : places_along(curve, 0.5)) {
    PathPoint point;
    point.x = place.pose.x, point.y = place.pose.y;
    path.points.push_back(point);
  }
  return path;
}

bool only_forwards(const DriveCurve& curve) {
  return std::none_of(curve.pieces.begin(), curve.pieces.end(),
                      [](const CurvePiece& piece) { return piece.length < 0; });
}

class RouteDriver {
 public:
  RouteDriver(const RouteLine& line, const DriveSite& site,
              const std::function<void(std::string_view)>& say)
      : line_(line), site_(site), say_(say) {}

  DriveCurve drive() {
    const Pose2 start = standing_start(site_, line_);
    const Pose2 goal = standing_goal(site_, line_, say_);
    auto first = steer_along(line_, start, site_.request.vehicle, 8);
    DriveCurve curve;
    if (first) {
      curve = smooth(*first, line_, goal, site_.request.wishes, 40);
      if (!arrived(curve, goal)) {
        // Far from a good drive the shortcut of wide bends can lead astray: first hold to the line,
        // then let go.
        CurveWishes held = site_.request.wishes;
        held.off_line *= 50;
        curve = smooth(*first, line_, goal, held, 100);
        if (arrived(curve, goal)) curve = smooth(curve, line_, goal, site_.request.wishes, 40);
      }
      if (arrived(curve, goal) && !site_.ground.first_obstruction(curve)) return curve;
    }
    if (first && arrived(curve, goal)) {
      if (const auto driven = repaired(curve, goal)) return *driven;
    }
    // The line itself: what comes out of smoothing can lead far into the walls.
    curve = straight_guess(start, goal);
    if (const auto driven = repaired(curve, goal)) return *driven;
    refuse(curve, *obstruction_of(curve, goal), goal);
  }

 private:
  DriveCurve smooth(const DriveCurve& first, const RouteLine& line, const Pose2& goal,
                    const CurveWishes& wishes, int most_rounds) const {
    CurveRequest request;
    request.most_rounds = most_rounds;
    request.free_heading = !site_.request.start_heading.has_value();
    request.goal = {goal.x, goal.y};
    request.goal_heading = site_.request.goal_heading;
    DriveCurve curve = first;
    for (const double weight : kWeights) {
      request.obstacle_weight = weight;
      curve = optimize_curve(curve, line, site_.request.vehicle, site_.field, request, wishes,
                             site_.checkpoint);
      if (arrived(curve, goal) && !site_.ground.first_obstruction(curve)) break;
    }
    return curve;
  }

  bool arrived(const DriveCurve& curve, const Pose2& goal) const {
    constexpr double kNear = 0.25, kTurned = 0.02;
    const Pose2 end = curve.end();
    return std::hypot(end.x - goal.x, end.y - goal.y) < kNear &&
           (!site_.request.goal_heading ||
            std::abs(std::remainder(end.yaw - goal.yaw, 2 * M_PI)) < kTurned);
  }

  /// Where smoothing did not arrive: the route's own line as if it could be driven, in straight
  /// pieces with jumps of heading taken as bends of a metre. The check refuses it at once, and the
  /// repair drives it anew piece by piece.
  DriveCurve straight_guess(const Pose2& start, const Pose2& goal) const {
    DriveCurve curve{start, {}};
    Pose2 pose = start;
    for (double along = 1; along <= line_.length(); along += 1) {
      const Vector2 next = along + 1 > line_.length() ? Vector2(goal.x, goal.y) : line_.at(along);
      const Vector2 way = next - Vector2(pose.x, pose.y);
      if (way.norm() < 1e-3) continue;
      const double turn = std::remainder(std::atan2(way.y(), way.x()) - pose.yaw, 2 * M_PI);
      if (std::abs(turn) > 1e-6) curve.pieces.push_back({1e-3, turn / 1e-3, turn / 1e-3});
      curve.pieces.push_back({way.norm(), 0, 0});
      pose = {next.x(), next.y(), pose.yaw + turn};
    }
    return curve;
  }

  /// Drives anew what cannot be driven, place by place; `curve` is left at the first where that
  /// fails.
  std::optional<DriveCurve> repaired(DriveCurve& curve, const Pose2& goal) const {
    int repairs = 0;
    const int most = kFewRepairs + static_cast<int>(line_.length() / 10);
    for (auto obstruction = obstruction_of(curve, goal); obstruction;
         obstruction = obstruction_of(curve, goal)) {
      if (++repairs > most || !repair_drive(site_, curve, *obstruction, goal)) return std::nullopt;
    }
    const DriveCurve polished = polish(curve, goal);
    return polished.pieces.empty() ? curve : polished;
  }

  std::optional<Obstruction> obstruction_of(const DriveCurve& curve, const Pose2& goal) const {
    if (auto found = site_.ground.first_obstruction(curve)) return found;
    if (!arrived(curve, goal))
      return Obstruction{Obstruction::Kind::kTurn, curve.length(), curve.end(), 0, Vector2::Zero()};
    return std::nullopt;
  }

  /// The whole smoothed once more along its own line; empty if that cannot be driven.
  DriveCurve polish(const DriveCurve& curve, const Pose2& goal) const {
    if (!only_forwards(curve)) return {};
    const RouteLine own(path_of(curve));
    const auto first = steer_along(own, curve.start, site_.request.vehicle, 4);
    if (!first) return {};
    const Pose2 end = curve.end();
    DriveCurve smoothed = smooth(*first, own, {end.x, end.y, goal.yaw}, site_.request.wishes, 40);
    if (!arrived(smoothed, goal) || site_.ground.first_obstruction(smoothed)) return {};
    return smoothed;
  }

  [[noreturn]] void refuse(const DriveCurve& curve, Obstruction obstruction,
                           const Pose2& goal) const {
    const Remedies remedies = remedies_at(site_, curve, obstruction, goal);
    if (obstruction.kind == Obstruction::Kind::kTurn) {
      // The drive itself was too tight or ended elsewhere: what the truck would touch if it drove
      // on as it can is the reason.
      const Footprint& footprint = site_.ground.footprint();
      const auto touch =
          footprint.first_touch(part_of(curve, obstruction.along, obstruction.along + 20));
      obstruction.obstacle =
          touch ? touch->obstacle : Vector2(obstruction.pose.x, obstruction.pose.y);
    }
    throw Error(refusal(line_, obstruction, site_.request.vehicle, remedies));
  }

  RouteLine line_;
  const DriveSite& site_;
  const std::function<void(std::string_view)>& say_;
};

}  // namespace

DriveCurve drive_route(const RouteLine& line, const OccupancyGrid& grid,
                       const ElevationGrid* elevation, const ClearanceField& field,
                       const DriveRequest& request,
                       const std::function<void(std::string_view)>& say,
                       const std::function<void()>& checkpoint) {
  for (double along = 0; along < line.length() + 1; along += 1) {
    const Vector2 place = line.at(std::min(along, line.length()));
    if (!grid.frame.cell_at(place.x(), place.y())) {
      throw Error(fmt::format(
          "the path leaves the map at {}, {:.1f} m along the route: are path and grid in the same "
          "frame?",
          text_of_place(place.x(), place.y()), std::min(along, line.length())));
    }
  }
  const DriveSite site{grid, elevation, field, request, checkpoint};
  return RouteDriver(line, site, say).drive();
}

}  // namespace stope::planner
