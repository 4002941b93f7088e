#include "plugins/metric/lattice_space.hpp"

#include <algorithm>

namespace stope::metric {

LatticeSpace::LatticeSpace(const FreeCells& cells) {
  const std::int32_t width = cells.frame.width, height = cells.frame.height;
  for (std::int32_t row = 0; row < height; ++row) {
    first_run_.push_back(runs_.size());
    std::int32_t begin = -1;
    for (std::int32_t column = 0; column <= width; ++column) {
      const bool free = cells.at(column, row);
      if (free && begin < 0) begin = column;
      if (free || begin < 0) continue;
      runs_.push_back({begin, column});
      begin = -1;
    }
  }
  first_run_.push_back(runs_.size());
  for (std::int32_t line = 0; line <= height; ++line) {
    first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));
    for (std::int32_t column = 0; column <= width; ++column) {
      const bool up_right = !cells.at(column, line), up_left = !cells.at(column - 1, line);
      const bool down_right = !cells.at(column, line - 1);
      const bool down_left = !cells.at(column - 1, line - 1);
      const int rising = up_right + down_left, falling = up_left + down_right;
      const bool one = rising + falling == 1;
      const bool over = rising + falling == 2 && rising != 1;
      if (one || over) corners_.push_back({column, line, rising > 0});
    }
  }
  first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

const FreeRun* LatticeSpace::run_at(std::int64_t row, std::int64_t x) const {
  const FreeRun* end = runs_end(row);
  const FreeRun* run = std::lower_bound(
      runs_begin(row), end, x,
      [](const FreeRun& r, std::int64_t value) { return r.end * LatticePoint::kUnit < value; });
  return run != end && run->begin * LatticePoint::kUnit <= x ? run : nullptr;
}

bool LatticeSpace::free(std::int64_t column, std::int64_t row) const {
  const FreeRun* run = run_at(row, column * LatticePoint::kUnit + LatticePoint::kUnit / 2);
  return run != nullptr;
}

}  // namespace stope::metric
