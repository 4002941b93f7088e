// Road graphs of large grids on one core, beside OpenCV on the same grids in the same run.
//
//   taskset -c 0 build/bin/topology_benchmark [--whole] [--no-peers] [--repeats N]
//   build/bin/topology_benchmark --mine
//
// Grids: the 4096 x 4096 window of the real mine at 0.1 m that has the most free cells among those
// at multiples of 512 cells, and a synthetic one of 4096 x 4096 cells, 60 % of them free: smooth
// noise (random values every 256 cells plus half as much every 64, bilinear) above its 40 % point.
// --whole: also the whole mine, 21083 x 12955 cells. --mine: no times, but whether the whole mine's
// roads have a cycle for each hole and lie where its trucks drove (mine_checks.hpp). Prints medians
// of the thread's own CPU time, which on an idle core is the time that passes; everything here runs
// on one thread.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc.hpp>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "tests/benchmarks/topology/benchmark_grids.hpp"
#include "tests/benchmarks/topology/mine_checks.hpp"
#include "tests/plugins/topology/graph_checks.hpp"

namespace stope::topology {
namespace {

double median_ms(int repeats, const std::function<void()>& work) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const double start = now_ms();
    work();
    times.push_back(now_ms() - start);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// The steps of the extraction apart, with voronoi's rule for sides.
void time_steps(const OccupancyGrid& grid, int repeats) {
  std::vector<double> steps(4, 0);
  for (int i = 0; i < repeats; ++i) {
    double last = now_ms();
    std::size_t step = 0;
    const auto lap = [&] {
      const double now = now_ms();
      steps[step++] += now - last;
      last = now;
    };
    FreeSpace space = make_free_space(grid, {});
    lap();
    EdgeGrid edges(space.width(), space.height());
    const Outlines outlines = trace_outlines(space, edges, 1000, 40);
    lap();
    find_nearest_outline(space, outlines, edges);
    lap();
    find_dividing_lines(space, outlines, SideRule::between_sides(outlines), edges);
    lap();
  }
  fmt::print(
      "  steps, means: free space {:.1f}, outlines {:.1f}, distance transform {:.1f}, "
      "dividing lines {:.1f} ms\n",
      steps[0] / repeats, steps[1] / repeats, steps[2] / repeats, steps[3] / repeats);
}

void time_opencv(const OccupancyGrid& grid, int repeats, double ours) {
  cv::Mat free(grid.frame.height, grid.frame.width, CV_8U);
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    free.data[i] = grid.cells[i] == OccupancyGrid::kFree ? 255 : 0;
  cv::Mat distance;
  const double transform = median_ms(
      repeats, [&] { cv::distanceTransform(free, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE); });
  const double flood = median_ms(1, [&] {
    cv::Mat markers, heights, colour, obstacles = 255 - free;
    cv::connectedComponents(obstacles, markers, 4, CV_32S);
    distance.convertTo(heights, CV_8U);
    cv::cvtColor(heights, colour, cv::COLOR_GRAY2BGR);
    cv::watershed(colour, markers);
  });
  fmt::print(
      "  OpenCV distanceTransform {:.0f} ms, + connectedComponents + watershed {:.0f} ms "
      "(together {:.1f} x ours; its watershed follows colour, not height)\n",
      transform, flood, (transform + flood) / ours);
  cv::Mat thin;
  const double thinning = median_ms(1, [&] { cv::ximgproc::thinning(free, thin); });
  fmt::print("  OpenCV distanceTransform + ximgproc::thinning {:.0f} ms ({:.0f} x ours)\n",
             transform + thinning, (transform + thinning) / ours);
}

void run(const char* name, const OccupancyGrid& grid, int repeats, bool peers) {
  const auto free = std::count(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kFree);
  fmt::print("{}: {} x {} cells, {:.1f} % free\n", name, grid.frame.width, grid.frame.height,
             100.0 * static_cast<double>(free) / static_cast<double>(grid.cells.size()));
  const auto report = [&](const char* stage, double ms, const RoadGraph& roads) {
    const Betti betti = betti_of(roads);
    fmt::print("  {} {:.0f} ms, raster to road graph: {} edges, {} nodes, {} pieces, {} cycles\n",
               stage, ms, roads.edges.size(), roads.nodes.size(), betti.pieces, betti.cycles);
    std::fflush(stdout);
  };
  RoadGraph roads;
  const double watershed = median_ms(repeats, [&] { roads = watershed_roads(grid, {}); });
  report("topology/watershed", watershed, roads);
  const double voronoi = median_ms(repeats, [&] { roads = voronoi_roads(grid, {}, {}); });
  report("topology/voronoi  ", voronoi, roads);
  const double skeleton = median_ms(repeats, [&] { roads = skeleton_roads(grid, {}, {}, {}); });
  report("topology/skeleton ", skeleton, roads);
  const SkeletonParams by_lambda{SkeletonParams::Pruning::kLambda};
  const double lambda =
      median_ms(repeats, [&] { roads = skeleton_roads(grid, {}, {}, by_lambda); });
  report("… by lambda       ", lambda, roads);
  const double parts = median_ms(repeats, [&] { roads = watershed_part_roads(grid, {}, {}, {}); });
  report("watershed of parts", parts, roads);
  time_steps(grid, repeats);
  if (peers) time_opencv(grid, std::max(1, repeats / 3), std::max(watershed, voronoi));
}

}  // namespace
}  // namespace stope::topology

int main(int argc, char** argv) {
  using namespace stope::topology;
  bool whole = false, peers = true, check = false;
  int repeats = 9;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--whole")) whole = true;
    if (!std::strcmp(argv[i], "--no-peers")) peers = false;
    if (!std::strcmp(argv[i], "--mine")) check = true;
    if (!std::strcmp(argv[i], "--repeats") && i + 1 < argc) repeats = std::atoi(argv[++i]);
  }
  if (check) {
    const cv::Mat image = read_mine();
    if (image.empty()) return 0;
    stope::OccupancyGrid mine = from_image(image, 0.1);
    mine.frame.origin = {909.468, 246.355, 0};  // of the recorded tracks
    return check_mine(mine) ? 0 : 1;
  }
  cv::setNumThreads(1);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  run("Synthetic", synthetic(), repeats, peers);
  const cv::Mat image = read_mine();
  if (image.empty()) return 0;
  const stope::OccupancyGrid mine = from_image(image, 0.1);
  run("Window of the mine", fullest_window(mine), repeats, peers);
  if (whole) run("The whole mine", mine, std::max(1, repeats / 3), false);
}
