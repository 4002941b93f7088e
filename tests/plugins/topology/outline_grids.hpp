#pragma once

#include <cmath>
#include <numbers>

#include "plugins/topology/outlines.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {

inline Outlines outlines_of(const OccupancyGrid& grid) {
  FreeSpace space = make_free_space(grid, {});
  EdgeGrid edges(space.width(), space.height());
  return trace_outlines(space, edges, 0, 4);
}

/// Free within a half plane's strip of 80 x 20 m, turned; its outline is 200 m long.
inline OccupancyGrid turned_strip(double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180),
               s = std::sin(degrees * std::numbers::pi / 180);
  return grid_where(100, 100, 0.5, [=](double x, double y) {
    const double u = c * (x - 50) + s * (y - 50), v = -s * (x - 50) + c * (y - 50);
    return std::abs(u) < 40 && std::abs(v) < 10;
  });
}

}  // namespace stope::topology
