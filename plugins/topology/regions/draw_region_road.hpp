#pragma once

#include <vector>

#include "plugins/topology/regions/ground.hpp"
#include "plugins/topology/regions/region_memo.hpp"

namespace stope::topology {

/// The road from one region's centre to that of another along these cells: `out` from the door to
/// the first centre, `in` from there to the second. As smooth as it may be without getting nearer
/// than `least` (cells, to obstacles' centres) to an obstacle where the cells do not, and
/// simplified by at most `tolerance` cells.
RegionRoad draw_region_road(const Ground& ground, const ShapePoint& first_centre,
                            const std::vector<CellIndex>& out, const std::vector<CellIndex>& in,
                            const ShapePoint& second_centre, double tolerance, double least);

/// How far from its cells a road depends on the map, in cells.
double reach_of_region_road(double tolerance);

}  // namespace stope::topology
