// Problem: turn a planned line into a way a truck can drive, or say where and why it cannot.
// Idea: a simple driver follows the line, and the optimizer smooths what comes out; mostly that is
// all. What the check then refuses is driven anew by a hybrid search from some way before it to
// some way behind, farther and farther, and the whole is smoothed once more. Where smoothing the
// whole fails, it is done part by part. Nothing leaves here that the check has not passed.
// Cost: O(pieces) for each round of smoothing; a search where it fails, twice where the truck may
// reverse and has to.
#include "plugins/planner/drive_route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plugins/planner/drive_parts.hpp"
#include "plugins/planner/drive_points.hpp"
#include "plugins/planner/drive_repair.hpp"
#include "plugins/planner/drive_smoothing.hpp"
#include "plugins/planner/refusal.hpp"
#include "plugins/planner/standing_places.hpp"
#include "plugins/planner/steer_along.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

constexpr int kFewRepairs = 20;  // and one more for each 10 m

std::size_t stops_of(const DriveCurve& curve) { return jumps_of(curve) + cusps_of(curve); }

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
    const bool arrived = smooth && arrives(*smooth, ends);
    if (arrived && !site_.ground.first_obstruction(*smooth)) return *smooth;
    // First without reversing: that it is allowed must not make a way worse.
    DriveRequest forwards = site_.request;
    forwards.allow_reverse = false;
    const DriveSite ahead{site_.grid, site_.elevation, site_.field, forwards, site_.checkpoint};
    for (const DriveSite* site : {&ahead, &site_}) {
      std::optional<DriveCurve> driven;
      if (arrived) {
        DriveCurve curve = *smooth;
        driven = repaired(*site, curve, ends);
      }
      if (!driven || stops_of(*driven) > 0) {
        const auto in_parts = drive_in_parts(*site, line_, ends);
        if (in_parts && (!driven || stops_of(*in_parts) < stops_of(*driven))) driven = in_parts;
      }
      if (driven) return *driven;
      if (!site_.request.allow_reverse) break;
    }
    // The line itself: what comes out of smoothing can lead far into the walls.
    DriveCurve curve = straight_guess(line_, ends.start, ends.goal);
    if (const auto driven = repaired(site_, curve, ends)) return *driven;
    refuse(curve, *obstruction_of(site_, curve, ends), ends.goal);
  }

 private:
  /// Drives anew what cannot be driven, place by place; `curve` is left at the first where that
  /// fails.
  std::optional<DriveCurve> repaired(const DriveSite& site, DriveCurve& curve,
                                     const DriveEnds& ends) const {
    int repairs = 0;
    const int most = kFewRepairs + static_cast<int>(line_.length() / 10);
    for (auto obstruction = obstruction_of(site_, curve, ends); obstruction;
         obstruction = obstruction_of(site_, curve, ends)) {
      if (++repairs > most || !repair_drive(site, curve, *obstruction, ends.goal))
        return std::nullopt;
    }
    DriveEnds own = ends;
    own.start = curve.start;
    return smoothed_again(site, curve, own).value_or(curve);
  }

  [[noreturn]] void refuse(const DriveCurve& curve, Obstruction obstruction,
                           const Pose2& goal) const {
    const Remedies remedies = remedies_at(site_, curve, obstruction, goal);
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
