#include "plugins/rasterizer/free_driven.hpp"

#include "plugins/rasterizer/disc_morphology.hpp"
#include "plugins/rasterizer/route_cells.hpp"

namespace stope::rasterizer {

void free_driven(OccupancyGrid& grid, const Trajectory& trajectory, double width) {
  if (width <= 0) return;
  Mask route{grid.frame.width, grid.frame.height, std::vector<std::uint8_t>(grid.cells.size())};
  for (const std::size_t cell : route_cells(grid.frame, trajectory)) route.cells[cell] = 1;
  const Mask driven = dilate(route, width / 2 / grid.frame.resolution);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (driven.cells[i] != 0) grid.cells[i] = OccupancyGrid::kFree;
  }
}

}  // namespace stope::rasterizer
