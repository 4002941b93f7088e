// Road graphs of synthetic pits held against the pits' true road graphs: every extractor, on the
// true drivable grid and on mapped ones.
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include "road_accuracy.hpp"
#include "synthetic_roads.hpp"

namespace {

using namespace stope::testing;

void add(RoadAccuracy& sum, const RoadAccuracy& one) {
  sum.length_in_roads += one.length_in_roads;
  sum.length_near += one.length_near;
  sum.true_length += one.true_length;
  sum.true_length_found += one.true_length_found;
  sum.dead_ends += one.dead_ends;
  sum.dead_ends_found += one.dead_ends_found;
  sum.spurs += one.spurs;
  sum.cycles += one.cycles;
  sum.true_cycles += one.true_cycles;
}

void print(const char* what, const RoadAccuracy& a) {
  std::printf(
      "%-28s within 1 m: %6.2f %% of %7.0f m found, %6.2f %% of %7.0f m true; dead ends %zu / %zu, "
      "spurs %zu, "
      "cycles %ld (true %ld)\n",
      what, 100 * a.correctness(), a.length_in_roads, 100 * a.completeness(), a.true_length,
      a.dead_ends_found, a.dead_ends, a.spurs, a.cycles, a.true_cycles);
}

}  // namespace

int main() {
  // Smaller pits have no room for three benches; larger ones take long to plan.
  const std::vector<double> sizes{500, 800};
  std::vector<NamedExtractor> extractors(std::begin(kWithDeadEnds), std::end(kWithDeadEnds));
  extractors.push_back({"watershed", Extractor::kWatershed});
  for (const auto& [extractor_name, extractor] : extractors) {
    const std::string name = extractor_name;
    RoadAccuracy sum, mapped_sum;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      for (const double size : sizes) {
        const SyntheticRoads pit = synthetic_roads(size, seed);
        add(sum, measure_roads(extract_roads(pit.grid, extractor), pit.roads));
      }
      const SyntheticRoads mapped = mapped_roads(seed);
      const RoadAccuracy one = measure_roads(extract_roads(mapped.grid, extractor), mapped.roads);
      print((name + ", mapped, seed " + std::to_string(seed)).c_str(), one);
      add(mapped_sum, one);
    }
    print((name + ", true grid, all").c_str(), sum);
    print((name + ", mapped, all").c_str(), mapped_sum);
  }
}
