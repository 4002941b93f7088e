// Road graphs of ten synthetic pits measured against the pits' truth, by every measure of the
// metric family: of the true grid, and of the grid mapped from scans. Arguments: [seeds] [size in
// metres] [true or mapped: only these] [first seed].
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "stope/testing/stage_harness.hpp"
#include "synthetic_roads.hpp"

extern "C" const stope::StageEntry* stope_stage_Apls();
extern "C" const stope::StageEntry* stope_stage_Buffer();
extern "C" const stope::StageEntry* stope_stage_Clearance();
extern "C" const stope::StageEntry* stope_stage_Coverage();
extern "C" const stope::StageEntry* stope_stage_DeadEnds();
extern "C" const stope::StageEntry* stope_stage_Detour();
extern "C" const stope::StageEntry* stope_stage_Homotopy();
extern "C" const stope::StageEntry* stope_stage_Junctions();
extern "C" const stope::StageEntry* stope_stage_MedialDistance();
extern "C" const stope::StageEntry* stope_stage_ShortestPaths();
extern "C" const stope::StageEntry* stope_stage_Skeleton();
extern "C" const stope::StageEntry* stope_stage_Topo();
extern "C" const stope::StageEntry* stope_stage_Voronoi();
extern "C" const stope::StageEntry* stope_stage_Watershed();

namespace stope::testing {
namespace {

struct ExtractorCase {
  std::string name;
  const StageEntry* (*stage)();  // none: the true graph, for what no centre line can reach
  std::string sites = {};        // of watershed
  bool medial = false;
};

const std::vector<ExtractorCase> kExtractors{
    {"the truth itself", nullptr},
    {"voronoi", stope_stage_Voronoi},
    {"skeleton", stope_stage_Skeleton},
    {"skeleton, medial_lines", stope_stage_Skeleton, {}, true},
    {"watershed", stope_stage_Watershed},
    {"watershed, sites: outline_parts", stope_stage_Watershed, "outline_parts"}};

RoadGraph extract(const ExtractorCase& extractor, const SyntheticRoads& pit) {
  if (extractor.stage == nullptr) return pit.roads;
  StageHarness stage(extractor.stage());
  if (!extractor.sites.empty()) stage.set("sites", extractor.sites);
  if (extractor.medial) stage.set("medial_lines", true);
  return stage.input("grid", pit.grid).apply<RoadGraph>();
}

constexpr std::array kAgainstTruth{stope_stage_Apls,      stope_stage_Topo,
                                   stope_stage_Buffer,    stope_stage_DeadEnds,
                                   stope_stage_Junctions, stope_stage_ShortestPaths};
constexpr std::array kAgainstGrid{stope_stage_Homotopy, stope_stage_MedialDistance,
                                  stope_stage_Coverage, stope_stage_Clearance, stope_stage_Detour};
// Mapped grids have specks of free cells beside the mine that no truck fits in.
constexpr double kMinPieceArea = 100;
// Half the width of an XG90G truck, for detours against ways that it can take.
constexpr double kHalfTruck = 2;
constexpr double kFar = 200;

/// All figures of one graph, in the order of the stages.
std::vector<std::pair<std::string, double>> measure(const RoadGraph& roads,
                                                    const SyntheticRoads& pit) {
  std::vector<std::pair<std::string, double>> figures;
  const auto add = [&](StageHarness& stage) {
    const auto measures = stage.input("roads", roads).apply<Measures>();
    for (std::size_t i = 0; i < measures.names.size(); ++i)
      figures.emplace_back(measures.names[i], measures.values[i]);
  };
  for (const auto stage : kAgainstTruth) {
    StageHarness harness(stage());
    add(harness.input("truth", pit.roads));
  }
  for (const auto stage : kAgainstGrid) {
    StageHarness harness(stage());
    if (stage == stope_stage_Homotopy) harness.set("min_piece_area", kMinPieceArea);
    if (stage == stope_stage_Detour) harness.input("truth", pit.roads);
    add(harness.input("grid", pit.grid));
  }
  const auto add_detour = [&](const std::string& name, const char* parameter, double value) {
    StageHarness stage(stope_stage_Detour());
    const auto measures =
        stage.input("grid", pit.grid).input("roads", roads).set(parameter, value).apply<Measures>();
    figures.emplace_back(name, measures.values.at(1));
  };
  add_detour("detour_p95 of a truck", "min_clearance", kHalfTruck);
  add_detour("detour_p95 of far pairs", "min_distance", kFar);
  return figures;
}

void print(const std::string& title,
           const std::vector<std::vector<std::pair<std::string, double>>>& runs) {
  fmt::print("\n{}\n{:<26}{:>10}{:>10}{:>10}   each\n", title, "", "mean", "least", "most");
  for (std::size_t i = 0; i < runs.front().size(); ++i) {
    double sum = 0, least = runs.front()[i].second, most = least;
    std::string each;
    for (const auto& run : runs) {
      const double value = run[i].second;
      sum += value;
      least = std::min(least, value);
      most = std::max(most, value);
      each += fmt::format(" {:.3g}", value);
    }
    fmt::print("{:<26}{:>10.4f}{:>10.4f}{:>10.4f}  {}\n", runs.front()[i].first,
               sum / static_cast<double>(runs.size()), least, most, each);
  }
  std::fflush(stdout);
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Streets of 60 m between `side` x `side` crossings.
RoadGraph town(std::uint32_t side) {
  RoadGraph graph;
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    RoadEdge edge;
    edge.from = from, edge.to = to, edge.vertex_count = 2;
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    for (const std::uint32_t node : {from, to})
      graph.vertices.push_back({graph.nodes[node].x, graph.nodes[node].y, 0, 5});
    graph.edges.push_back(edge);
  };
  for (std::uint32_t i = 0; i < side * side; ++i) {
    graph.nodes.push_back({0, 60.0 * (i % side), 60.0 * (i / side), 0});
    if (i % side > 0) add(i - 1, i);
    if (i >= side) add(i - side, i);
  }
  return graph;
}

void time_town() {
  const RoadGraph graph = town(50);
  fmt::print("\nTown of {} streets against itself, CPU time, least of 3\n", graph.edges.size());
  for (const auto stage : {stope_stage_Apls, stope_stage_Topo, stope_stage_Buffer}) {
    StageHarness harness(stage());
    harness.input("roads", graph).input("truth", graph);
    double least = 1e9;
    Measures measures;
    for (int k = 0; k < 3; ++k) {
      const double begin = cpu_seconds();
      measures = harness.apply<Measures>();
      least = std::min(least, cpu_seconds() - begin);
    }
    fmt::print("{:<26}{:>10.4f}   {:.2f} s\n", measures.names.front(), measures.values.front(),
               least);
  }
}

}  // namespace
}  // namespace stope::testing

int main(int count, char** arguments) {
  using namespace stope::testing;
  const std::uint64_t seeds = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10;
  const double size = count > 2 ? std::strtod(arguments[2], nullptr) : 500;
  const std::string only = count > 3 ? arguments[3] : "";
  const std::uint64_t first = count > 4 ? std::strtoull(arguments[4], nullptr, 10) : 1;
  for (const bool mapped : {false, true}) {
    if (only == (mapped ? "true" : "mapped")) continue;
    std::map<std::string, std::vector<std::vector<std::pair<std::string, double>>>> runs;
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      const SyntheticRoads pit = mapped ? mapped_roads(seed) : synthetic_roads(size, seed);
      for (const ExtractorCase& extractor : kExtractors) {
        runs[extractor.name].push_back(measure(extract(extractor, pit), pit));
      }
    }
    for (const ExtractorCase& extractor : kExtractors)
      print(fmt::format("{}, {}, {} pits", extractor.name,
                        mapped ? "grid mapped from scans" : "true grid", seeds),
            runs[extractor.name]);
  }
  time_town();
}
