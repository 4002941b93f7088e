// Road graphs and region maps brought up to date after changes of 200 x 200 cells, each compared
// bit for bit with a computation of everything.
//
//   taskset -c 0 build/bin/incremental_benchmark [--changes N] [--check-every N] [--side N]
//                                                [--only TEXT, of a case's name]
//
// Grids as in topology_benchmark. The changes follow each other without a fresh start: discs of
// obstacle or free space, walls and lanes across the window, rough faces, all blocked, all free,
// single cells, nothing at all; windows lie anywhere, also across the map's border, and in the mine
// also once only where free space is: most others lie in solid rock. Prints the thread's own CPU
// time per update, all of the result included, and how many results were equal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "plugins/topology/regions/room_divider.hpp"
#include "plugins/topology/regions/segment_by_growth.hpp"
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

/// What is brought up to date: all of it with and without memory for an update, and the update.
struct RoadMember {
  ExtractionMethod method;
  RoadUpdater updater{method};

  RoadGraph remember(const OccupancyGrid& grid) { return updater.full(grid); }
  RoadGraph update(const OccupancyGrid& grid, const CellWindow& window) {
    return updater.update(grid, window);
  }
  RoadGraph fresh(const OccupancyGrid& grid) const { return extract_roads(grid, method); }
  static Digest digest(const RoadGraph& roads) { return digest_of(roads); }
  static std::size_t roads(const RoadGraph& roads) { return roads.edges.size(); }
};

struct RegionMember {
  static Digest digest(const RegionsAndRoads& result) {
    return digest_of(digest_of(result.map).text() + digest_of(result.roads).text());
  }
  static std::size_t roads(const RegionsAndRoads& result) { return result.roads.edges.size(); }
  RegionRoadsRule rule{2.0, 0.2, Network::kAll, 1.5};
};

struct VoronoiRegionsMember : RegionMember {
  RoomDivider divider{{}, {}, rule};

  RegionsAndRoads remember(const OccupancyGrid& grid) { return divider.full(grid, true); }
  RegionsAndRoads update(const OccupancyGrid& grid, const CellWindow& window) {
    return divider.update(grid, window);
  }
  RegionsAndRoads fresh(const OccupancyGrid& grid) const {
    return RoomDivider({}, {}, rule).full(grid, false);
  }
};

struct RegionGrowingMember : RegionMember {
  std::optional<Ground> ground;
  GrowthMemory memory;

  RegionsAndRoads remember(const OccupancyGrid& grid) {
    ground.emplace(grid, ExtractionParams());
    return segment_by_growth(*ground, {}, {}, rule, memory);
  }
  RegionsAndRoads update(const OccupancyGrid& grid, const CellWindow& window) {
    GroundChange change(grid.frame.width, grid.frame.height);
    if (!ground->update(grid, window, change)) return remember(grid);
    return segment_by_growth(*ground, {}, {}, rule, memory, &change);
  }
  RegionsAndRoads fresh(const OccupancyGrid& grid) const {
    return segment_by_growth(Ground(grid, ExtractionParams()), {}, {}, rule, Random(1));
  }
};

/// A grid that is made when it is first wanted.
class LazyGrid {
 public:
  explicit LazyGrid(std::function<OccupancyGrid()> make) : make_(std::move(make)) {}
  const OccupancyGrid& get() {
    if (!grid_) grid_ = make_();
    return *grid_;
  }

 private:
  std::function<OccupancyGrid()> make_;
  std::optional<OccupancyGrid> grid_;
};

template <class Member>
void run(const std::string& name, LazyGrid& first, Member member, bool where_free,
         const Options& options) {
  if (name.find(options.only) == std::string::npos) return;
  OccupancyGrid grid = first.get();
  constexpr std::array<const char*, kChangeKinds> kNames{
      "obstacle appears", "obstacle goes", "road is cut", "road opens", "rough faces",
      "all blocked",      "all free",      "speckles",    "nothing"};
  Random random(7);
  double start = now_ms();
  auto result = member.remember(grid);
  fmt::print("{}: all with memory {:.0f} ms, ", name, now_ms() - start);
  start = now_ms();
  member.fresh(grid);
  fmt::print("all without {:.0f} ms; {} roads\n", now_ms() - start, Member::roads(result));
  std::vector<double> times;
  std::array<std::vector<double>, kChangeKinds> by_kind;
  int checked = 0, equal = 0;
  for (int i = 0; i < options.changes; ++i) {
    const int kind = i % kChangeKinds;
    const CellWindow window = window_in(grid, options.side, where_free, random);
    change_within(grid, window, static_cast<ChangeKind>(kind), random);
    start = now_ms();
    result = member.update(grid, window);
    times.push_back(now_ms() - start);
    by_kind[static_cast<std::size_t>(kind)].push_back(times.back());
    if (i % options.check_every != 0) continue;
    ++checked;
    equal += Member::digest(result) == Member::digest(member.fresh(grid)) ? 1 : 0;
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

void run_regions(const std::string& name, LazyGrid& grid, bool where_free, const Options& options) {
  run(name + ", voronoi_regions", grid, VoronoiRegionsMember{}, where_free, options);
  run(name + ", region_growing", grid, RegionGrowingMember{}, where_free, options);
}

void run_all(const std::string& name, LazyGrid& grid, bool where_free, const Options& options) {
  using Kind = ExtractionMethod::Kind;
  const auto run_one = [&](const char* member, Kind kind, SkeletonParams::Pruning pruning) {
    ExtractionMethod method;
    method.kind = kind;
    method.skeleton.pruning = pruning;
    run(fmt::format("{}, {}", name, member), grid, RoadMember{method}, where_free, options);
  };
  constexpr auto kResidual = SkeletonParams::Pruning::kChordResidual;
  run_one("voronoi", Kind::kVoronoi, kResidual);
  run_one("watershed of obstacles", Kind::kWatershed, kResidual);
  run_one("watershed of outline parts", Kind::kWatershedParts, kResidual);
  run_one("skeleton by chord residual", Kind::kSkeleton, kResidual);
  run_one("skeleton by lambda", Kind::kSkeleton, SkeletonParams::Pruning::kLambda);
  run_regions(name, grid, where_free, options);
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
  LazyGrid noise(synthetic), blocks(city_blocks);
  run_all("60 % free", noise, false, options);
  run_regions("City blocks", blocks, false, options);
  if (!has_mine()) return 0;
  LazyGrid mine([] { return fullest_window(from_image(read_mine(kMineFine), 0.1)); });
  run_all("Mine", mine, false, options);
  run_all("Mine where it is free", mine, true, options);
  // Region maps are made of coarser grids than roads are.
  LazyGrid coarse([] { return from_image(read_mine(kMineCoarse), 0.5); });
  run_regions("Mine at 0.5 m where it is free", coarse, true, options);
}
