#pragma once

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "plugins/topology/outlines.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::topology {

/// Region of each cell, counted from 1; 0 is none. With the margin of a PaddedGrid.
using RegionCells = PaddedGrid<std::int32_t>;

/// Where regions can lie: free cells, and how far each is from the nearest obstacle.
class Ground {
 public:
  /// Obstacles smaller than params.min_obstacle_area become free. Throws Error as make_free_space.
  Ground(const OccupancyGrid& grid, const ExtractionParams& params,
         const Checkpoint& checkpoint = never_stop);

  const GridFrame& frame() const { return frame_; }
  std::int32_t width() const { return space_.width(); }
  std::int32_t height() const { return space_.height(); }
  CellIndex stride() const { return space_.stride(); }
  std::size_t size() const { return space_.size(); }
  CellIndex index(std::int32_t column, std::int32_t row) const { return space_.index(column, row); }
  std::int32_t column(CellIndex cell) const { return space_.column(cell); }
  std::int32_t row(CellIndex cell) const { return space_.row(cell); }

  bool free(CellIndex cell) const { return !(space_[cell] & kObstacle); }
  /// Squared distance to the centre of the nearest obstacle cell, in cells; 0 in obstacles.
  std::int32_t squared(CellIndex cell) const { return squared_[cell]; }
  /// Distance from any point (in cells from the lower-left corner) to the centre of the nearest
  /// obstacle cell, as the cells around it see it.
  double distance_at(double x, double y) const;
  std::size_t free_cells() const { return free_cells_; }

 private:
  GridFrame frame_;
  FreeSpace space_;
  EdgeGrid edges_;
  Outlines outlines_;
  PaddedGrid<std::int32_t> squared_;
  std::size_t free_cells_ = 0;
};

/// The eight steps to a cell's neighbours in a grid of this stride, straight ones first.
inline std::array<CellIndex, 8> neighbour_steps(CellIndex stride) {
  return {1, stride, -1, -stride, stride + 1, stride - 1, -stride - 1, -stride + 1};
}

/// Grid of cells without a region.
RegionCells without_regions(const Ground& ground);

}  // namespace stope::topology
