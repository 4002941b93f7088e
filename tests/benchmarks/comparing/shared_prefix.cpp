// Processor time of whole processes, all threads together, so that neither another job on the
// machine nor the number of its cores tells in it. The common part P is a run of it alone; an arm's
// own part is a run of the arm, cold, less P, so that starting the process counts once on either
// side.
#include "tests/benchmarks/comparing/shared_prefix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tests/benchmarks/comparing/measured_process.hpp"

namespace stope::benchmark {
namespace {

// A pit is scanned and mapped once; the arms' last stage is a search on the map that takes a while.
constexpr const char* kCommon = R"(stope: 1
name: common
stages:
  scans: {use: source/synthetic_pit}
  cloud: {use: map/point_cloud, in: {scans: scans.scans, trajectory: scans.trajectory}}
  live:  {use: rasterizer/height_difference, in: {cloud: cloud, trajectory: scans.trajectory}}
  prior: {use: prior/trajectory_dilation, in: scans.trajectory, params: {width: 16 m}}
  grid:  {use: fusion/maximum, in: {prior: prior, live: live}}
  roads: {use: topology/voronoi, in: grid}
outputs:
  map.yaml: grid
  roads.geojson: roads
)";
constexpr const char* kWhole = R"(stope: 1
name: whole
include: common.yaml
stages:
  detour: {use: metric/detour, in: {roads: roads, grid: grid}, params: {pairs: 300}}
outputs:
  detour.json: detour
)";

std::string experiment(int arms) {
  std::string text = "stope_experiment: 1\nname: arms\nbase: whole.yaml\narms:\n";
  for (int arm = 0; arm < arms; ++arm)
    text += fmt::format("  arm_{}: {{detour.min_distance: {} m}}\n", arm, 20 + arm);
  return text +
         "metrics: {detour: {from: detour, measure: detour_p95, better: lower, matters: 0}}\n";
}

double cost(std::vector<std::string> arguments, const std::filesystem::path& work) {
  std::filesystem::remove_all(work / "out");
  std::filesystem::remove_all(work / "store");
  for (const std::string& more :
       {std::string("--out"), (work / "out").string(), std::string("--cache"),
        (work / "store").string(), std::string("--threads"), std::string("1"), std::string("-q")})
    arguments.push_back(more);
  const MeasuredProcess ended = run_stope(arguments);
  if (ended.exit_code != 0) throw std::runtime_error("stope " + arguments[0] + " failed");
  return ended.processor;
}

}  // namespace

bool compare_shared_prefixes(int repetitions) {
  const WorkFolder work;
  const auto at = [&](const char* name) { return (work.path() / name).string(); };
  write_text(at("common.yaml"), kCommon);
  write_text(at("whole.yaml"), kWhole);
  bool kept = true;
  for (const int arms : {2, 4, 8}) {
    write_text(at("arms.yaml"), experiment(arms));
    std::vector<double> together, allowed, ratios, prefixes;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      const double prefix = cost({"run", at("common.yaml")}, work.path());
      double sum = prefix;
      for (int arm = 0; arm < arms; ++arm)
        sum += cost({"run", at("whole.yaml"), "--set",
                     fmt::format("detour.min_distance={} m", 20 + arm)},
                    work.path()) -
               prefix;
      together.push_back(cost({"compare", at("arms.yaml")}, work.path()));
      prefixes.push_back(prefix);
      allowed.push_back(sum);
      ratios.push_back(together.back() / sum);
    }
    fmt::print(
        "{} arms: together {:.2f} s, prefix {:.2f} s + own parts {:.2f} s = {:.2f} s, ratio {:.3f} "
        "[{:.3f}, {:.3f}] (median [least, most] of {}; processor time)\n",
        arms, median(together), median(prefixes), median(allowed) - median(prefixes),
        median(allowed), median(ratios), *std::min_element(ratios.begin(), ratios.end()),
        *std::max_element(ratios.begin(), ratios.end()), repetitions);
    kept = kept && median(ratios) <= 1.05;
  }
  return kept;
}

}  // namespace stope::benchmark
