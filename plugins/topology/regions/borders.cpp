#include "plugins/topology/regions/borders.hpp"

#include <algorithm>
#include <tuple>

namespace stope::topology {

std::vector<Border> find_borders(const Ground& ground, const RegionCells& regions,
                                 const Checkpoint& checkpoint) {
  std::vector<Border> found;
  const CellIndex stride = ground.stride();
  const std::array<CellIndex, 4> steps{1, stride - 1, stride, stride + 1};
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      const CellIndex cell = ground.index(column, row);
      const std::int32_t own = regions[cell];
      if (own == 0 || !ground.free(cell)) continue;
      for (const CellIndex step : steps) {
        const std::int32_t other = regions[cell + step];
        if (other == 0 || other == own || !ground.free(cell + step)) continue;
        const std::int32_t squared = std::min(ground.squared(cell), ground.squared(cell + step));
        if (own < other) {
          found.push_back({own, other, 1, cell, cell + step, squared});
        } else {
          found.push_back({other, own, 1, cell + step, cell, squared});
        }
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Border& a, const Border& b) {
    return std::tie(a.first, a.second, b.squared, a.first_door, a.second_door) <
           std::tie(b.first, b.second, a.squared, b.first_door, b.second_door);
  });
  std::size_t kept = 0;
  for (const Border& border : found) {
    if (kept > 0 && found[kept - 1].first == border.first &&
        found[kept - 1].second == border.second) {
      ++found[kept - 1].steps;
    } else {
      found[kept++] = border;
    }
  }
  found.resize(kept);
  return found;
}

}  // namespace stope::topology
