// Problem: a LiDAR sees over the berms: benches, slopes and dumps that no road leads to, in
// tatters. They are no road network.
// Idea: free ground is eroded by half a passage, what is connected with the route is flooded, and
// the flood is dilated back. So nothing leaks through a gap in a berm that no truck fits through.
// Cost: a few passes over the cells.
#include "plugins/rasterizer/keep_reachable.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "plugins/rasterizer/disc_morphology.hpp"

namespace stope::rasterizer {
namespace {

Mask room_for(const OccupancyGrid& grid, double radius) {
  Mask blocked{grid.frame.width, grid.frame.height, std::vector<std::uint8_t>(grid.cells.size())};
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    blocked.cells[i] = grid.cells[i] == OccupancyGrid::kFree ? 0 : 1;
  Mask room = dilate(blocked, radius);
  for (std::uint8_t& cell : room.cells) cell = cell != 0 ? 0 : 1;
  return room;
}

/// The cells of `room` under the trajectory, closer than half a cell from one to the next.
std::vector<std::size_t> seeds_of(const OccupancyGrid& grid, const Trajectory& trajectory,
                                  const Mask& room) {
  std::vector<std::size_t> seeds;
  const auto add = [&](const Vector2& point) {
    const auto cell = grid.frame.cell_at(point.x(), point.y());
    if (cell && room.cells[grid.frame.place(*cell)] != 0) seeds.push_back(grid.frame.place(*cell));
  };
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const Vector2 here = trajectory.poses[i].T_map_lidar.translation.head<2>();
    const Vector2 next = trajectory.poses[i + 1 < trajectory.poses.size() ? i + 1 : i]
                             .T_map_lidar.translation.head<2>();
    const double steps = std::ceil((next - here).norm() / (0.5 * grid.frame.resolution));
    if (!(steps < 1e6)) continue;
    for (double k = 0; k <= steps; ++k)
      add(steps > 0 ? Vector2(here + (k / steps) * (next - here)) : here);
  }
  return seeds;
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
  const Mask room = room_for(grid, radius);
  const std::vector<std::size_t> seeds = seeds_of(grid, trajectory, room);
  if (seeds.empty()) return false;
  const Mask covered = dilate(flood(room, seeds), radius);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == OccupancyGrid::kFree && covered.cells[i] == 0)
      grid.cells[i] = OccupancyGrid::kUnknown;
  }
  return true;
}

}  // namespace stope::rasterizer
