// Road graphs of ten synthetic pits measured against the pits' truth, by every measure of the
// metric family: of the true grid, and of the grid mapped from scans. Arguments: [seeds] [size in
// metres].
#include <fmt/format.h>

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
  const StageEntry* (*stage)();
};

const std::vector<ExtractorCase> kExtractors{{"voronoi", stope_stage_Voronoi},
                                             {"watershed", stope_stage_Watershed}};

constexpr std::array kAgainstTruth{stope_stage_Apls,      stope_stage_Topo,
                                   stope_stage_Buffer,    stope_stage_DeadEnds,
                                   stope_stage_Junctions, stope_stage_ShortestPaths};
constexpr std::array kAgainstGrid{stope_stage_Homotopy, stope_stage_MedialDistance,
                                  stope_stage_Coverage, stope_stage_Clearance};

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
    add(harness.input("grid", pit.grid));
  }
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

}  // namespace
}  // namespace stope::testing

int main(int count, char** arguments) {
  using namespace stope::testing;
  const std::uint64_t seeds = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10;
  const double size = count > 2 ? std::strtod(arguments[2], nullptr) : 500;
  for (const bool mapped : {false, true}) {
    std::map<std::string, std::vector<std::vector<std::pair<std::string, double>>>> runs;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const SyntheticRoads pit = mapped ? mapped_roads(seed) : synthetic_roads(size, seed);
      for (const ExtractorCase& extractor : kExtractors) {
        const auto roads =
            StageHarness(extractor.stage()).input("grid", pit.grid).apply<stope::RoadGraph>();
        runs[extractor.name].push_back(measure(roads, pit));
      }
    }
    for (const ExtractorCase& extractor : kExtractors)
      print(fmt::format("{}, {}, {} pits", extractor.name,
                        mapped ? "grid mapped from scans" : "true grid", seeds),
            runs[extractor.name]);
  }
}
