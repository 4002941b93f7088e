#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/metric/free_cells.hpp"

namespace stope::metric {

/// A place in free space in whole parts of a cell, kUnit to a cell, from the grid's lower-left
/// corner. Whole numbers, so that lines of sight are decided exactly.
struct LatticePoint {
  static constexpr std::int64_t kUnit = 1024;
  std::int64_t x = 0, y = 0;
  bool operator==(const LatticePoint&) const = default;
};

/// Free cells of one row without a gap.
struct FreeRun {
  std::int64_t begin = 0, end = 0;  ///< columns of its left and right side
};

/// A corner at which a shortest way can turn: a point of the lattice of cells where one obstacle
/// cell meets three free ones, or two obstacle cells meet over it.
struct TurningCorner {
  std::int64_t column = 0, line = 0;  ///< in cells
  bool rising = false;                ///< its obstacle lies up-right or down-left, else the others
};

/// Free space as rows of runs, with the corners that ways can turn at, line by line.
class LatticeSpace {
 public:
  explicit LatticeSpace(const FreeCells& cells);

  std::int64_t rows() const { return static_cast<std::int64_t>(first_run_.size()) - 1; }
  bool free(std::int64_t column, std::int64_t row) const;
  /// The runs of a row, from left to right; none outside of the grid.
  const FreeRun* runs_begin(std::int64_t row) const { return runs_.data() + first_run(row); }
  const FreeRun* runs_end(std::int64_t row) const { return runs_.data() + first_run(row + 1); }
  /// The run of a row that holds x or touches it; none if there is no such.
  const FreeRun* run_at(std::int64_t row, std::int64_t x) const;

  const std::vector<TurningCorner>& corners() const { return corners_; }
  /// Places in corners() of the first corner of a line and of the one after its last.
  std::uint32_t first_corner(std::int64_t line) const {
    return first_corner_[static_cast<std::size_t>(line)];
  }

 private:
  std::size_t first_run(std::int64_t row) const {
    if (row < 0) return 0;
    return first_run_[static_cast<std::size_t>(std::min(row, rows()))];
  }
  std::vector<FreeRun> runs_;
  std::vector<std::size_t> first_run_;  // of each row, and one past the last
  std::vector<TurningCorner> corners_;
  std::vector<std::uint32_t> first_corner_;  // of each line, and one past the last
};

}  // namespace stope::metric
