// Problem: turn a planned line into a way a truck can drive, or say where and why it cannot.
// Idea: a simple driver follows the line, and the optimizer smooths what comes out; mostly that is
// all. Where it fails somewhere, the line is driven part by part, so that only the places that need
// it are driven otherwise. Nothing leaves here that the check has not passed.
// Cost: O(pieces) for each round of smoothing, and a few searches for each place where it fails.
#include "plugins/planner/drive_route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plugins/planner/drive_parts.hpp"
#include "plugins/planner/drive_repair.hpp"
#include "plugins/planner/drive_smoothing.hpp"
#include "plugins/planner/refusal.hpp"
#include "plugins/planner/standing_places.hpp"
#include "plugins/planner/steer_along.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

class RouteDriver {
 public:
  RouteDriver(const RouteLine& line, const DriveSite& site,
              const std::function<void(std::string_view)>& say)
      : line_(line), site_(site), say_(say) {}

  DriveCurve drive() {
    DriveEnds ends;
    ends.start = standing_start(site_, line_);
    ends.goal = standing_goal(site_, line_, say_);
    ends.free_heading = !site_.request.start_heading.has_value();
    ends.goal_heading = site_.request.goal_heading;
    const auto smooth = smoothed_along(site_, line_, ends);
    if (smooth && !obstruction_of(site_, *smooth, ends)) return *smooth;
    const DrivenInParts driven = drive_in_parts(site_, line_, ends);
    if (driven.stuck) refuse(*driven.stuck, ends.goal);
    return driven.curve;
  }

 private:
  [[noreturn]] void refuse(const DriveGuess& stuck, const Pose2& goal) const {
    Obstruction obstruction = stuck.obstruction;
    const Remedies remedies = remedies_at(site_, stuck.curve, obstruction, goal);
    if (obstruction.kind == Obstruction::Kind::kTurn) {
      // The line is too tight here: what the truck would touch if it followed as tightly as it can
      // is the reason, if it touches anything.
      if (const auto touch = touch_following(obstruction.pose)) {
        obstruction.kind = Obstruction::Kind::kFootprint;
        obstruction.obstacle = *touch;
      }
    }
    throw Error(refusal(line_, obstruction, site_.request.vehicle, remedies));
  }

  /// The obstacle that the truck meets within some metres from a pose if a simple driver follows
  /// the line from there.
  std::optional<Vector2> touch_following(const Pose2& pose) const {
    constexpr double kFollowed = 60;  // metres
    const double along = line_.nearest({pose.x, pose.y}, 0, line_.length());
    if (line_.length() - along < 1) return std::nullopt;
    const RouteLine ahead = line_.between(along, std::min(along + kFollowed, line_.length()));
    const auto driven = steer_along(ahead, pose, site_.request.vehicle, 4);
    if (!driven) return std::nullopt;
    const auto touch = site_.ground.footprint().first_touch(*driven);
    return touch ? std::optional(touch->obstacle) : std::nullopt;
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
