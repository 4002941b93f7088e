// The distance transform and the flooding by themselves on one core, beside straightforward ones
// and OpenCV's on the same grids in the same run.
//
//   taskset -c 0 build/bin/kernel_benchmark [--repeats N]
//
// Grids as in topology_benchmark. Least and median CPU time of the calling thread, on which alone
// all of this runs; memory for results is there before the clock starts. What is timed:
//   squared distances   free space in, for every cell the squared distance out.
//   nearest outline     free space and numbered outlines in, for every free cell the side of an
//                       obstacle it sees out (a feature transform: from it follow distance, basin
//                       and dividing lines).
//   flooding            free space and numbered outlines (the labels of the obstacles) in, for
//                       every free cell the label of its basin and the watershed lines out:
//                       nearest outline, dividing lines, labels. Nothing is known beforehand.
//   its peer            free space, labels and distances in (the transform is not counted), for
//                       every free cell the label of its basin out: Meyer's flooding in the order
//                       of distance, one bucket a cell of distance.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/free_runs.hpp"
#include "plugins/topology/squared_distances.hpp"
#include "tests/benchmarks/topology/benchmark_grids.hpp"

namespace stope::topology {
namespace {

using Distances = PaddedGrid<std::uint32_t>;

/// Felzenszwalb and Huttenlocher as written down, except that columns are counted row by row.
void straightforward_transform(const FreeSpace& space, Distances& distances) {
  const std::int32_t width = space.width(), height = space.height(), stride = space.stride();
  std::fill_n(distances.padded_row(-1), stride, 0U);
  std::fill_n(distances.padded_row(height), stride, 0U);
  for (std::int32_t row = 0; row < height; ++row)
    for (CellIndex cell = space.index(-1, row); cell <= space.index(width, row); ++cell)
      distances[cell] = space[cell] & kObstacle ? 0 : distances[cell - stride] + 1;
  for (std::int32_t row = height; row-- > 0;)
    for (CellIndex cell = space.index(-1, row); cell <= space.index(width, row); ++cell)
      distances[cell] = std::min(distances[cell], distances[cell + stride] + 1);
  const auto columns = static_cast<std::size_t>(stride);
  std::vector<std::int32_t> level(columns), site(columns), begin(columns + 1);
  for (std::int32_t row = 0; row < height; ++row) {
    std::uint32_t* cells = distances.padded_row(row);
    for (std::int32_t i = 0; i < stride; ++i)
      level[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(cells[i] * cells[i]) + i * i;
    const auto meet = [&](std::int32_t i, std::int32_t k) {
      return 1 + (level[static_cast<std::size_t>(i)] - level[static_cast<std::size_t>(k)]) /
                     (2 * (i - k));
    };
    std::size_t last = 0;
    site[0] = begin[0] = 0;
    for (std::int32_t i = 1; i < stride; ++i) {
      std::int32_t from = meet(i, site[last]);
      while (last > 0 && from <= begin[last]) from = meet(i, site[--last]);
      if (from >= stride) continue;
      ++last;
      site[last] = i;
      begin[last] = from;
    }
    begin[last + 1] = stride;
    std::size_t piece = 0;
    for (std::int32_t i = 0; i < stride; ++i) {
      while (begin[piece + 1] <= i) ++piece;
      const std::int32_t k = site[piece], apart = i - k;
      cells[i] =
          static_cast<std::uint32_t>(apart * apart + level[static_cast<std::size_t>(k)] - k * k);
    }
  }
}

/// Meyer's flooding: labels go from obstacles to neighbours in the order of distance.
void straightforward_flood(const FreeSpace& space, const Distances& distances,
                           PaddedGrid<std::int32_t>& labels) {
  std::vector<std::vector<CellIndex>> open(1);
  const CellIndex stride = space.stride();
  const auto push_around = [&](CellIndex cell) {
    for (const CellIndex next : {cell + 1, cell + stride, cell - 1, cell - stride}) {
      if (labels[next] >= 0) continue;
      labels[next] = labels[cell];
      const auto level = static_cast<std::size_t>(std::sqrt(static_cast<float>(distances[next])));
      if (level >= open.size()) open.resize(level + 1);
      open[level].push_back(next);
    }
  };
  for (std::int32_t row = 0; row < space.height(); ++row)
    for (CellIndex cell = space.index(0, row); cell < space.index(space.width(), row); ++cell)
      if (space[cell] & kOnOutline) push_around(cell);
  for (std::size_t level = 0; level < open.size(); ++level) {
    for (std::size_t i = 0; i < open[level].size(); ++i) push_around(open[level][i]);
    open[level] = {};
  }
}

struct Times {
  double least = 0, median = 0;
};

/// Milliseconds of `work`; `prepare` is not timed.
Times time_ms(int repeats, const std::function<void()>& prepare,
              const std::function<void()>& work) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    prepare();
    const double start = now_ms();
    work();
    times.push_back(now_ms() - start);
  }
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2]};
}

void print(const char* what, Times times, std::int64_t free) {
  fmt::print("  {:<52} {:6.1f} {:6.1f} ms, {:4.0f} million free cells a second\n", what,
             times.least, times.median, 1e-3 * static_cast<double>(free) / times.median);
  std::fflush(stdout);
}

void time_transforms(const OccupancyGrid& grid, std::int64_t free, int repeats) {
  const auto nothing = [] {};
  FreeSpace space = make_free_space(grid, {});
  Distances ours(space.width(), space.height()), plain(space.width(), space.height());
  std::fill_n(ours.data(), ours.size(), 0U);
  print("squared distances",
        time_ms(repeats, nothing, [&] { find_squared_distances(space, ours); }), free);
  print(
      "peer: straightforward squared distances",
      time_ms(std::max(1, repeats / 2), nothing, [&] { straightforward_transform(space, plain); }),
      free);
  bool same = true;
  for (std::int32_t row = 0; row < space.height(); ++row)
    same = same && std::equal(ours.padded_row(row) + 1, ours.padded_row(row) + 1 + space.width(),
                              plain.padded_row(row) + 1);
  if (!same) fmt::print("  THE TWO DIFFER\n");
  cv::Mat bright(grid.frame.height, grid.frame.width, CV_8U), distance;
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    bright.data[i] = grid.cells[i] == OccupancyGrid::kFree ? 255 : 0;
  print(
      "peer: OpenCV distanceTransform, DIST_MASK_PRECISE",
      time_ms(std::max(1, repeats / 3), nothing,
              [&] { cv::distanceTransform(bright, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE); }),
      free);
}

void time_flooding(const OccupancyGrid& grid, std::int64_t free, int repeats) {
  const auto nothing = [] {};
  const FreeSpace original = make_free_space(grid, {});
  FreeSpace space = make_free_space(grid, {});
  EdgeGrid edges(space.width(), space.height());
  std::fill_n(edges.data(), edges.size(), 0);
  const Outlines outlines = trace_outlines(space, edges, 0, 64);
  const FreeSpace traced = [&] {
    FreeSpace copy(space.width(), space.height());
    std::copy_n(space.data(), space.size(), copy.data());
    return copy;
  }();
  print("nearest outline",
        time_ms(repeats, nothing, [&] { find_nearest_outline(space, outlines, edges); }), free);

  PaddedGrid<std::int32_t> labels(space.width(), space.height());
  std::fill_n(labels.data(), labels.size(), -1);
  const auto forget_lines = [&] { std::copy_n(traced.data(), traced.size(), space.data()); };
  print("flooding",
        time_ms(repeats, forget_lines,
                [&] {
                  find_nearest_outline(space, outlines, edges);
                  find_dividing_lines(space, outlines, SideRule::between_outlines(outlines), edges);
                  for (std::int32_t row = 0; row < space.height(); ++row)
                    for_each_free_run(space, row, [&](std::int32_t begin, std::int32_t end) {
                      const CellIndex first = space.index(begin, row);
                      for (CellIndex cell = first; cell < first + (end - begin); ++cell)
                        labels[cell] = outlines.of_edge[static_cast<std::size_t>(edges[cell])];
                    });
                }),
        free);

  Distances distances(space.width(), space.height());
  find_squared_distances(original, distances);
  PaddedGrid<std::int32_t> flooded(space.width(), space.height());
  const auto label_obstacles = [&] {
    std::fill_n(flooded.data(), flooded.size(), 0);
    for (CellIndex cell = 0; cell < static_cast<CellIndex>(space.size()); ++cell)
      if (!(space[cell] & kObstacle)) flooded[cell] = -1;
    for (std::size_t edge = 0; edge < outlines.place.size(); ++edge)
      if (outlines.of_edge[edge] >= 0)
        flooded[space.index(outlines.place[edge].column, outlines.place[edge].row)] =
            outlines.of_edge[edge];
  };
  print("peer: straightforward flooding, transform not counted",
        time_ms(std::max(1, repeats / 3), label_obstacles,
                [&] { straightforward_flood(space, distances, flooded); }),
        free);
  std::int64_t differ = 0;
  for (std::int32_t row = 0; row < space.height(); ++row)
    for (std::int32_t column = 0; column < space.width(); ++column) {
      const CellIndex cell = space.index(column, row);
      differ += !(space[cell] & kObstacle) && labels[cell] != flooded[cell];
    }
  fmt::print("  its basins differ from ours in {:.3f} % of the free cells\n",
             100.0 * static_cast<double>(differ) / static_cast<double>(free));
}

void run(const char* name, const OccupancyGrid& grid, int repeats) {
  const auto free = std::count(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kFree);
  fmt::print("{}: {} x {} cells, {:.1f} % free\n", name, grid.frame.width, grid.frame.height,
             100.0 * static_cast<double>(free) / static_cast<double>(grid.cells.size()));
  time_transforms(grid, free, repeats);
  time_flooding(grid, free, repeats);
}

}  // namespace
}  // namespace stope::topology

int main(int argc, char** argv) {
  using namespace stope::topology;
  int repeats = 11;
  for (int i = 1; i < argc; ++i)
    if (!std::strcmp(argv[i], "--repeats") && i + 1 < argc) repeats = std::atoi(argv[++i]);
  cv::setNumThreads(1);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  run("Synthetic", synthetic(), repeats);
  const cv::Mat image = read_mine();
  if (!image.empty()) run("Window of the mine", fullest_window(from_image(image, 0.1)), repeats);
}
