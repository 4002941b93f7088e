// Road graphs brought up to date after changes of 200 x 200 cells, each compared bit for bit with a
// computation of everything.
//
//   taskset -c 0 build/bin/incremental_benchmark [--changes N] [--check-every N] [--side N]
//                                                [--only TEXT, of a case's name]
//
// Grids as in topology_benchmark. The changes follow each other without a fresh start: discs of
// obstacle or free space, walls and lanes across the window, rough faces, all blocked, all free,
// single cells, nothing at all; windows lie anywhere, also across the map's border, and in the mine
// also once only where free space is: most others lie in solid rock. Prints the thread's own CPU
// time per update, the graph included, and how many graphs were equal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "plugins/topology/road_updater.hpp"
#include "stope/digest.hpp"
#include "tests/benchmarks/topology/benchmark_grids.hpp"
#include "tests/plugins/topology/random_changes.hpp"

namespace stope::topology {
namespace {

struct Options {
  int changes = 1000, check_every = 1;
  std::int32_t side = 200;
  std::string only;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  return values[place];
}

/// A window anywhere, or one with a free cell.
CellWindow window_in(const OccupancyGrid& grid, std::int32_t side, bool where_free,
                     Random& random) {
  while (true) {
    const CellWindow window = draw_window(grid, side, random);
    if (!where_free) return window;
    for (std::int32_t y = window.row; y < window.row + side; ++y)
      for (std::int32_t x = window.column; x < window.column + side; ++x)
        if (grid.frame.contains({x, y}) &&
            grid.cells[grid.frame.place({x, y})] == OccupancyGrid::kFree)
          return window;
  }
}

void run(const std::string& name, OccupancyGrid grid, const ExtractionMethod& method,
         bool where_free, const Options& options) {
  if (name.find(options.only) == std::string::npos) return;
  constexpr std::array<const char*, kChangeKinds> kNames{
      "obstacle appears", "obstacle goes", "road is cut", "road opens", "rough faces",
      "all blocked",      "all free",      "speckles",    "nothing"};
  RoadUpdater updater(method);
  Random random(7);
  double start = now_ms();
  RoadGraph roads = updater.full(grid);
  fmt::print("{}: all with memory {:.0f} ms, ", name, now_ms() - start);
  start = now_ms();
  extract_roads(grid, method);
  fmt::print("all without {:.0f} ms; {} roads\n", now_ms() - start, roads.edges.size());
  std::vector<double> times;
  std::array<std::vector<double>, kChangeKinds> by_kind;
  int checked = 0, equal = 0;
  for (int i = 0; i < options.changes; ++i) {
    const int kind = i % kChangeKinds;
    const CellWindow window = window_in(grid, options.side, where_free, random);
    change_within(grid, window, static_cast<ChangeKind>(kind), random);
    start = now_ms();
    roads = updater.update(grid, window);
    times.push_back(now_ms() - start);
    by_kind[static_cast<std::size_t>(kind)].push_back(times.back());
    if (i % options.check_every != 0) continue;
    ++checked;
    equal += digest_of(roads) == digest_of(extract_roads(grid, method)) ? 1 : 0;
  }
  fmt::print(
      "  {} changes: median {:.2f} ms, p90 {:.2f}, p99 {:.2f}, most {:.2f}; {} of {} equal\n",
      times.size(), quantile(times, 0.5), quantile(times, 0.9), quantile(times, 0.99),
      quantile(times, 1), equal, checked);
  for (int kind = 0; kind < kChangeKinds; ++kind)
    if (const auto& those = by_kind[static_cast<std::size_t>(kind)]; !those.empty())
      fmt::print("    {:<17} median {:.2f} ms, p90 {:.2f}\n",
                 kNames[static_cast<std::size_t>(kind)], quantile(those, 0.5),
                 quantile(those, 0.9));
  std::fflush(stdout);
}

void run_all(const std::string& name, const OccupancyGrid& grid, bool where_free,
             const Options& options) {
  using Kind = ExtractionMethod::Kind;
  const auto run_one = [&](const char* member, Kind kind, SkeletonParams::Pruning pruning) {
    ExtractionMethod method;
    method.kind = kind;
    method.skeleton.pruning = pruning;
    run(fmt::format("{}, {}", name, member), grid, method, where_free, options);
  };
  constexpr auto kResidual = SkeletonParams::Pruning::kChordResidual;
  run_one("voronoi", Kind::kVoronoi, kResidual);
  run_one("watershed of obstacles", Kind::kWatershed, kResidual);
  run_one("watershed of outline parts", Kind::kWatershedParts, kResidual);
  run_one("skeleton by chord residual", Kind::kSkeleton, kResidual);
  run_one("skeleton by lambda", Kind::kSkeleton, SkeletonParams::Pruning::kLambda);
}

}  // namespace
}  // namespace stope::topology

int main(int argc, char** argv) {
  using namespace stope::topology;
  Options options;
  for (int i = 1; i + 1 < argc; ++i) {
    if (!std::strcmp(argv[i], "--changes")) options.changes = std::atoi(argv[i + 1]);
    if (!std::strcmp(argv[i], "--check-every"))
      options.check_every = std::max(1, std::atoi(argv[i + 1]));
    if (!std::strcmp(argv[i], "--side")) options.side = std::atoi(argv[i + 1]);
    if (!std::strcmp(argv[i], "--only")) options.only = argv[i + 1];
  }
  cv::setNumThreads(1);
  run_all("60 % free", synthetic(), false, options);
  const cv::Mat image = read_mine();
  if (image.empty()) return 0;
  const stope::OccupancyGrid mine = fullest_window(from_image(image, 0.1));
  run_all("Mine", mine, false, options);
  run_all("Mine where it is free", mine, true, options);
}
