// Problem: the exact nearest obstacle of every cell.
// Idea: first the nearest one in each column, by a sweep up and one down; then along each row the
// lower envelope of the parabolas (column - x)^2 + (rows to that column's nearest)^2. Cost: two
// passes (Meijster, Roerdink and Hesselink 2000; Felzenszwalb and Huttenlocher 2012).
#include "plugins/metric/nearest_obstacle.hpp"

#include <algorithm>

namespace stope::metric {

NearestObstacle::NearestObstacle(const FreeCells& cells)
    : frame_(cells.frame), row_(frame_.size()), column_(frame_.size()) {
  look_along_columns(cells);
  for (std::int32_t row = 0; row < frame_.height; ++row) look_along_row(row);
}

void NearestObstacle::look_along_columns(const FreeCells& cells) {
  const std::int32_t width = frame_.width, height = frame_.height;
  std::vector<std::int32_t> last(static_cast<std::size_t>(width), -1);
  for (std::int32_t row = 0; row < height; ++row) {
    for (std::int32_t column = 0; column < width; ++column) {
      std::int32_t& below = last[static_cast<std::size_t>(column)];
      const std::size_t place = frame_.place({column, row});
      if (!cells.free[place]) below = row;
      row_[place] = below;
    }
  }
  std::fill(last.begin(), last.end(), height);
  for (std::int32_t row = height - 1; row >= 0; --row) {
    for (std::int32_t column = 0; column < width; ++column) {
      std::int32_t& above = last[static_cast<std::size_t>(column)];
      const std::size_t place = frame_.place({column, row});
      if (!cells.free[place]) above = row;
      if (above - row < row - row_[place]) row_[place] = above;
    }
  }
}

void NearestObstacle::look_along_row(std::int32_t row) {
  const std::int32_t width = frame_.width;
  // Columns -1 and width are the border, whose cell in this row is an obstacle.
  const auto rows_to = [&](std::int64_t column) -> std::int64_t {
    if (column < 0 || column >= width) return 0;
    return row_[frame_.place({static_cast<std::int32_t>(column), row})] - row;
  };
  const auto height_at = [&](std::int64_t column, std::int64_t x) {
    const std::int64_t rows = rows_to(column);
    return (column - x) * (column - x) + rows * rows;
  };
  // The last x at which column a is at least as near as b, a < b.
  const auto last_of = [&](std::int64_t a, std::int64_t b) {
    const std::int64_t ra = rows_to(a), rb = rows_to(b);
    const std::int64_t numerator = b * b + rb * rb - a * a - ra * ra, denominator = 2 * (b - a);
    std::int64_t x = numerator / denominator;
    if (numerator < 0 && numerator % denominator != 0) --x;
    return x;
  };
  std::vector<std::int64_t> columns{-1}, begins{-1};  // the envelope: who is nearest from where on
  for (std::int64_t column = 0; column <= width; ++column) {
    while (!columns.empty() &&
           height_at(column, begins.back()) < height_at(columns.back(), begins.back())) {
      columns.pop_back();
      begins.pop_back();
    }
    const std::int64_t begin = columns.empty() ? -1 : last_of(columns.back(), column) + 1;
    if (begin > width) continue;
    columns.push_back(column);
    begins.push_back(begin);
  }
  std::size_t k = 0;
  for (std::int32_t x = 0; x < width; ++x) {
    while (k + 1 < columns.size() && begins[k + 1] <= x) ++k;
    column_[frame_.place({x, row})] = static_cast<std::int32_t>(columns[k]);
  }
}

}  // namespace stope::metric
