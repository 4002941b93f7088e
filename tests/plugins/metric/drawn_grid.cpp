#include "tests/plugins/metric/drawn_grid.hpp"

namespace stope::metric {

OccupancyGrid draw_grid(const std::vector<std::string>& rows, double resolution) {
  OccupancyGrid grid;
  grid.frame.width = static_cast<std::int32_t>(rows.front().size());
  grid.frame.height = static_cast<std::int32_t>(rows.size());
  grid.frame.resolution = resolution;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char cell : *row)
      grid.cells.push_back(cell == '.'   ? OccupancyGrid::kFree
                           : cell == '#' ? OccupancyGrid::kOccupied
                                         : OccupancyGrid::kUnknown);
  return grid;
}

OccupancyGrid random_grid(Random& random, int width, int height, double obstacles) {
  OccupancyGrid grid;
  grid.frame = {width, height, 1, {}};
  grid.cells.resize(grid.frame.size());
  for (auto& cell : grid.cells)
    cell = random.uniform() < obstacles ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
  return grid;
}

OccupancyGrid walled(int width, int height, double resolution) {
  OccupancyGrid grid;
  grid.frame = {width, height, resolution, {}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  for (std::int32_t row = 0; row < height; ++row)
    for (std::int32_t column = 0; column < width; ++column)
      if (row == 0 || column == 0 || row == height - 1 || column == width - 1)
        grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  return grid;
}

}  // namespace stope::metric
