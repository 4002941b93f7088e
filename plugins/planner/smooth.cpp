#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "plugins/planner/drive_points.hpp"
#include "plugins/planner/drive_route.hpp"
#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/speed_profile.hpp"
#include "stope/stope.hpp"

namespace stope::planner {

class Smooth final : public Map<Path(Path, OccupancyGrid, Optional<ElevationGrid>)> {
 public:
  struct Params : Vehicle, SpeedLimits {
    std::optional<double> start_heading, goal_heading;
    double goal_tolerance = 5;
    bool allow_reverse = false;
    double comfortable_clearance = 3;
    double step = 0.5;
  } params;

  static void describe(About<Smooth>& about) {
    about
        .summary("Turns a planned path into a curve that a truck can drive, or says why it cannot.")
        .from(
            "Li and Todorov 2004 (iterative LQR); Tassa, Mansard and Todorov 2014 (limited "
            "controls); Dolgov, Thrun, Montemerlo and Diebel 2010 (hybrid A*)")
        .notes(
            "The path it gives is that of the rear axle's middle. Curvature never exceeds "
            "1 / turning_radius, heading is continuous, and the outline of the truck with its "
            "margin, "
            "swept along the way, touches no occupied or unknown cell and stays on the map. "
            "Curvature "
            "is continuous as well where that is possible; elsewhere the truck stands while its "
            "wheels turn. Clearance is that of the outline.")
        .ports("path", "grid", "elevation", "path")
        .param("start_heading", &Params::start_heading, "rad", any(),
               "How the truck stands at the start, counter-clockwise from east; without it as the "
               "route suggests.")
        .param("goal_heading", &Params::goal_heading, "rad", any(),
               "How the truck stands at the goal; without it as it comes.")
        .param("goal_tolerance", &Params::goal_tolerance, "m", at_least(0.0),
               "How much earlier the way may end where the truck has no room at the route's end.")
        .param("allow_reverse", &Params::allow_reverse,
               "Whether the truck may drive backwards where it cannot pass forwards.")
        .param("comfortable_clearance", &Params::comfortable_clearance, "m", at_least(0.0),
               "Beyond the margin, what the truck keeps from walls where there is room.")
        .param("step", &Params::step, "m", between(kLeastStep, 1.0),
               "Greatest distance between points.");
    describe_speeds(about);
    describe_vehicle(about);
  }

  Path apply(const Path& path, const OccupancyGrid& grid, const Optional<ElevationGrid>& elevation,
             Context& context) const {
    check_vehicle(params);
    const RouteLine line(path);
    DriveRequest request;
    request.vehicle = params;
    request.wishes.comfortable_clearance = params.comfortable_clearance;
    request.start_heading = params.start_heading;
    request.goal_heading = params.goal_heading;
    request.goal_tolerance = params.goal_tolerance;
    request.allow_reverse = params.allow_reverse;
    const ElevationGrid* heights = elevation ? &*elevation : nullptr;
    const ClearanceField field = field_around(line, grid, request);
    const DriveCurve curve = drive_route(
        line, grid, heights, field, request,
        [&](std::string_view sentence) { context.info(sentence); },
        [&] { context.stop_if_cancelled(); });
    const Drivability ground(params, grid, field, heights);
    Path driven;
    driven.edges = path.edges;
    driven.length = curve.length();
    driven.points = drive_points(curve, ground, heights, params.step);
    plan_speeds(driven.points, params, params);
    report(driven, curve, context);
    return driven;
  }

 private:
  static void report(const Path& path, const DriveCurve& curve, Context& context) {
    constexpr double kStraight = 1e-5;  // 1/m: bends wider than 100 km are none
    double tightest = 0, nearest = path.points.front().clearance;
    for (const PathPoint& point : path.points) {
      tightest = std::max(tightest, std::abs(point.curvature));
      nearest = std::min(nearest, point.clearance);
    }
    const std::size_t standstills = standstills_of(path.points);
    const std::size_t cusps = std::min(cusps_of(curve), standstills);
    context.info(fmt::format(
        "drivable: {:.1f} m, {}, the outline comes within {:.1f} m of an obstacle, {}", path.length,
        tightest > kStraight ? fmt::format("tightest bend {:.1f} m", 1 / tightest) : "no bend",
        nearest,
        standstills == 0
            ? "no standstills"
            : fmt::format("standstills: {} ({} to change direction, {} to turn the wheels)",
                          standstills, cusps, standstills - cusps)));
    constexpr double kFew = 5, kApart = 500;  // metres
    const auto turned = static_cast<double>(standstills - cusps);
    if (turned <= kFew + path.length / kApart) return;
    context.warn(fmt::format(
        "there are {} standstills to turn the wheels, one in {:.0f} m; a route with wider bends, a "
        "smaller turning_radius or a shorter steering_distance would let the truck drive through",
        turned, path.length / turned));
  }
};

STOPE_STAGE(Smooth, "planner/smooth")

}  // namespace stope::planner
