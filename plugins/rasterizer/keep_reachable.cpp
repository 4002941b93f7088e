// Problem: a LiDAR sees over the berms: benches, slopes and dumps that no road leads to, in
// tatters. They are no road network.
// Idea: a vehicle's middle keeps half a passage away from obstacles and near free ground (which
// may have small holes where the scans are thin). What of that is connected with the route is
// flooded, and the free ground within half a passage of the flood is kept. So nothing leaks through
// a gap in a berm that no truck fits through.
// Cost: a few passes over the cells.
#include "plugins/rasterizer/keep_reachable.hpp"

#include <cstdint>
#include <vector>

#include "plugins/rasterizer/disc_morphology.hpp"
#include "plugins/rasterizer/route_cells.hpp"

namespace stope::rasterizer {
namespace {

/// Where the middle of a vehicle may be. `radius` in cells.
Mask room_for(const OccupancyGrid& grid, double radius) {
  Mask room = dilate(cells_equal(grid, OccupancyGrid::kFree), radius / 2);
  const Mask blocked = dilate(cells_equal(grid, OccupancyGrid::kOccupied), radius);
  for (std::size_t i = 0; i < room.cells.size(); ++i)
    room.cells[i] = room.cells[i] != 0 && blocked.cells[i] == 0 ? 1 : 0;
  return room;
}

Mask flood(const Mask& room, const std::vector<std::size_t>& seeds) {
  Mask reached{room.width, room.height, std::vector<std::uint8_t>(room.cells.size())};
  std::vector<std::size_t> open;
  const auto visit = [&](std::size_t i) {
    if (room.cells[i] == 0 || reached.cells[i] != 0) return;
    reached.cells[i] = 1;
    open.push_back(i);
  };
  for (const std::size_t seed : seeds) visit(seed);
  const auto width = static_cast<std::size_t>(room.width);
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (i % width > 0) visit(i - 1);
    if (i % width + 1 < width) visit(i + 1);
    if (i >= width) visit(i - width);
    if (i + width < room.cells.size()) visit(i + width);
  }
  return reached;
}

}  // namespace

bool keep_reachable(OccupancyGrid& grid, const Trajectory& trajectory, double passage) {
  const double radius = passage / 2 / grid.frame.resolution;
  const std::vector<std::size_t> seeds = route_cells(grid.frame, trajectory);
  if (seeds.empty()) return false;
  Mask room = room_for(grid, radius);
  for (const std::size_t cell : seeds) room.cells[cell] = 1;  // the vehicle was there
  const Mask covered = dilate(flood(room, seeds), radius);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == OccupancyGrid::kFree && covered.cells[i] == 0)
      grid.cells[i] = OccupancyGrid::kUnknown;
  }
  return true;
}

}  // namespace stope::rasterizer
