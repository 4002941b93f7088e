// Problem: regions that do not touch may lie in one piece of free space or in several.
// Idea: runs of free cells in a row, joined with those of the row before that they touch.
// Cost: one look at every cell.
#include "plugins/topology/regions/space_pieces.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

struct Run {
  std::int32_t begin = 0, end = 0;  ///< columns, the end is beyond
  std::int32_t number = 0;
};

}  // namespace

std::size_t count_space_pieces(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const RegionSet& set, const Checkpoint& checkpoint) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;  // numbers of runs
  std::vector<std::uint8_t> has_region;                         // by number
  std::vector<Run> before, runs;
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    std::swap(before, runs);
    runs.clear();
    std::size_t below = 0;
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      if (!ground.free(ground.index(column, row))) continue;
      Run run{column, column, static_cast<std::int32_t>(has_region.size())};
      has_region.push_back(0);
      for (; run.end < ground.width() && ground.free(ground.index(run.end, row)); ++run.end)
        if (set.of(names[ground.index(run.end, row)]) != 0) has_region.back() = 1;
      column = run.end;
      while (below < before.size() && before[below].end < run.begin) ++below;
      for (std::size_t i = below; i < before.size() && before[i].begin <= run.end; ++i)
        touching.emplace_back(before[i].number, run.number);
      runs.push_back(run);
    }
  }
  DisjointSets pieces(has_region.size());
  for (const auto& [a, b] : touching) pieces.join(a, b);
  std::vector<std::uint8_t> counted(has_region.size(), 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < has_region.size(); ++i) {
    if (!has_region[i]) continue;
    auto& piece = counted[static_cast<std::size_t>(pieces.find(static_cast<std::int32_t>(i)))];
    count += piece ? 0U : 1U;
    piece = 1;
  }
  return count;
}

}  // namespace stope::topology
