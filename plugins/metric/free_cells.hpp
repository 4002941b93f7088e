#pragma once

#include <cstdint>
#include <vector>

#include "stope/about.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::metric {

/// Which cells are free; the parameters all measures on grids share.
struct FreeRule {
  double occupied_threshold = 0.5;
  bool unknown_is_obstacle = true;
};

template <class Stage>
void describe_free_rule(About<Stage>& about) {
  about
      .param("occupied_threshold", &FreeRule::occupied_threshold, between(0.0, 1.0),
             "Least probability with which a cell is an obstacle.")
      .param("unknown_is_obstacle", &FreeRule::unknown_is_obstacle,
             "Whether unknown cells are obstacles; otherwise they are free.");
}

/// The free cells of a grid. What lies outside of it is an obstacle.
struct FreeCells {
  GridFrame frame;
  std::vector<std::uint8_t> free;  ///< 1 free, 0 obstacle; row-major, row 0 lowest
  std::size_t count = 0;           ///< free ones

  bool at(std::int32_t column, std::int32_t row) const {
    return frame.contains({column, row}) && free[frame.place({column, row})] != 0;
  }
};

/// Throws Error if the grid is not whole, has no positive resolution, or no free cell.
FreeCells free_cells(const OccupancyGrid& grid, const FreeRule& rule);

}  // namespace stope::metric
