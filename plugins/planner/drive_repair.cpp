// Problem: somewhere along a drive the truck touches something, or would have to turn too tightly.
// Idea: a hybrid search drives anew from some metres before that place to as far behind it; if it
// finds nothing, from farther away. What would help is found out by searching as another truck
// would. Cost: one search for each distance, up to twelve for remedies.
#include "plugins/planner/drive_repair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plugins/planner/hybrid_search.hpp"

namespace stope::planner {
namespace {

constexpr double kSpans[] = {20, 45, 90};  // metres before and behind an obstruction
constexpr double kPosesPerMetre = 300;     // of a span: looked at before giving up

Pose2 pose_at(const DriveCurve& curve, double along) { return part_of(curve, along, along).start; }

/// Poses on a curve where the truck can stand, and how far along they are.
struct Goals {
  std::vector<Pose2> poses;
  std::vector<double> along;
  double along_of(const Pose2& reached) const {
    std::size_t best = 0;
    const auto off = [&](std::size_t i) {
      return std::hypot(poses[i].x - reached.x, poses[i].y - reached.y) +
             std::abs(std::remainder(poses[i].yaw - reached.yaw, 2 * M_PI));
    };
    for (std::size_t i = 1; i < poses.size(); ++i)
      if (off(i) < off(best)) best = i;
    return along[best];
  }
};

/// Places every 5 m from `from` along a curve on; at its end the goal, in other headings as well if
/// none is asked for.
Goals goals_behind(const DriveSite& site, const DriveCurve& curve, double from, const Pose2& goal) {
  constexpr double kApart = 5, kFarther = 30;  // metres
  Goals goals;
  const double length = curve.length();
  for (double along = from; along <= from + kFarther; along += kApart) {
    if (along < length - 1e-6) {
      const Pose2 pose = pose_at(curve, along);
      if (site.ground.obstruction_at(pose)) continue;
      goals.poses.push_back(pose);
      goals.along.push_back(along);
      continue;
    }
    for (const double turn : {0.0, 0.3, -0.3, 0.6, -0.6, 1.0, -1.0, M_PI}) {
      if (turn != 0 && site.request.goal_heading) break;
      goals.poses.push_back({goal.x, goal.y, goal.yaw + turn});
      goals.along.push_back(length);
    }
    break;
  }
  return goals;
}

HybridResult search(const DriveSite& site, const DriveCurve& curve, double from, const Goals& goals,
                    const Drivability& ground, const HybridRules& rules) {
  if (goals.poses.empty()) return {};
  const Pose2 start = pose_at(curve, from);
  MapBox box{start.x, start.y, start.x, start.y};
  for (const Pose2& goal : goals.poses) {
    box.left = std::min(box.left, goal.x), box.right = std::max(box.right, goal.x);
    box.bottom = std::min(box.bottom, goal.y), box.top = std::max(box.top, goal.y);
  }
  const ClearanceField around(site.grid, box, DriveSite::kAround);
  return hybrid_search(start, goals.poses, ground, around, rules, site.checkpoint);
}

}  // namespace

std::optional<DrivenAnew> repair_drive(const DriveSite& site, DriveCurve& curve,
                                       const Obstruction& obstruction, const Pose2& goal,
                                       bool reverse) {
  for (const double span : kSpans) {
    const double from = std::max(0.0, obstruction.along - span);
    const Goals goals = goals_behind(site, curve, obstruction.along + span, goal);
    const auto most = static_cast<std::size_t>(span * kPosesPerMetre);
    const auto found = search(site, curve, from, goals, site.ground,
                              {reverse, site.request.vehicle.turning_radius, most});
    if (!found.curve) continue;
    DriveCurve spliced = part_of(curve, 0, from);
    append(spliced, *found.curve);
    append(spliced, part_of(curve, goals.along_of(found.curve->end()), curve.length()));
    curve = std::move(spliced);
    return DrivenAnew{from, from + found.curve->length()};
  }
  return std::nullopt;
}

Remedies remedies_at(const DriveSite& site, const DriveCurve& curve, const Obstruction& obstruction,
                     const Pose2& goal) {
  const double from = std::max(0.0, obstruction.along - kSpans[1]);
  const Goals goals = goals_behind(site, curve, obstruction.along + kSpans[1], goal);
  constexpr std::size_t kMost = 8000;
  constexpr auto kMostBack = static_cast<std::size_t>(kSpans[1] * kPosesPerMetre);
  const auto passes = [&](double radius, const ElevationGrid* elevation, bool reverse) {
    Vehicle vehicle = site.request.vehicle;
    vehicle.turning_radius = radius;
    const Drivability ground(vehicle, site.grid, site.field, elevation);
    return search(site, curve, from, goals, ground, {reverse, radius, reverse ? kMostBack : kMost})
        .curve.has_value();
  };
  const double radius = site.request.vehicle.turning_radius;
  const bool slope = obstruction.kind == Obstruction::Kind::kGrade ||
                     obstruction.kind == Obstruction::Kind::kNoElevation;
  const bool may = site.request.allow_reverse;
  Remedies remedies{0, radius, may, !may && passes(radius, site.elevation, true)};
  if (slope && passes(radius, nullptr, may)) return remedies;
  double high = radius;
  double& tried = remedies.least_tried;
  for (const double share : {0.7, 0.45, 0.25, 0.12, 0.06, 0.03, 0.015}) {
    const double tighter = share * radius;
    if (tighter < site.request.vehicle.least_turning_radius()) break;
    tried = tighter;
    if (passes(tighter, site.elevation, false)) {
      remedies.radius = tighter;
      break;
    }
    high = tighter;
  }
  for (int i = 0; remedies.radius > 0 && i < 3; ++i) {
    const double middle = (remedies.radius + high) / 2;
    (passes(middle, site.elevation, false) ? remedies.radius : high) = middle;
  }
  return remedies;
}

}  // namespace stope::planner
