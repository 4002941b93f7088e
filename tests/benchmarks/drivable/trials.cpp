#include "tests/benchmarks/drivable/trials.hpp"

#include <fmt/core.h>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "plugins/metric/drive_validity.hpp"
#include "stope/testing/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_AStar();
extern "C" const stope::StageEntry* stope_stage_Smooth();

namespace stope::testing {
namespace {

/// How a path is to drive: curvature and its change, squared, and lack of 3 m of clearance, as
/// means over its metres.
struct Comfort {
  double metres = 0, bend = 0, steer = 0, lack = 0;
  void add(const Path& path) {
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const PathPoint &a = path.points[i - 1], &b = path.points[i];
      const double way = std::hypot(b.x - a.x, b.y - a.y);
      metres += way;
      bend += way * b.curvature * b.curvature;
      steer += std::pow(b.curvature - a.curvature, 2) / std::max(way, 0.1);
      lack += way * std::max(0.0, 3 - b.clearance);
    }
  }
};

/// The kind of a refusal: its words without the figures.
std::string kind_of(const std::string& sentence) {
  for (const char* part :
       {"the turn needs a radius", "the footprint would touch an obstacle",
        "over the truck's max_grade", "the elevation is not known", "cannot stand at the start",
        "cannot stand at the goal", "nearest reachable place", "nearest road"}) {
    if (sentence.find(part) != std::string::npos) return part;
  }
  return sentence.substr(0, 60);
}

double share_of(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Trial run_trial(const Site& site, Task task) {
  Trial trial;
  Path route;
  trial.refused_by = "a_star";
  trial.sentence = error_of([&] {
    route = StageHarness(stope_stage_AStar())
                .input("roads", site.roads)
                .input("grid", site.grid)
                .set("start", task.start)
                .set("goal", task.goal)
                .set("min_clearance", task.min_clearance)
                .apply<Path>();
  });
  if (!trial.sentence.empty()) return trial;
  trial.route_length = route.length;
  trial.refused_by = "smooth";
  for (;;) {
    StageHarness stage(stope_stage_Smooth());
    stage.input("path", route).input("grid", site.grid).set("allow_reverse", task.allow_reverse);
    stage.set("length", task.truck.length)
        .set("width", task.truck.width)
        .set("rear_overhang", task.truck.rear_overhang)
        .set("wheelbase", task.truck.wheelbase)
        .set("turning_radius", task.truck.turning_radius);
    if (site.elevation) stage.input("elevation", *site.elevation);
    if (task.start_heading) stage.set("start_heading", *task.start_heading);
    const double start = cpu_seconds();
    trial.sentence = error_of([&] { trial.path = stage.apply<Path>(); });
    trial.seconds = cpu_seconds() - start;
    if (trial.sentence.empty() || task.allow_reverse) break;
    trial.forwards = trial.sentence;
    task.allow_reverse = true;
  }
  if (!trial.sentence.empty()) return trial;
  trial.refused_by.clear();
  metric::TruckLimits truck = task.truck;
  truck.margin = 0.5;
  const auto found = metric::check_drive(trial.path, site.grid,
                                         site.elevation ? &*site.elevation : nullptr, truck);
  trial.violation = found.first;
  trial.clearance = found.least_clearance;
  trial.radius = found.least_radius;
  trial.steepest = found.steepest;
  trial.cusps = found.cusps;
  for (std::size_t i = 1; i + 1 < trial.path.points.size(); ++i)
    trial.jumps += trial.path.points[i].speed == 0 ? 1 : 0;
  return trial;
}

void print_trials(const std::string& name, const std::vector<Trial>& trials) {
  std::map<std::string, int> reasons;
  std::vector<double> accepted, refused, ratios;
  int no_route = 0, violations = 0, stops = 0, cusps = 0, reversed = 0;
  Comfort comfort;
  double least_clearance = 1e9, least_radius = 1e9, steepest = 0, kilometres = 0;
  for (const Trial& trial : trials) {
    if (trial.refused_by == "a_star") {
      ++no_route;
      continue;
    }
    (trial.sentence.empty() ? accepted : refused).push_back(trial.seconds);
    if (!trial.sentence.empty()) {
      ++reasons[kind_of(trial.sentence)];
      continue;
    }
    if (!trial.violation.empty()) {
      ++violations;
      fmt::print("  VIOLATION {}\n", trial.violation);
    }
    if (!trial.forwards.empty() && reversed++ < 3) fmt::print("  forwards: {}\n", trial.forwards);
    ratios.push_back(trial.path.length / trial.route_length);
    kilometres += trial.path.length / 1000;
    comfort.add(trial.path);
    least_clearance = std::min(least_clearance, trial.clearance);
    least_radius = std::min(least_radius, trial.radius);
    if (trial.steepest > steepest) steepest = trial.steepest;
    stops += trial.jumps > trial.cusps ? 1 : 0;
    cusps += trial.cusps > 0 ? 1 : 0;
  }
  const std::size_t asked = accepted.size() + refused.size();
  fmt::print(
      "{}: {} routes, {} accepted ({:.1f} %, {:.1f} km; {} only with allow_reverse), {} refused; "
      "validator violations {}; "
      "least "
      "radius {:.2f} m, least clearance {:.2f} m, steepest {:.1f} %; with stops to turn the wheels "
      "{}, "
      "with reversing {}; driven/route length median {:.3f}; CPU s accepted median {:.3f} p95 "
      "{:.3f} "
      "max {:.3f}, refused median {:.2f} max {:.2f}; no route {}\n",
      name, asked, accepted.size(),
      100.0 * static_cast<double>(accepted.size()) /
          std::max<double>(1, static_cast<double>(asked)),
      kilometres, reversed, refused.size(), violations, least_radius, least_clearance,
      100 * steepest, stops, cusps, share_of(ratios, 0.5), share_of(accepted, 0.5),
      share_of(accepted, 0.95), share_of(accepted, 1), share_of(refused, 0.5), share_of(refused, 1),
      no_route);
  if (comfort.metres > 0) {
    fmt::print(
        "  a metre's mean: curvature {:.5f} 1/m, change of curvature {:.6f} 1/m^2 (root mean "
        "squares), {:.4f} m short of 3 m clearance\n",
        std::sqrt(comfort.bend / comfort.metres), std::sqrt(comfort.steer / comfort.metres),
        comfort.lack / comfort.metres);
  }
  for (const auto& [reason, count] : reasons) fmt::print("  refused {}: {}\n", count, reason);
  for (const Trial& trial : trials) {
    if (trial.refused_by == "smooth") fmt::print("  {}\n", trial.sentence);
  }
}

}  // namespace stope::testing
