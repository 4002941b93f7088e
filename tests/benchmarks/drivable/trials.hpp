#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plugins/metric/drive_validity.hpp"
#include "stope/payloads/elevation_grid.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/path.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::testing {

/// Seconds of this thread.
double cpu_seconds();

struct Site {
  OccupancyGrid grid;
  RoadGraph roads;
  std::optional<ElevationGrid> elevation;
};

struct Task {
  std::vector<double> start, goal;      ///< x, y
  std::optional<double> start_heading;  ///< radians
  bool allow_reverse = false;
  double min_clearance = 0;   ///< metres, of the route
  metric::TruckLimits truck;  ///< sizes; margin is taken as 0.5 m
};

/// What became of one task.
struct Trial {
  std::string refused_by;   ///< "a_star" or "smooth"; empty: driven
  std::string sentence;     ///< of the refusal
  std::string forwards;     ///< of the refusal without reversing, where the truck may reverse now
  std::string violation;    ///< the validator's first; empty: none
  double seconds = 0;       ///< of planner/smooth
  double route_length = 0;  ///< metres, of the route
  Path path;
  double clearance = 0, radius = 0, steepest = 0;
  std::size_t cusps = 0, jumps = 0;
};

/// Plans a route, drives it, and has the validator judge it with the planner's margin. What cannot
/// be driven forwards is tried once more with reversing.
Trial run_trial(const Site& site, Task task);

/// Sums up trials and prints a line, and one for each reason of refusal and each violation.
void print_trials(const std::string& name, const std::vector<Trial>& trials);

}  // namespace stope::testing
