// How much longer planned paths are than the shortest ways through free space, on synthetic pits:
// by road, with `shortcut`, and driven by a truck (planner/smooth).
//   detour_benchmark [pits] [pairs on each]
//
// Pits and pairs are those of measures_benchmark: places on the voronoi roads, each metre as
// likely, from the seed that metric/detour has there, geodesics of at least 20 m. A geodesic is
// exact, any angle, through all cells that the planner may use for the same min_clearance: those
// whose centres are that far from the nearest obstacle's. Percentiles are of each pit, then their
// mean, least and most over the pits.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "plugins/metric/geodesics.hpp"
#include "plugins/metric/nearest_obstacle.hpp"
#include "plugins/metric/path_similarity.hpp"
#include "plugins/metric/percentile.hpp"
#include "plugins/planner/plan.hpp"
#include "stope/random.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/stage_harness.hpp"
#include "synthetic_roads.hpp"

extern "C" const stope::StageEntry* stope_stage_Smooth();

namespace stope::testing {
namespace {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

metric::FreeCells cells_for(const OccupancyGrid& grid, double min_clearance) {
  metric::FreeCells cells = metric::free_cells(grid, {});
  const metric::NearestObstacle nearest(cells);
  for (std::int32_t row = 0; row < grid.frame.height; ++row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      const Cell seen = nearest.of({column, row});
      const double metres =
          std::hypot(seen.column - column, seen.row - row) * grid.frame.resolution;
      if (metres < min_clearance) cells.free[grid.frame.place({column, row})] = 0;
    }
  }
  return cells;
}

/// Places as metric/detour draws them.
class PlacesOnRoads {
 public:
  explicit PlacesOnRoads(const metric::GraphLines& lines) : lines_(lines) {
    for (std::uint32_t e = 0; e < lines.edge_count(); ++e)
      ends_.push_back((ends_.empty() ? 0 : ends_.back()) + lines.length(e));
  }
  metric::RoadPlace draw(Random& random) const {
    const double along = random.uniform(0, ends_.back());
    const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, along);
    const auto edge = static_cast<std::uint32_t>(end - ends_.begin());
    return {edge, along - (*end - lines_.length(edge))};
  }

 private:
  const metric::GraphLines& lines_;
  std::vector<double> ends_;
};

/// Detours of one pit.
struct Detours {
  std::vector<double> by_road, shortened, driven, milliseconds;
  std::size_t refused = 0, not_driven = 0;
};

Detours detours_of(const SyntheticRoads& pit, const RoadGraph& roads, double min_clearance,
                   std::size_t pairs, bool drive) {
  metric::MeasuredGraph graph(roads);
  metric::Geodesics geodesics(cells_for(pit.grid, min_clearance));
  const PlacesOnRoads places(graph.lines);
  planner::RoadRules rules;
  rules.min_clearance = min_clearance;
  planner::RoadPlanner planner(roads, rules);
  Random random = MemoryContext().random();
  Detours detours;
  for (std::size_t draw = 0; draw < 20 * pairs && detours.by_road.size() < pairs; ++draw) {
    const auto from = places.draw(random), to = places.draw(random);
    const Vector2 start = graph.lines.position(from), goal = graph.lines.position(to);
    const auto geodesic = geodesics.between(start, goal);
    if (!geodesic || *geodesic == metric::Geodesics::kUnreachable || *geodesic < 20) continue;
    detours.by_road.push_back(graph.distances.between(from, to) / *geodesic);
    planner::PlanRequest request;
    request.start = {start.x(), start.y()};
    request.goal = {goal.x(), goal.y()};
    request.shortcut = true;
    Path path;
    const double begin = cpu_seconds();
    const auto refusal =
        error_of([&] { path = planner.plan(&pit.grid, request, [](std::string_view) {}); });
    if (!refusal.empty()) {
      if (detours.refused++ == 0) fmt::print("  refused: {}\n", refusal);
      continue;
    }
    detours.milliseconds.push_back(1e3 * (cpu_seconds() - begin));
    detours.shortened.push_back(path.length / *geodesic);
    if (!drive) continue;
    Path driven;
    const auto why = error_of([&] {
      driven = StageHarness(stope_stage_Smooth())
                   .input("path", path)
                   .input("grid", pit.grid)
                   .set("comfortable_clearance", 0.0)
                   .apply<Path>();
    });
    if (why.empty())
      detours.driven.push_back(driven.length / *geodesic);
    else if (detours.not_driven++ == 0)
      fmt::print("  not driven: {}\n", why);
  }
  return detours;
}

void print(const std::string& name, std::vector<Detours>& pits,
           std::vector<double> Detours::*which) {
  std::vector<double> medians, high, most;
  for (Detours& pit : pits) {
    medians.push_back(metric::percentile(pit.*which, 0.5));
    high.push_back(metric::percentile(pit.*which, 0.95));
    most.push_back(metric::percentile(pit.*which, 1));
  }
  fmt::print(
      "  {:<12} p50 {:.4f}, p95 {:.4f} (pits {:.4f} to {:.4f}), longest {:.4f}\n", name,
      metric::mean_of(medians), metric::mean_of(high), *std::min_element(high.begin(), high.end()),
      *std::max_element(high.begin(), high.end()), *std::max_element(most.begin(), most.end()));
}

}  // namespace
}  // namespace stope::testing

int main(int count, char** arguments) {
  using namespace stope::testing;
  const std::uint64_t seeds = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10;
  const std::size_t pairs = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 200;
  std::vector<SyntheticRoads> pits;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) pits.push_back(synthetic_roads(500, seed));
  for (const double min_clearance : {0.0, 2.0, 2.5}) {
    std::vector<Detours> all;
    std::size_t planned = 0, refused = 0, not_driven = 0;
    const bool drive = min_clearance == 2.5;  // half a truck of 4 m and its margin of 0.5 m
    for (const SyntheticRoads& pit : pits) {
      all.push_back(detours_of(pit, extract_roads(pit.grid, Extractor::kVoronoi), min_clearance,
                               pairs, drive));
      planned += all.back().shortened.size();
      refused += all.back().refused, not_driven += all.back().not_driven;
    }
    fmt::print("min_clearance {} m: {} pits, {} pairs planned, {} refused\n", min_clearance, seeds,
               planned, refused);
    print("by road", all, &Detours::by_road);
    print("shortcut", all, &Detours::shortened);
    print("ms a plan", all, &Detours::milliseconds);
    if (drive) {
      print("driven", all, &Detours::driven);
      fmt::print("  not driven: {}\n", not_driven);
    }
    std::fflush(stdout);
  }
}
