// Room segmentation against labelled rooms, Table 1 of Wang et al. on our rooms, and time on large
// maps. Protocol and published figures: docs/regions.md.
//   STOPE_PICTURES=folder   also paints every segmentation there
//   RUNS=0                  leaves out the times; those after changes: incremental_benchmark
//   SCORES=0                only times
//   LEFT_OUT=0              leaves out what leaving maps out gives
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>

#include "plugins/metric/labelled_rooms.hpp"
#include "plugins/metric/region_scores.hpp"
#include "plugins/topology/regions/room_divider.hpp"
#include "plugins/topology/regions/segment_by_growth.hpp"
#include "tests/benchmarks/regions/room_maps.hpp"
#include "tests/benchmarks/topology/city_blocks.hpp"

namespace stope::benchmarks {
namespace {

using topology::Ground;

constexpr double kResolution = 0.05;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double number(const char* name, double fallback) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : fallback;
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
  params.min_region_area = 1;
  return params;
}

topology::RegionRoadsRule room_roads() { return {0.2, 0.05, topology::Network::kAll, 1.5}; }

topology::RoomDivider divider(const topology::RoomDivider::Rule& rule,
                              const topology::ExtractionParams& extraction) {
  return {extraction,
          rule,
          {extraction.min_clearance, extraction.simplify, topology::Network::kAll, 1.5}};
}

topology::RegionsAndRoads growing(const OccupancyGrid& grid, const topology::GrowingParams& params,
                                  const topology::ExtractionParams& extraction,
                                  topology::RegionRoadsRule roads) {
  return topology::segment_by_growth(Ground(grid, extraction), {}, params, roads, Random(1));
}

void paint(const RegionMap& map, const std::string& name) {
  if (const char* folder = std::getenv("STOPE_PICTURES"))
    write_picture(map, std::filesystem::path(folder) / (name + ".png"));
}

/// Seconds, least and median of a few runs.
void time_member(const std::string& name, const char* member,
                 const std::function<topology::RegionsAndRoads()>& segment) {
  std::vector<double> times;
  topology::RegionsAndRoads result;
  for (int run = 0; run < static_cast<int>(number("RUNS", 3)); ++run) {
    const double start = seconds();
    result = segment();
    times.push_back(seconds() - start);
  }
  paint(result.map, name + "-" + member);
  std::sort(times.begin(), times.end());
  fmt::print("{:22} {:28} {:6} regions {:6} roads, covered {:.4f}: min {:.3f} s, median {:.3f} s\n",
             name, member, result.map.regions.size(), result.roads.edges.size(), result.covered,
             times.front(), times[times.size() / 2]);
}

void time_large(const std::string& name, const OccupancyGrid& grid) {
  const topology::RegionRoadsRule roads{2.0, 0.2, topology::Network::kAll, 1.5};
  time_member(name, "voronoi_regions", [&] { return divider({}, {}).full(grid, false); });
  time_member(name, "region_growing", [&] { return growing(grid, {}, {}, roads); });
  std::fflush(stdout);
}

/// Table 1 of Wang et al.: their rooms, and ours at the same resolution.
void table_one(const std::filesystem::path& folder) {
  struct Row {
    const char* name;
    double area;
    int vertices;
    double covered, metric, topological;
  };
  fmt::print(
      "\nTable 1 (cells of 0.20 m; growth radius 1.2 to 3 m, R_w = 1)\n{:24} {:>8} {:>8} {:>8} "
      "{:>11} {:>16} {:>6}\n",
      "", "area m^2", "vertices", "covered", "metric kB", "topological kB", "ratio");
  for (const Row& row : {Row{"Wang: indoor", 171.224, 31, 0.922444, 36.0183, 109.46},
                         Row{"Wang: office", 115.389, 22, 0.985809, 30.0172, 91.27},
                         Row{"Wang: pillar", 129.821, 15, 0.984625, 20.0172, 72.061},
                         Row{"Wang: open", 171.261, 15, 0.936123, 16.0172, 48.0853},
                         Row{"Wang: laboratory", 277.999, 16, 0.883049, 30.0181, 90.0903}})
    fmt::print("{:24} {:8.1f} {:8} {:8.4f} {:11.2f} {:16.2f} {:6.3f}\n", row.name, row.area,
               row.vertices, row.covered, row.metric, row.topological,
               row.topological / row.metric);
  for (const char* name : {"lab_ipa", "lab_c_scan", "lab_b_scan", "lab_d_scan", "lab_intel"}) {
    const auto picture = folder / (std::string(name) + ".png");
    if (!std::filesystem::exists(picture)) continue;
    const OccupancyGrid grid = coarser(read_rooms(picture, kResolution), 4);
    for (const bool printed : {false, true}) {
      topology::ExtractionParams extraction = room_extraction();
      extraction.min_obstacle_area = 0.1;
      topology::GrowingParams params = room_growing();
      params.as_printed = printed;
      const auto result = growing(grid, params, extraction, room_roads());
      paint(result.map, std::string(name) + (printed ? "-table-paper" : "-table"));
      const double free = static_cast<double>(std::count(grid.cells.begin(), grid.cells.end(),
                                                         OccupancyGrid::kFree)) *
                          grid.frame.resolution * grid.frame.resolution;
      const auto header =
          fmt::format("P5\n{} {}\n255\n", grid.frame.width, grid.frame.height).size();
      const auto kilobytes = [&](std::size_t channels) {
        return static_cast<double>(header + channels * grid.cells.size()) / 1000;
      };
      fmt::print("{:24} {:8.1f} {:8} {:8.4f} {:11.2f} {:16.2f} {:6.3f}\n",
                 std::string(name) + (printed ? ", mode: paper" : ""), free,
                 result.map.regions.size(), result.covered, kilobytes(1), kilobytes(3),
                 kilobytes(3) / kilobytes(1));
    }
  }
}

void score_rooms(const std::vector<RoomMap>& maps) {
  const topology::RoomDivider::Rule rule{number("DOOR_RATIO", 0.99), number("SIMILAR", 0.88),
                                         number("HUB", 0.64), 1.0};
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
                              ? divider(rule, room_extraction()).full(grid, false)
                              : growing(grid, room_growing(), room_extraction(), room_roads());
      paint(result.map, map.name + (member == 0 ? "-voronoi" : "-growing"));
      const auto s = metric::score_regions(truth.cells, result.map.labels.cells.to_vector());
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

/// What the rule gives on a map that it was not chosen on: similar_ratio and hub_ratio are the best
/// ones of the other maps without furniture, by the mean of both coefficients.
void leave_one_out(const std::vector<RoomMap>& all) {
  std::vector<topology::RoomDivider::Rule> rules;
  for (double similar = 0.76; similar < 0.965; similar += 0.04)
    for (double hub = 0.52; hub < 1.01; hub += 0.06)
      rules.push_back({0.99, similar, std::min(1.0, hub), 1.0});
  std::vector<RoomMap> maps;
  for (const RoomMap& map : all)
    if (map.name.find("bins") == std::string::npos) maps.push_back(map);
  const auto furnished = [](const RoomMap& map) {
    return map.name.find("furnitures") != std::string::npos;
  };
  std::vector<std::vector<metric::RegionScores>> scores;
  for (const RoomMap& map : maps) {
    const OccupancyGrid grid = read_rooms(map.picture, kResolution);
    const auto truth = metric::read_labelled_rooms(map.truth, 250, 400);
    scores.emplace_back();
    for (const auto& rule : rules)
      scores.back().push_back(metric::score_regions(
          truth.cells,
          divider(rule, room_extraction()).full(grid, false).map.labels.cells.to_vector()));
  }
  const auto best_without = [&](const std::string& name) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t rule = 0; rule < rules.size(); ++rule) {
      double sum = 0;
      for (std::size_t i = 0; i < maps.size(); ++i)
        if (!furnished(maps[i]) && maps[i].name != name)
          sum += scores[i][rule].mcc + scores[i][rule].mcc_mean;
      if (sum > most) most = sum, best = rule;
    }
    return best;
  };
  fmt::print("\nLeft out: the ratios that are best on the six other maps\n");
  double mcc[2] = {0, 0}, mean[2] = {0, 0};
  int count = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (furnished(maps[i])) continue;
    const std::size_t rule = best_without(maps[i].name);
    fmt::print("{:32} similar_ratio {:.2f}, hub_ratio {:.2f}:", maps[i].name,
               rules[rule].similar_ratio, rules[rule].hub_ratio);
    for (std::size_t k = 0; k < maps.size(); ++k) {
      if (k != i && maps[k].name != maps[i].name + "_furnitures") continue;
      const auto& s = scores[k][rule];
      fmt::print(" {} mcc {:.3f} mean {:.3f}", furnished(maps[k]) ? "| furniture" : "", s.mcc,
                 s.mcc_mean);
      mcc[furnished(maps[k])] += s.mcc, mean[furnished(maps[k])] += s.mcc_mean;
    }
    fmt::print("\n");
    ++count;
  }
  for (const int with : {0, 1})
    fmt::print("mean, {} furniture: mcc {:.3f} mean {:.3f}\n", with ? "with" : "without",
               mcc[with] / std::max(1, count), mean[with] / std::max(1, count));
}

}  // namespace
}  // namespace stope::benchmarks

int main() {
  using namespace stope::benchmarks;
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder = data ? data : STOPE_DEFAULT_DATA;
  const auto maps = room_maps(folder / "room_maps");
  if (maps.empty()) fmt::print("no room maps in {}: set STOPE_DATA\n", folder.string());
  if (number("SCORES", 1) > 0) {
    score_rooms(maps);
    if (number("LEFT_OUT", 1) > 0) leave_one_out(maps);
    table_one(folder / "room_maps");
  }
  if (number("RUNS", 3) < 1) return 0;
  const auto mine = folder / "open_pit_maps" / "dapai_0p5m.png";
  for (const std::size_t threads : {std::size_t{1}, std::size_t{2}}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    fmt::print("\nTime on {} thread{}\n", threads, threads == 1 ? "" : "s");
    if (std::filesystem::exists(mine)) time_large("mine 4216 x 2591", read_rooms(mine, 0.5));
    time_large("blocks 4096 x 4096", stope::topology::city_blocks());
  }
}
