#pragma once

#include <cstdint>
#include <vector>

#include "plugins/metric/free_cells.hpp"

namespace stope::metric {

/// For each cell the nearest obstacle cell by their centres, exactly; of equally near ones any, but
/// always the same. Obstacles are their own. A border of obstacle cells stands round the grid, so
/// columns and rows may be -1 or the grid's size. O(cells).
class NearestObstacle {
 public:
  explicit NearestObstacle(const FreeCells& cells);
  Cell of(Cell cell) const {
    const std::int32_t column = column_[frame_.place(cell)];
    if (column < 0 || column >= frame_.width) return {column, cell.row};
    return {column, row_[frame_.place({column, cell.row})]};
  }

 private:
  void look_along_columns(const FreeCells& cells);
  void look_along_row(std::int32_t row);

  GridFrame frame_;
  std::vector<std::int32_t> row_;     // of the nearest obstacle in the cell's column
  std::vector<std::int32_t> column_;  // whose row_ in the cell's row is the nearest of all
};

}  // namespace stope::metric
