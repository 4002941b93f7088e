// Road graphs brought up to date after changes of 200 x 200 cells, each compared bit for bit with a
// computation of everything.
//
//   taskset -c 0 build/bin/incremental_benchmark [--changes N] [--check-every N] [--side N]
//
// Grids as in topology_benchmark. The changes follow each other without a fresh start: discs of
// obstacle or free space, walls and lanes across the window, rough faces, all blocked, all free,
// single cells, nothing at all; windows lie anywhere, also across the map's border. Prints the
// thread's own CPU time per update, the copy of the graph included, and how many graphs were equal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "plugins/topology/road_updater.hpp"
#include "stope/digest.hpp"
#include "tests/benchmarks/topology/benchmark_grids.hpp"
#include "tests/plugins/topology/random_changes.hpp"

namespace stope::topology {
namespace {

struct Options {
  int changes = 1000, check_every = 1;
  std::int32_t side = 200;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  return values[place];
}

void run(const char* name, OccupancyGrid grid, const ExtractionMethod& method,
         const Options& options) {
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
    const CellWindow window =
        change_at_random(grid, options.side, static_cast<ChangeKind>(kind), random);
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

void run_all(const char* name, const OccupancyGrid& grid, const Options& options) {
  using Kind = ExtractionMethod::Kind;
  ExtractionMethod method;
  for (const auto& [stage, kind] :
       {std::pair("voronoi", Kind::kVoronoi), std::pair("watershed", Kind::kWatershed),
        std::pair("skeleton", Kind::kSkeleton)}) {
    method.kind = kind;
    run(fmt::format("{}, {}", name, stage).c_str(), grid, method, options);
  }
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
  }
  cv::setNumThreads(1);
  run_all("Synthetic", synthetic(), options);
  const cv::Mat image = read_mine();
  if (!image.empty())
    run_all("Window of the mine", fullest_window(from_image(image, 0.1)), options);
}
