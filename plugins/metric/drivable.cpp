#include <fmt/format.h>

#include "plugins/metric/drive_validity.hpp"
#include "plugins/metric/measure_list.hpp"
#include "stope/stope.hpp"

namespace stope::metric {
namespace {

/// Whether a point lies in a polygon given as x, y, x, y, …
bool inside(const std::vector<double>& polygon, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 2; i < polygon.size(); j = i, i += 2) {
    const double xi = polygon[i], yi = polygon[i + 1], xj = polygon[j], yj = polygon[j + 1];
    if ((yi > y) != (yj > y) && x < xi + (y - yi) / (yj - yi) * (xj - xi)) in = !in;
  }
  return in;
}

}  // namespace

class Drivable final : public Map<Measures(Path, OccupancyGrid, Optional<ElevationGrid>)> {
 public:
  struct Params : TruckLimits {
    std::optional<std::vector<double>> goal;
  } params;

  static void describe(About<Drivable>& about) {
    about.summary("Judges whether a truck can drive a path: bends, room for its outline, slopes.")
        .notes(
            "It shares no code with the planners. `drivable` is 1 if nothing is violated; counts "
            "say what is, the log says where first. Points are of the rear axle's middle, at most "
            "1 m apart.")
        .ports("path", "grid", "elevation", "measures")
        .param("turning_radius", &TruckLimits::turning_radius, "m", more_than(0.0),
               "Least radius of the way of the rear axle's middle.")
        .param("length", &TruckLimits::length, "m", more_than(0.0), "Length of the truck.")
        .param("width", &TruckLimits::width, "m", more_than(0.0), "Width of the truck.")
        .param("rear_overhang", &TruckLimits::rear_overhang, "m", at_least(0.0),
               "From the rear axle back to the tail.")
        .param("wheelbase", &TruckLimits::wheelbase, "m", more_than(0.0), "Between the axles.")
        .param("max_grade", &TruckLimits::max_grade, more_than(0.0),
               "Steepest slope between the axles, rise over run.")
        .param("margin", &TruckLimits::margin, "m", at_least(0.0),
               "What must stay free around the outline.")
        .param("goal", &Params::goal, "m", count(6, 1000),
               "A polygon x, y, x, y, … in which the path must end.");
  }

  Measures apply(const Path& path, const OccupancyGrid& grid,
                 const Optional<ElevationGrid>& elevation, Context& context) const {
    if (params.goal && params.goal->size() % 2 != 0)
      throw Error("the goal has an odd count of numbers: give a polygon as x, y, x, y, …");
    const DriveValidity found = check_drive(path, grid, elevation ? &*elevation : nullptr, params,
                                            [&] { context.stop_if_cancelled(); });
    if (!found.first.empty())
      context.warn(
          fmt::format("the path cannot be driven, {} places: {}", found.violations(), found.first));
    MeasureList list(fmt::format(
        "a truck of {} x {} m that turns with {} m, climbs {} and keeps {} m; looked at every {} m",
        params.length, params.width, params.turning_radius, params.max_grade, params.margin,
        kLook));
    list.add("drivable", found.violations() == 0 ? 1 : 0)
        .add("turn_violations", static_cast<double>(found.turns))
        .add("footprint_violations", static_cast<double>(found.touches))
        .add("grade_violations", static_cast<double>(found.slopes))
        .add("heading_violations", static_cast<double>(found.headings))
        .add("statement_violations", static_cast<double>(found.statements))
        .add("length", found.length, "m")
        .add("least_radius", found.least_radius, "m")
        .add("least_clearance", found.least_clearance, "m")
        .add("steepest_grade", found.steepest)
        .add("curvature_error", found.curvature_error, "1/m")
        .add("heading_error", found.heading_error, "rad")
        .add("lateral_acceleration", found.lateral_acceleration, "m/s^2")
        .add("direction_changes", static_cast<double>(found.cusps))
        .add("standstills", static_cast<double>(found.standstills));
    if (params.goal) {
      const PathPoint& end = path.points.back();
      list.add("reaches_goal", inside(*params.goal, end.x, end.y) ? 1 : 0);
    }
    return list.take();
  }
};

STOPE_STAGE(Drivable, "metric/drivable")

}  // namespace stope::metric
