#pragma once

#include "plugins/topology/extraction_method.hpp"

namespace stope::topology {

/// Free space, its outlines and the nearest of them for each cell.
struct Terrain {
  Terrain(const OccupancyGrid& grid, const ExtractionMethod& method, const Checkpoint& checkpoint)
      : space(make_free_space(grid, method.occupancy(), checkpoint)),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, method.least_obstacle(grid.frame),
                                method.gap(grid.frame), checkpoint)) {
    find_nearest_outline(space, outlines, edges, checkpoint);
  }
  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
};

}  // namespace stope::topology
