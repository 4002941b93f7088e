#include "plugins/planner/standing_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "plugins/planner/refusal.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

/// A heading near a wish in which the truck can stand; `turns` are of 10 degrees.
std::optional<Pose2> standing(const DriveSite& site, const Vector2& place, double wish, int turns) {
  for (int turn = 0; turn <= turns; ++turn) {
    for (const double side : {1.0, -1.0}) {
      const Pose2 pose{place.x(), place.y(), wish + side * turn * M_PI / 18};
      if (!site.ground.obstruction_at(pose)) return pose;
    }
  }
  return std::nullopt;
}

[[noreturn]] void refuse_standing(const DriveSite& site, const RouteLine& line, const char* which,
                                  const Pose2& pose) {
  const Obstruction why = *site.ground.obstruction_at(pose);
  const std::string where = text_of_place(pose.x, pose.y);
  if (why.kind == Obstruction::Kind::kFootprint) {
    throw Error(fmt::format(
        "the truck cannot stand at the {} {}: its footprint of {:.1f} x {:.1f} m with a margin "
        "of "
        "{:.2f} m would touch an obstacle at {}, heading {:.0f} degrees",
        which, where, site.request.vehicle.length, site.request.vehicle.width,
        site.request.vehicle.margin, text_of_place(why.obstacle.x(), why.obstacle.y()),
        pose.yaw * 180 / M_PI));
  }
  throw Error(fmt::format("the truck cannot stand at the {}: {}", which,
                          refusal(line, why, site.request.vehicle, {})));
}

std::optional<Pose2> standing_at_end(const DriveSite& site, const Vector2& place, double wish) {
  const Pose2 pose{place.x(), place.y(), wish};
  if (!site.ground.obstruction_at(pose)) return pose;
  return site.request.goal_heading ? std::nullopt : standing(site, place, wish, 2);
}

}  // namespace

Pose2 standing_start(const DriveSite& site, const RouteLine& line) {
  const Vector2 place = line.at(0);
  const double suggested = line.heading(0, 10);
  if (site.request.start_heading) {
    const Pose2 pose{place.x(), place.y(), *site.request.start_heading};
    if (site.ground.obstruction_at(pose)) refuse_standing(site, line, "start", pose);
    return pose;
  }
  const auto pose = standing(site, place, suggested, 18);
  if (!pose) refuse_standing(site, line, "start", {place.x(), place.y(), suggested});
  return *pose;
}

Pose2 standing_goal(const DriveSite& site, RouteLine& line,
                    const std::function<void(std::string_view)>& say) {
  const double length = line.length();
  const double wish =
      site.request.goal_heading.value_or(line.heading(std::max(0.0, length - 10), 10));
  const double most = std::min(site.request.goal_tolerance, length / 2);
  for (double back = 0; back <= most; back += 0.5) {
    auto pose = standing_at_end(site, line.at(length - back), wish);
    if (!pose) continue;
    if (back == 0) return *pose;
    // Not the very last place at which it stands: half a metre makes arriving easier.
    if (const auto easier = standing_at_end(site, line.at(length - back - 0.5), wish))
      pose = easier, back += 0.5;
    say(
        fmt::format("the truck has no room at the route's end: the way ends {:.1f} m earlier, at "
                    "{}",
                    back, text_of_place(pose->x, pose->y)));
    line = line.until(length - back);
    return *pose;
  }
  const Vector2 place = line.at(length);
  refuse_standing(site, line, "goal", {place.x(), place.y(), wish});
}

}  // namespace stope::planner
