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

#include "plugins/planner/hybrid_search.hpp"
#include "plugins/planner/refusal.hpp"
#include "plugins/planner/steer_along.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

constexpr double kWeights[] = {50, 500};
constexpr double kSpans[] = {20, 45, 90};  // metres before and behind an obstruction
constexpr double kAround = 45;             // metres around a span that a search may use
constexpr int kFewRepairs = 20;            // and one more for each 10 m

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

Pose2 pose_at(const DriveCurve& curve, double along) { return part_of(curve, along, along).start; }

class RouteDriver {
 public:
  RouteDriver(const RouteLine& line, const OccupancyGrid& grid, const ElevationGrid* elevation,
              const DriveRequest& request, const std::function<void(std::string_view)>& say,
              const std::function<void()>& checkpoint)
      : line_(line),
        grid_(grid),
        elevation_(elevation),
        request_(request),
        say_(say),
        checkpoint_(checkpoint),
        field_(grid, line.box(), kAround + 2 * request.vehicle.length),
        ground_(request.vehicle, grid, field_, elevation) {}

  DriveCurve drive() {
    const Pose2 start = choose_start();
    const Pose2 goal = choose_goal();
    auto first = steer_along(line_, start, request_.vehicle, 8);
    DriveCurve curve;
    if (first) {
      curve = smooth(*first, line_, goal, request_.wishes, 40);
      if (!arrived(curve, goal)) {
        // Far from a good drive the shortcut of wide bends can lead astray: first hold to the line,
        // then let go.
        CurveWishes held = request_.wishes;
        held.off_line *= 50;
        curve = smooth(*first, line_, goal, held, 100);
        if (arrived(curve, goal)) curve = smooth(curve, line_, goal, request_.wishes, 40);
      }
      if (arrived(curve, goal) && !ground_.first_obstruction(curve)) return curve;
    }
    if (!first || !arrived(curve, goal)) curve = straight_guess(start, goal);
    return repaired(curve, goal);
  }

 private:
  /// A heading near a wish in which the truck can stand; `turns` are of 10 degrees.
  std::optional<Pose2> standing(const Vector2& place, double wish, int turns) const {
    for (int turn = 0; turn <= turns; ++turn) {
      for (const double side : {1.0, -1.0}) {
        const Pose2 pose{place.x(), place.y(), wish + side * turn * M_PI / 18};
        if (!ground_.obstruction_at(pose)) return pose;
      }
    }
    return std::nullopt;
  }

  [[noreturn]] void refuse_standing(const char* which, const Pose2& pose) const {
    const Obstruction why = *ground_.obstruction_at(pose);
    const std::string where = text_of_place(pose.x, pose.y);
    if (why.kind == Obstruction::Kind::kFootprint) {
      throw Error(fmt::format(
          "the truck cannot stand at the {} {}: its footprint of {:.1f} x {:.1f} m with a margin "
          "of "
          "{:.2f} m would touch an obstacle at {}, heading {:.0f} degrees",
          which, where, request_.vehicle.length, request_.vehicle.width, request_.vehicle.margin,
          text_of_place(why.obstacle.x(), why.obstacle.y()), pose.yaw * 180 / M_PI));
    }
    throw Error(fmt::format("the truck cannot stand at the {}: {}", which,
                            refusal(line_, why, request_.vehicle, 0)));
  }

  Pose2 choose_start() {
    const Vector2 place = line_.at(0);
    const double suggested = line_.heading(0, 10);
    if (request_.start_heading) {
      const Pose2 pose{place.x(), place.y(), *request_.start_heading};
      if (ground_.obstruction_at(pose)) refuse_standing("start", pose);
      return pose;
    }
    const auto pose = standing(place, suggested, 18);
    if (!pose) refuse_standing("start", {place.x(), place.y(), suggested});
    return *pose;
  }

  std::optional<Pose2> standing_at_end(const Vector2& place, double wish) const {
    const Pose2 pose{place.x(), place.y(), wish};
    if (!ground_.obstruction_at(pose)) return pose;
    return request_.goal_heading ? std::nullopt : standing(place, wish, 2);
  }

  /// The last place along the route where the truck has room; the line is cut there.
  Pose2 choose_goal() {
    const double length = line_.length();
    const double wish =
        request_.goal_heading.value_or(line_.heading(std::max(0.0, length - 10), 10));
    const double most = std::min(request_.goal_tolerance, length / 2);
    for (double back = 0; back <= most; back += 0.5) {
      auto pose = standing_at_end(line_.at(length - back), wish);
      if (!pose) continue;
      if (back == 0) return *pose;
      // Not the very last place at which it stands: half a metre makes arriving easier.
      if (const auto easier = standing_at_end(line_.at(length - back - 0.5), wish))
        pose = easier, back += 0.5;
      say_(
          fmt::format("the truck has no room at the route's end: the way ends {:.1f} m earlier, at "
                      "{}",
                      back, text_of_place(pose->x, pose->y)));
      line_ = line_.until(length - back);
      return *pose;
    }
    const Vector2 place = line_.at(length);
    refuse_standing("goal", {place.x(), place.y(), wish});
  }

  DriveCurve smooth(const DriveCurve& first, const RouteLine& line, const Pose2& goal,
                    const CurveWishes& wishes, int most_rounds) const {
    CurveRequest request;
    request.most_rounds = most_rounds;
    request.free_heading = !request_.start_heading.has_value();
    request.goal = {goal.x, goal.y};
    request.goal_heading = request_.goal_heading;
    DriveCurve curve = first;
    for (const double weight : kWeights) {
      request.obstacle_weight = weight;
      curve = optimize_curve(curve, line, request_.vehicle, field_, request, wishes, checkpoint_);
      if (arrived(curve, goal) && !ground_.first_obstruction(curve)) break;
    }
    return curve;
  }

  bool arrived(const DriveCurve& curve, const Pose2& goal) const {
    constexpr double kNear = 0.25, kTurned = 0.02;
    const Pose2 end = curve.end();
    return std::hypot(end.x - goal.x, end.y - goal.y) < kNear &&
           (!request_.goal_heading ||
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

  std::vector<Pose2> goals_at(const DriveCurve& curve, double along, const Pose2& goal) const {
    if (along >= curve.length() - 1e-6) {
      std::vector<Pose2> goals{goal};
      if (request_.goal_heading) return goals;
      for (const double turn : {0.3, -0.3, 0.6, -0.6, 1.0, -1.0, M_PI})
        goals.push_back({goal.x, goal.y, goal.yaw + turn});
      return goals;
    }
    const Pose2 pose = pose_at(curve, along);
    if (!ground_.obstruction_at(pose)) return {pose};
    return {};
  }

  HybridResult search(const DriveCurve& curve, double from, const std::vector<Pose2>& goals,
                      const Drivability& ground, double radius, std::size_t most) const {
    const Pose2 start = pose_at(curve, from);
    MapBox box{start.x, start.y, start.x, start.y};
    for (const Pose2& goal : goals) {
      box.left = std::min(box.left, goal.x), box.right = std::max(box.right, goal.x);
      box.bottom = std::min(box.bottom, goal.y), box.top = std::max(box.top, goal.y);
    }
    const ClearanceField around(grid_, box, kAround);
    return hybrid_search(start, goals, ground, around, {request_.allow_reverse, radius, most},
                         checkpoint_);
  }

  DriveCurve repaired(DriveCurve curve, const Pose2& goal) {
    int repairs = 0;
    const int most = kFewRepairs + static_cast<int>(line_.length() / 10);
    for (auto obstruction = obstruction_of(curve, goal); obstruction;
         obstruction = obstruction_of(curve, goal)) {
      if (++repairs > most || !repair(curve, *obstruction, goal)) refuse(curve, *obstruction, goal);
    }
    const DriveCurve polished = polish(curve, goal);
    return polished.pieces.empty() ? curve : polished;
  }

  std::optional<Obstruction> obstruction_of(const DriveCurve& curve, const Pose2& goal) const {
    if (auto found = ground_.first_obstruction(curve)) return found;
    if (!arrived(curve, goal))
      return Obstruction{Obstruction::Kind::kTurn, curve.length(), curve.end(), 0, Vector2::Zero()};
    return std::nullopt;
  }

  bool repair(DriveCurve& curve, const Obstruction& obstruction, const Pose2& goal) const {
    const double length = curve.length();
    for (const double span : kSpans) {
      const double from = std::max(0.0, obstruction.along - span);
      for (double to = obstruction.along + span;; to += 5) {
        const auto goals = goals_at(curve, std::min(to, length), goal);
        if (goals.empty() && to < obstruction.along + span + 30) continue;
        if (goals.empty()) break;
        const auto most = static_cast<std::size_t>(span * 300);
        const auto found =
            search(curve, from, goals, ground_, request_.vehicle.turning_radius, most);
        if (!found.curve) break;
        DriveCurve spliced = part_of(curve, 0, from);
        append(spliced, *found.curve);
        append(spliced, part_of(curve, std::min(to, length), length));
        curve = std::move(spliced);
        return true;
      }
    }
    return false;
  }

  /// The whole smoothed once more along its own line; empty if that cannot be driven.
  DriveCurve polish(const DriveCurve& curve, const Pose2& goal) const {
    if (!only_forwards(curve)) return {};
    const RouteLine own(path_of(curve));
    const auto first = steer_along(own, curve.start, request_.vehicle, 4);
    if (!first) return {};
    const Pose2 end = curve.end();
    DriveCurve smoothed = smooth(*first, own, {end.x, end.y, goal.yaw}, request_.wishes, 40);
    if (!arrived(smoothed, goal) || ground_.first_obstruction(smoothed)) return {};
    return smoothed;
  }

  /// Finds out what is in the way: slopes, a turn too tight, or no room at all.
  [[noreturn]] void refuse(const DriveCurve& curve, Obstruction obstruction,
                           const Pose2& goal) const {
    const double from = std::max(0.0, obstruction.along - kSpans[1]);
    double to = std::min(curve.length(), obstruction.along + kSpans[1]);
    std::vector<Pose2> goals = goals_at(curve, to, goal);
    for (int i = 0; i < 6 && goals.empty(); ++i)
      goals = goals_at(curve, std::min(curve.length(), to += 5), goal);
    constexpr std::size_t kMost = 8000;
    const auto passes = [&](double radius, const ElevationGrid* elevation) {
      Vehicle vehicle = request_.vehicle;
      vehicle.turning_radius = radius;
      const Drivability ground(vehicle, grid_, field_, elevation);
      return !goals.empty() && search(curve, from, goals, ground, radius, kMost).curve.has_value();
    };
    const double radius = request_.vehicle.turning_radius;
    const bool slope = obstruction.kind == Obstruction::Kind::kGrade ||
                       obstruction.kind == Obstruction::Kind::kNoElevation;
    double needs = 0;
    if (!slope || !passes(radius, nullptr)) {
      double high = radius;
      for (const double share : {0.7, 0.45, 0.25}) {
        if (passes(share * radius, elevation_)) {
          needs = share * radius;
          break;
        }
        high = share * radius;
      }
      for (int i = 0; needs > 0 && i < 3; ++i) {
        const double middle = (needs + high) / 2;
        (passes(middle, elevation_) ? needs : high) = middle;
      }
    }
    if (obstruction.kind == Obstruction::Kind::kTurn) {
      // The drive itself was too tight or ended elsewhere: what the truck would touch if it drove
      // on as it can is the reason.
      const Footprint& footprint = ground_.footprint();
      const auto touch =
          footprint.first_touch(part_of(curve, obstruction.along, obstruction.along + 20));
      obstruction.obstacle =
          touch ? touch->obstacle : Vector2(obstruction.pose.x, obstruction.pose.y);
    }
    throw Error(refusal(line_, obstruction, request_.vehicle, needs));
  }

  RouteLine line_;
  const OccupancyGrid& grid_;
  const ElevationGrid* elevation_;
  const DriveRequest& request_;
  const std::function<void(std::string_view)>& say_;
  const std::function<void()>& checkpoint_;
  const ClearanceField field_;
  const Drivability ground_;
};

}  // namespace

DriveCurve drive_route(const RouteLine& line, const OccupancyGrid& grid,
                       const ElevationGrid* elevation, const DriveRequest& request,
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
  return RouteDriver(line, grid, elevation, request, say, checkpoint).drive();
}

}  // namespace stope::planner
