#include "plugins/planner/refusal.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stope::planner {

std::string text_of_place(double x, double y) { return fmt::format("({:.2f}, {:.2f})", x, y); }

std::string text_of_place_on(const RouteLine& line, const Pose2& pose) {
  return fmt::format("at {}, {:.1f} m along the route", text_of_place(pose.x, pose.y),
                     line.nearest({pose.x, pose.y}, 0, line.length()));
}

std::string refusal(const RouteLine& line, const Obstruction& obstruction, const Vehicle& vehicle,
                    const Remedies& remedies) {
  const std::string where = text_of_place_on(line, obstruction.pose);
  switch (obstruction.kind) {
    case Obstruction::Kind::kGrade:
      return fmt::format(
          "{}, the slope of {:.1f} % is over the truck's max_grade of {:.1f} %, and no way round "
          "it "
          "was found: choose a route over gentler roads or another truck",
          where, 100 * std::abs(obstruction.value), 100 * vehicle.max_grade);
    case Obstruction::Kind::kNoElevation:
      return fmt::format(
          "{}, the elevation is not known under the truck, so its grade cannot be judged: give an "
          "elevation that covers the route, or leave the input unwired to drive without",
          where);
    case Obstruction::Kind::kTurn:
    case Obstruction::Kind::kFootprint:
      break;
  }
  const std::string touches =
      fmt::format("the footprint would touch an obstacle at {}",
                  text_of_place(obstruction.obstacle.x(), obstruction.obstacle.y()));
  std::string why;
  if (remedies.radius > 0) {
    why = fmt::format(
        "the turn needs a radius of {:.1f} m but the truck needs {:.1f} m{}; with that {}",
        remedies.radius, vehicle.turning_radius,
        remedies.may_reverse ? ", and reversing does not help" : "", touches);
  } else {
    why = fmt::format(
        "{}: the truck is {:.1f} m wide and {:.1f} m long and keeps a margin of {:.2f} m, for "
        "which "
        "no way past was found {}",
        touches, vehicle.width, vehicle.length, vehicle.margin,
        remedies.may_reverse ? "with any turning radius, nor by reversing"
        : remedies.reversing ? "forwards with any turning radius"
                             : "with any turning radius");
  }
  if (remedies.reversing)
    return fmt::format("{}, {}: allow reversing (allow_reverse: true), with which a way was found",
                       where, why);
  return fmt::format("{}, {}{}", where, why,
                     remedies.radius > 0 ? ": choose a route with wider bends" : "");
}

}  // namespace stope::planner
