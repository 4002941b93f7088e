#pragma once

#include <array>
#include <memory>
#include <vector>

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/column_reach.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "plugins/topology/outlines.hpp"
#include "plugins/topology/regions/changed_squares.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::topology {

/// Region of each cell, counted from 1; 0 is none. With the margin of a PaddedGrid.
using RegionCells = PaddedGrid<std::int32_t>;

/// What an update of a ground has changed.
struct GroundChange {
  struct At {
    CellIndex cell = 0;
    std::int32_t squared = 0;  ///< before
  };
  GroundChange(std::int32_t width, std::int32_t height) : squares(width, height) {}
  /// Cells that have another nearest obstacle now, or stopped or began to be one. Some may be here
  /// twice.
  std::vector<At> cells;
  ChangedSquares squares;  ///< of these cells
};

/// Where regions can lie: free cells, and how far each is from the nearest obstacle.
class Ground {
 public:
  /// Obstacles smaller than params.min_obstacle_area become free. Throws Error as make_free_space.
  Ground(const OccupancyGrid& grid, const ExtractionParams& params,
         const Checkpoint& checkpoint = never_stop);
  ~Ground();
  Ground(Ground&&) noexcept;
  Ground& operator=(Ground&&) noexcept;

  /// Becomes the ground of a grid that differs within `window` only, the same as one made of all of
  /// it. False if it cannot (another frame, no free cell left): then, and if the checkpoint throws,
  /// make a new one. The first call costs about as much as a new one, and 12 bytes a cell.
  bool update(const OccupancyGrid& grid, const CellWindow& window, GroundChange& change,
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
  const std::int32_t* squared_cells() const { return squared_.data(); }
  /// Distance from any point (in cells from the lower-left corner) to the centre of the nearest
  /// obstacle cell, as the cells around it see it.
  double distance_at(double x, double y) const;
  std::size_t free_cells() const { return free_cells_; }

 private:
  struct Updating;

  void measure(CellIndex first, std::int32_t column, std::int32_t count, std::int32_t row);

  GridFrame frame_;
  OccupancyRule rule_;
  double least_obstacle_;  ///< cells
  FreeSpace space_;
  EdgeGrid edges_;
  Outlines outlines_;
  PaddedGrid<std::int32_t> squared_;
  std::size_t free_cells_ = 0;
  std::unique_ptr<Updating> updating_;  ///< what an update needs beside; none before the first
};

/// The eight steps to a cell's neighbours in a grid of this stride, straight ones first.
inline std::array<CellIndex, 8> neighbour_steps(CellIndex stride) {
  return {1, stride, -1, -stride, stride + 1, stride - 1, -stride - 1, -stride + 1};
}

/// The square of a share of a distance, of which the square is given.
inline std::int32_t share_of(std::int32_t squared, double share) {
  return static_cast<std::int32_t>(share * share * squared);
}

/// Whether of two cells the first is uphill: the clearer one, of equally clear ones the earlier.
inline bool is_uphill(const Ground& ground, CellIndex a, CellIndex b) {
  const std::int32_t first = ground.squared(a), second = ground.squared(b);
  return first != second ? first > second : a < b;
}

/// Grid of cells without a region.
RegionCells without_regions(const Ground& ground);

}  // namespace stope::topology
