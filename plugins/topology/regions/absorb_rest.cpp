#include "plugins/topology/regions/absorb_rest.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace stope::topology {

void absorb_rest(const Ground& ground, RegionCells& regions, std::int32_t reach,
                 const Checkpoint& checkpoint) {
  const auto steps = neighbour_steps(ground.stride());
  const auto wanted = [&](CellIndex cell) { return ground.free(cell) && regions[cell] == 0; };
  std::vector<std::pair<CellIndex, std::int32_t>> front, next;  // cell, region that takes it
  const auto look_around = [&](CellIndex cell) {
    for (const CellIndex step : steps)
      if (wanted(cell + step)) next.emplace_back(cell + step, regions[cell]);
  };
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      const CellIndex cell = ground.index(column, row);
      if (regions[cell] != 0 && ground.free(cell)) look_around(cell);
    }
  }
  for (std::int32_t step = 0; step < reach && !next.empty(); ++step) {
    checkpoint();
    std::swap(front, next);
    next.clear();
    std::size_t kept = 0;
    for (const auto& [cell, region] : front) {
      if (!wanted(cell)) continue;
      regions[cell] = region;
      front[kept++] = {cell, region};
    }
    for (std::size_t i = 0; i < kept; ++i) look_around(front[i].first);
  }
}

}  // namespace stope::topology
