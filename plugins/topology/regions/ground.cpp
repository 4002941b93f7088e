#include "plugins/topology/regions/ground.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/topology/nearest_outline.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kGap = 64;  // between numbers of outlines; nothing here depends on it

double cells_of_area(const OccupancyGrid& grid, double area) {
  return area / (grid.frame.resolution * grid.frame.resolution);
}

}  // namespace

Ground::Ground(const OccupancyGrid& grid, const ExtractionParams& params,
               const Checkpoint& checkpoint)
    : frame_(grid.frame),
      space_(make_free_space(grid, {params.occupied_threshold, params.unknown_is_obstacle},
                             checkpoint)),
      edges_(space_.width(), space_.height()),
      outlines_(trace_outlines(space_, edges_, cells_of_area(grid, params.min_obstacle_area), kGap,
                               checkpoint)),
      squared_(space_.width(), space_.height()) {
  find_nearest_outline(space_, outlines_, edges_, checkpoint);
  std::fill_n(squared_.padded_row(-1), stride(), 0);
  std::fill_n(squared_.padded_row(height()), stride(), 0);
  for (std::int32_t row = 0; row < height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    std::int32_t* squared = squared_.padded_row(row);
    const CellIndex first = index(-1, row);
    for (std::int32_t column = -1; column <= width(); ++column) {
      const CellIndex cell = first + column + 1;
      squared[column + 1] = 0;
      if (!free(cell)) continue;
      const auto place = outlines_.place[static_cast<std::size_t>(edges_[cell])];
      const std::int32_t dx = column - place.column, dy = row - place.row;
      squared[column + 1] = dx * dx + dy * dy;
      ++free_cells_;
    }
  }
}

double Ground::distance_at(double x, double y) const {
  const auto column = static_cast<std::int32_t>(std::floor(x));
  const auto row = static_cast<std::int32_t>(std::floor(y));
  double least = -1;
  for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, height() - 1); ++r) {
    for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, width() - 1); ++c) {
      const CellIndex cell = index(c, r);
      if (!free(cell)) continue;
      const auto place = outlines_.place[static_cast<std::size_t>(edges_[cell])];
      const double there = std::hypot(x - place.column - 0.5, y - place.row - 0.5);
      least = least < 0 ? there : std::min(least, there);
    }
  }
  return std::max(least, 0.0);
}

RegionCells without_regions(const Ground& ground) {
  RegionCells cells(ground.width(), ground.height());
  std::fill_n(cells.data(), cells.size(), 0);
  return cells;
}

}  // namespace stope::topology
