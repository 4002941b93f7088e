// Room segmentation against labelled rooms, Table 1 of Wang et al. on our rooms, and time on large
// maps. Protocol and published figures: docs/regions.md.
//   STOPE_PICTURES=folder   also paints every segmentation there
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "plugins/metric/labelled_rooms.hpp"
#include "plugins/metric/region_scores.hpp"
#include "plugins/topology/regions/clearance_basins.hpp"
#include "plugins/topology/regions/segment_by_growth.hpp"
#include "tests/benchmarks/regions/room_maps.hpp"

namespace stope::benchmarks {
namespace {

using topology::Ground;

constexpr double kResolution = 0.05;

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

topology::ExtractionParams room_extraction() {
  topology::ExtractionParams params;
  params.min_clearance = 0.2;
  params.min_obstacle_area = 1.0;
  params.simplify = 0.05;
  return params;
}

topology::GrowingParams room_growing() {
  topology::GrowingParams params;
  params.growth_radius = 1.2;
  params.max_radius = 3.0;
  params.second_radius = 3.0;
  params.merge_radius = 0.8;
  params.merge_area = 30;
  return params;
}

topology::RegionRoadsRule room_roads() { return {0.2, 0.05, topology::Network::kAll, 1.5}; }

topology::RegionsAndRoads voronoi(const OccupancyGrid& grid, double door_ratio, double least_area,
                                  const topology::ExtractionParams& extraction) {
  const Ground ground(grid, extraction);
  std::int32_t count = 0;
  const double cell = grid.frame.resolution * grid.frame.resolution;
  const auto regions =
      topology::divide_at_doors(ground, {door_ratio, least_area / cell}, count, [] {});
  return topology::finish_regions(
      ground, regions, count,
      {extraction.min_clearance, extraction.simplify, topology::Network::kAll, 1.5}, [] {});
}

topology::RegionsAndRoads growing(const OccupancyGrid& grid, const topology::GrowingParams& params,
                                  const topology::ExtractionParams& extraction,
                                  topology::RegionRoadsRule roads) {
  return topology::segment_by_growth(std::make_unique<Ground>(grid, extraction), {}, params, roads,
                                     Random(1));
}

void paint(const RegionMap& map, const std::string& name) {
  if (const char* folder = std::getenv("STOPE_PICTURES"))
    write_picture(map, std::filesystem::path(folder) / (name + ".png"));
}

double number(const char* name, double fallback) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : fallback;
}

/// Large maps: seconds of thread CPU time, least and median of five.
void time_large(const char* name, const OccupancyGrid& grid) {
  for (int member = 0; member < 2; ++member) {
    std::vector<double> times;
    std::size_t regions = 0, roads = 0;
    double covered = 0;
    for (int run = 0; run < static_cast<int>(number("RUNS", 3)); ++run) {
      const double start = thread_seconds();
      const auto result = member == 0
                              ? voronoi(grid, 0.9, 50, {})
                              : growing(grid, {}, {}, {2.0, 0.2, topology::Network::kAll, 1.5});
      times.push_back(thread_seconds() - start);
      regions = result.map.regions.size();
      roads = result.roads.edges.size();
      covered = result.covered;
      if (run == 0) paint(result.map, std::string(name) + (member == 0 ? "-voronoi" : "-growing"));
    }
    std::sort(times.begin(), times.end());
    fmt::print(
        "{:24} {:16} {:5} regions {:5} roads, covered {:.4f}: min {:.3f} s, median {:.3f} s\n",
        name, member == 0 ? "voronoi_regions" : "region_growing", regions, roads, covered,
        times.front(), times[times.size() / 2]);
  }
}

void score_rooms(const std::vector<RoomMap>& maps) {
  const double ratio = number("DOOR_RATIO", 0.9), least = number("LEAST_AREA", 1.0);
  struct Sum {
    double recall = 0, precision = 0, mcc = 0, mean = 0, pairs = 0;
    int count = 0;
  } sums[2][2];
  fmt::print("{:32} {:>5} | {:^44} | {:^44}\n", "map", "rooms", "voronoi_regions",
             "region_growing");
  fmt::print("{:38} | {:>7} {:>6} {:>6} {:>6} {:>6} {:>6} | {:>7} {:>6} {:>6} {:>6} {:>6} {:>6}\n",
             "", "regions", "recall", "prec", "mcc", "mean", "pairs", "regions", "recall", "prec",
             "mcc", "mean", "pairs");
  for (const RoomMap& map : maps) {
    const OccupancyGrid grid = read_rooms(map.picture, kResolution);
    const auto truth = metric::read_labelled_rooms(map.truth, 250, 400);
    fmt::print("{:32} {:5}", map.name, truth.rooms);
    for (int member = 0; member < 2; ++member) {
      const auto result = member == 0
                              ? voronoi(grid, ratio, least, room_extraction())
                              : growing(grid, room_growing(), room_extraction(), room_roads());
      paint(result.map, map.name + (member == 0 ? "-voronoi" : "-growing"));
      const auto s = metric::score_regions(truth.cells, result.map.labels.cells);
      fmt::print(" | {:7} {:6.3f} {:6.3f} {:6.3f} {:6.3f} {:6.3f}", s.regions, s.recall,
                 s.precision, s.mcc, s.mcc_mean, s.mcc_pairs);
      Sum& sum = sums[member][map.name.find("furnitures") != std::string::npos ? 1 : 0];
      sum.recall += s.recall, sum.precision += s.precision, sum.mcc += s.mcc;
      sum.mean += s.mcc_mean, sum.pairs += s.mcc_pairs, ++sum.count;
    }
    fmt::print("\n");
  }
  for (int furnished = 0; furnished < 2; ++furnished) {
    fmt::print("{:38}", furnished ? "mean, with furniture" : "mean, without furniture");
    for (auto& member : sums) {
      const Sum& s = member[furnished];
      const double n = std::max(1, s.count);
      fmt::print(" | {:7} {:6.3f} {:6.3f} {:6.3f} {:6.3f} {:6.3f}", "", s.recall / n,
                 s.precision / n, s.mcc / n, s.mean / n, s.pairs / n);
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace stope::benchmarks

int main() {
  using namespace stope::benchmarks;
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder = data ? data : STOPE_DEFAULT_DATA;
  const auto maps = room_maps(folder / "room_maps");
  if (maps.empty()) fmt::print("no room maps in {}: set STOPE_DATA\n", folder.string());
  score_rooms(maps);
  const auto mine = folder / "open_pit_maps" / "dapai_0p5m.png";
  if (number("RUNS", 3) > 0 && std::filesystem::exists(mine))
    time_large("mine", read_rooms(mine, 0.5));
}
