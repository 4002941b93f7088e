#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/route_miles.hpp"
#include "plugins/planner/speed_profile.hpp"
#include "stope/stope.hpp"

namespace stope::planner {

class ReedsShepp final
    : public Map<Path(Path, OccupancyGrid, Optional<ElevationGrid>, Optional<StampedPose>)> {
 public:
  struct Params : Vehicle, SpeedLimits {
    std::optional<std::vector<double>> start, goal, goal_area;
    std::optional<double> start_heading, goal_heading;
    bool allow_reverse = true;
    double join_within = 60;
    double step = 0.5;
  } params;

  static void describe(About<ReedsShepp>& about) {
    about
        .summary(
            "Drives the first and the last mile: from where a truck stands onto a drivable path, "
            "and "
            "from the path to where it is to stand.")
        .from(
            "Reeds and Shepp 1990; Dubins 1957; Dolgov, Thrun, Montemerlo and Diebel 2010 (hybrid "
            "A*)")
        .notes(
            "It comes after planner/smooth, with the same truck. Arcs of the turning radius and "
            "straights, with reversing where allowed; the truck stands where its wheels must turn. "
            "The outline with its margin, swept along both miles, touches nothing; what lies "
            "between "
            "them stays as it is. Wire a pose, or give start with start_heading; give goal or "
            "goal_area. What is not given stays the path's own end.")
        .ports("drive", "grid", "elevation", "pose", "path")
        .param("start", &Params::start, "m", count(2, 2),
               "Where the middle of the rear axle stands, [x, y] in the map frame.")
        .param("start_heading", &Params::start_heading, "rad", any(),
               "How the truck stands at the start, counter-clockwise from east.")
        .param("goal", &Params::goal, "m", count(2, 2),
               "Where the middle of the rear axle is to stand, [x, y] in the map frame.")
        .param("goal_area", &Params::goal_area, "m", count(6, 200),
               "A polygon in which the middle of the rear axle is to stand, [x, y, x, y, …].")
        .param("goal_heading", &Params::goal_heading, "rad", any(),
               "How the truck is to stand at the goal; without it one of eight headings.")
        .param("allow_reverse", &Params::allow_reverse, "Whether the truck may drive backwards.")
        .param("join_within", &Params::join_within, "m", at_least(0.0),
               "How far from its ends the path may be joined and left.")
        .param("step", &Params::step, "m", between(kLeastStep, 1.0),
               "Greatest distance between points.");
    describe_speeds(about);
    describe_vehicle(about);
  }

  Path apply(const Path& path, const OccupancyGrid& grid, const Optional<ElevationGrid>& elevation,
             const Optional<StampedPose>& pose, Context& context) const {
    check_vehicle(params);
    MileRequest request;
    request.vehicle = params;
    request.limits = params;
    request.allow_reverse = params.allow_reverse;
    request.join_within = params.join_within;
    request.step = params.step;
    if (pose) {
      const Vector3& at = pose->T_map_lidar.translation;
      request.start = {at.x(), at.y(), pose->T_map_lidar.yaw()};
    } else if (params.start) {
      if (!params.start_heading)
        throw Error("start is given without start_heading: a truck's first mile depends on both");
      request.start = {(*params.start)[0], (*params.start)[1], *params.start_heading};
    }
    if (params.goal && params.goal_area)
      throw Error("goal and goal_area are both given: give one of them");
    if (params.goal_area) {
      request.goals = poses_in(*params.goal_area, params.goal_heading);
      request.goal_area = {*params.goal_area, params.goal_heading};
    }
    if (params.goal) {
      for (int turn = 0; turn < (params.goal_heading ? 1 : 8); ++turn) {
        request.goals.push_back({(*params.goal)[0], (*params.goal)[1],
                                 params.goal_heading.value_or(turn * std::numbers::pi / 4)});
      }
    }
    return add_miles(
        path, grid, elevation ? &*elevation : nullptr, request,
        [&](std::string_view sentence) { context.info(sentence); },
        [&] { context.stop_if_cancelled(); });
  }
};

STOPE_STAGE(ReedsShepp, "planner/reeds_shepp")

}  // namespace stope::planner
