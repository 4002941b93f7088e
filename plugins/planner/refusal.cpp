#include "plugins/planner/refusal.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stope::planner {

std::string text_of_place(double x, double y) { return fmt::format("({:.2f}, {:.2f})", x, y); }

std::string text_of_place_on(const RouteLine& line, const Pose2& pose) {
  return fmt::format("at {}, {:.1f} m along the route", text_of_place(pose.x, pose.y),
                     line.nearest({pose.x, pose.y}, 0, line.length()));
}

namespace {

std::string how_sought(const Remedies& remedies) {
  return fmt::format("{}with any turning radius down to {:.1f} m{}",
                     remedies.reversing ? "forwards " : "", remedies.least_tried,
                     remedies.may_reverse ? ", nor by reversing" : "");
}

}  // namespace

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
  // A turn has no obstacle: nothing was touched, the truck would only end elsewhere.
  const bool touches = obstruction.kind == Obstruction::Kind::kFootprint;
  const std::string touching =
      fmt::format("the footprint would touch an obstacle at {}",
                  text_of_place(obstruction.obstacle.x(), obstruction.obstacle.y()));
  std::string why;
  if (remedies.radius > 0) {
    why = fmt::format("the turn needs a radius of {:.1f} m but the truck needs {:.1f} m{}{}",
                      remedies.radius, vehicle.turning_radius,
                      remedies.may_reverse ? ", and reversing does not help" : "",
                      touches ? "; with that " + touching : "");
  } else if (touches) {
    why = fmt::format(
        "{}: the truck is {:.1f} m wide and {:.1f} m long and keeps a margin of {:.2f} m, for "
        "which no way past was found {}",
        touching, vehicle.width, vehicle.length, vehicle.margin, how_sought(remedies));
  } else {
    why = fmt::format(
        "the route bends more tightly than the truck can turn ({:.1f} m), and no way from before "
        "the bend to behind it was found over the free ground around, {}",
        vehicle.turning_radius, how_sought(remedies));
  }
  if (remedies.reversing)
    return fmt::format("{}, {}: allow reversing (allow_reverse: true), with which a way was found",
                       where, why);
  return fmt::format("{}, {}{}", where, why,
                     remedies.radius > 0 ? ": choose a route with wider bends" : "");
}

}  // namespace stope::planner
