// Routes on street maps against the published shortest ways.
//
//   STOPE_DATA=… build/bin/movingai_benchmark [--queries N] [map …]
//
// Each map's voronoi roads are made as for a point robot (every obstacle counts, no clearance
// asked) and N queries, evenly spread over the scenario (without --queries all of them), are
// planned by RoadPlanner with shortcut. What is published is the octile length of the shortest way
// over cells that cuts no corner; a way pulled straight may be shorter. Every tenth of a cell of
// every way is looked at in the map: it must lie in a free cell. Times are CPU time of whole plans.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "plugins/map_source/movingai_map.hpp"
#include "plugins/map_source/movingai_scenario.hpp"
#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/plan.hpp"
#include "plugins/topology/extract_roads.hpp"

namespace stope {
namespace {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Ratios {
  std::vector<double> all, seconds;
  std::size_t refused = 0, blocked = 0;
  void print(const std::string& name) {
    if (all.empty()) return;
    std::sort(all.begin(), all.end());
    std::sort(seconds.begin(), seconds.end());
    const auto within = std::upper_bound(all.begin(), all.end(), 1.05 + 1e-9) - all.begin();
    fmt::print(
        "{:<20} {:>5} ways: median {:.4f}, p95 {:.4f}, max {:.4f} of the published length; {} not "
        "within 1.05, {} refused, {} touch an obstacle; median {:.2f}, p95 {:.2f}, max {:.1f} ms\n",
        name, all.size(), all[all.size() / 2], all[all.size() * 95 / 100], all.back(),
        all.size() - static_cast<std::size_t>(within), refused, blocked,
        1e3 * seconds[seconds.size() / 2], 1e3 * seconds[seconds.size() * 95 / 100],
        1e3 * seconds.back());
    std::fflush(stdout);
  }
};

void run(const std::filesystem::path& file, std::size_t count, bool shortcut, Ratios& whole) {
  const OccupancyGrid grid = map_source::read_movingai_map(file, 1.0);
  auto queries = map_source::read_movingai_scenario(file.string() + ".scen");
  topology::ExtractionParams extraction;
  extraction.min_clearance = 0;
  extraction.min_obstacle_area = 0;
  topology::BranchParams branches;
  branches.min_branch = 1;
  branches.min_branch_share = 0;
  const RoadGraph roads = topology::voronoi_roads(grid, extraction, branches);
  planner::RoadPlanner planner(roads, {});
  const planner::DrivableGrid ground(grid);
  Ratios ratios;
  const std::size_t step = std::max<std::size_t>(1, queries.size() / count);
  for (std::size_t i = step / 2; i < queries.size(); i += step) {
    const auto& query = queries[i];
    if (query.length <= 0) continue;
    const Vector2 start = grid.frame.centre(query.start()), goal = grid.frame.centre(query.goal());
    planner::PlanRequest request;
    request.start = {start.x(), start.y()};
    request.goal = {goal.x(), goal.y()};
    request.snap_distance = 1000;
    request.step = 0.1;
    request.shortcut = shortcut;
    const double begin = cpu_seconds();
    try {
      const Path path = planner.plan(&grid, request, [](std::string_view) {});
      ratios.seconds.push_back(cpu_seconds() - begin);
      ratios.all.push_back(path.length / query.length);
      const auto touching =
          std::find_if(path.points.begin(), path.points.end(), [&](const PathPoint& point) {
            return ground.ground_at({point.x, point.y}) != planner::Ground::kFree;
          });
      if (touching != path.points.end() && ratios.blocked++ == 0)
        fmt::print("  {}: query {} touches an obstacle at ({}, {})\n", file.stem().string(), i,
                   touching->x, touching->y);
    } catch (const std::exception& error) {
      if (ratios.refused++ == 0) fmt::print("  {}: {}\n", file.stem().string(), error.what());
    }
  }
  whole.all.insert(whole.all.end(), ratios.all.begin(), ratios.all.end());
  whole.seconds.insert(whole.seconds.end(), ratios.seconds.begin(), ratios.seconds.end());
  whole.refused += ratios.refused;
  whole.blocked += ratios.blocked;
  ratios.print(file.stem().string());
}

}  // namespace
}  // namespace stope

int main(int argc, char** argv) {
  std::size_t count = 100'000;
  bool shortcut = true;
  std::vector<std::string> chosen;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--queries") && i + 1 < argc)
      count = static_cast<std::size_t>(std::max(1, std::atoi(argv[++i])));
    else if (!std::strcmp(argv[i], "--no-shortcut"))
      shortcut = false;
    else
      chosen.emplace_back(argv[i]);
  }
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder =
      std::filesystem::path(data ? data : STOPE_DEFAULT_DATA) / "movingai_cities";
  if (!std::filesystem::exists(folder)) {
    fmt::print("The maps' folder {} is not there; set STOPE_DATA.\n", folder.string());
    return 0;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".map") continue;
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), stem) != chosen.end())
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  stope::Ratios whole;
  for (const auto& file : files) stope::run(file, count, shortcut, whole);
  whole.print("all maps");
}
