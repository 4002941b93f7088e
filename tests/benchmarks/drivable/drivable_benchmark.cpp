// Whether a truck can drive what planner/smooth lets pass: recorded scenarios of the real mine,
// random pairs on it and on synthetic pits, each judged by the validator; and the words of Reeds
// and Shepp beside OMPL's.
//   drivable_benchmark [pairs on the mine] [seeds of pits] [pairs on each]
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "stope/testing/stage_harness.hpp"
#include "tests/benchmarks/drivable/trials.hpp"
#include "tests/benchmarks/drivable/word_lengths.hpp"

extern "C" const stope::StageEntry* stope_stage_MapServer();
extern "C" const stope::StageEntry* stope_stage_SyntheticPit();
extern "C" const stope::StageEntry* stope_stage_Voronoi();

namespace stope::testing {
namespace {

namespace fs = std::filesystem;

Site pit(std::uint64_t seed) {
  StageHarness stage(stope_stage_SyntheticPit());
  stage.context().reseed(seed);
  MemoryOutput<OccupancyGrid> grid;
  MemoryOutput<RoadGraph> roads;
  MemoryOutput<ElevationGrid> elevation;
  stage.connect_output("truth_grid", grid)
      .connect_output("truth_roads", roads)
      .connect_output("truth_elevation", elevation)
      .run();
  return {*grid.items.at(0).value, *roads.items.at(0).value, *elevation.items.at(0).value};
}

Site mine(const fs::path& yaml) {
  MemoryOutput<OccupancyGrid> grid;
  StageHarness(stope_stage_MapServer())
      .set("map", yaml.string())
      .connect_output("grid", grid)
      .run();
  Site site{*grid.items.at(0).value, {}, {}};
  site.roads = StageHarness(stope_stage_Voronoi()).input("grid", site.grid).apply<RoadGraph>();
  return site;
}

/// A free place without an obstacle within 3 m, on no road in particular.
std::vector<double> somewhere(const Site& site, Random& random) {
  const GridFrame& frame = site.grid.frame;
  const auto around = static_cast<std::int32_t>(std::ceil(3 / frame.resolution));
  for (;;) {
    const Cell cell{
        static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(frame.width))),
        static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(frame.height)))};
    bool free = true;
    for (std::int32_t dy = -around; dy <= around && free; ++dy) {
      for (std::int32_t dx = -around; dx <= around && free; ++dx) {
        const Cell near{cell.column + dx, cell.row + dy};
        free = frame.contains(near) && site.grid.cells[frame.place(near)] < 127;
      }
    }
    if (!free) continue;
    const Vector2 centre = frame.centre(cell);
    return {centre.x(), centre.y()};
  }
}

std::vector<Trial> random_pairs(const Site& site, int pairs, std::uint64_t seed,
                                const metric::TruckLimits& truck = {}, double min_clearance = 0) {
  Random random(seed);
  std::vector<Trial> trials;
  for (int i = 0; i < pairs; ++i) {
    Task task;
    task.start = somewhere(site, random);
    task.goal = somewhere(site, random);
    task.truck = truck;
    task.min_clearance = min_clearance;
    trials.push_back(run_trial(site, task));
  }
  return trials;
}

bool inside(const std::vector<double>& xs, const std::vector<double>& ys, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, j = xs.size() - 1; i < xs.size(); j = i++) {
    if ((ys[i] > y) != (ys[j] > y) && x < xs[i] + (y - ys[i]) / (ys[j] - ys[i]) * (xs[j] - xs[i]))
      in = !in;
  }
  return in;
}

void scenarios(const Site& site, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream stream(file);
    const auto scene = nlohmann::json::parse(stream);
    const auto& ego = scene.at("ego_info");
    const auto& start = ego.at("start_states");
    const auto number = [](const nlohmann::json& value) {
      return value.is_array() ? value.at(0).get<double>() : value.get<double>();
    };
    const auto xs = scene.at("goal").at("x").get<std::vector<double>>();
    const auto ys = scene.at("goal").at("y").get<std::vector<double>>();
    Task task;
    task.start = {number(start.at("x")), number(start.at("y"))};
    task.start_heading = number(start.at("yaw_rad"));
    task.goal = {0, 0};
    for (std::size_t i = 0; i < xs.size(); ++i) {
      task.goal[0] += xs[i] / static_cast<double>(xs.size());
      task.goal[1] += ys[i] / static_cast<double>(ys.size());
    }
    const Trial trial = run_trial(site, task);
    const std::string vehicle = ego.at("VehicleShapeInfo").at("vehicle_type").get<std::string>();
    if (!trial.sentence.empty()) {
      fmt::print("{} ({}): REFUSED by {}: {}\n", file.stem().string(), vehicle, trial.refused_by,
                 trial.sentence);
      continue;
    }
    const PathPoint& end = trial.path.points.back();
    fmt::print(
        "{} ({}): driven {:.1f} m, ends {} the goal polygon, least radius {:.2f} m, least "
        "clearance {} "
        "{:.2f} m, {} changes of direction, {} stops, violations: {}; {:.3f} s\n",
        file.stem().string(), vehicle, trial.path.length,
        inside(xs, ys, end.x, end.y) ? "in" : "OUTSIDE", trial.radius,
        trial.clearance >= 3 ? "at least" : "", trial.clearance, trial.cusps, trial.jumps,
        trial.violation.empty() ? "none" : trial.violation, trial.seconds);
  }
}

int run(int on_mine, int seeds, int on_pits) {
  compare_with_ompl(100000);
  const char* given = std::getenv("STOPE_DATA");
  const fs::path maps = fs::path(given ? given : STOPE_DEFAULT_DATA) / "open_pit_maps";
  if (fs::exists(maps)) {
    const Site site = mine(maps / "dapai_0p5m.yaml");
    scenarios(site, maps / "scenarios");
    print_trials("Dapai at 0.5 m", random_pairs(site, on_mine, 7));
    metric::TruckLimits large;
    large.length = 13, large.width = 7, large.rear_overhang = 3.5, large.wheelbase = 6;
    large.turning_radius = 15;
    print_trials("the same with a truck of 13 x 7 m that turns with 15 m",
                 random_pairs(site, on_mine / 2, 7, large, 4));
  } else {
    fmt::print("{} is not there: the real mine is left out\n", maps.string());
  }
  std::vector<Trial> all;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto trials = random_pairs(pit(static_cast<std::uint64_t>(seed)), on_pits, 100 + seed);
    all.insert(all.end(), trials.begin(), trials.end());
  }
  print_trials(fmt::format("{} synthetic pits with elevation", seeds), all);
  return 0;
}

}  // namespace
}  // namespace stope::testing

int main(int count, char** arguments) {
  const auto number = [&](int i, int otherwise) {
    return count > i ? std::atoi(arguments[i]) : otherwise;
  };
  return stope::testing::run(number(1, 200), number(2, 10), number(3, 20));
}
