#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/topology/regions/convex_hull.hpp"
#include "plugins/topology/regions/ground.hpp"
#include "plugins/topology/regions/moved_cells.hpp"
#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// A place in cells; the centre of cell (0, 0) is at (0, 0).
struct ShapePoint {
  double x = 0, y = 0;
};

/// Semi-axes in cells and the heading of the major one.
struct Axes {
  double major = 0, minor = 0, yaw = 0;
};

/// What of a region's cells its shape is computed from. Two can be added.
struct RegionShape {
  std::int64_t cells = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  ///< sums over the cells
  std::vector<HullPoint> hull;                                   ///< corners, counter-clockwise

  RegionShape& operator+=(const RegionShape& other);
  /// Semi-axes by principal component analysis: those of the ellipse with the same moments.
  Axes axes() const;
  /// Geometric mean of the semi-axes, at least half a cell.
  double radius() const;
};

/// The centre of gravity of a polygon by eqs. 2 to 5 of Wang et al.: triangles of `pivot` and each
/// side, weighted with their signed areas. A polygon without area gives the mean of its corners.
ShapePoint centre_of_gravity(const std::vector<HullPoint>& polygon, const HullPoint& pivot);

/// The shape of one region, of which `tiles` are all tiles with cells.
RegionShape shape_of(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                     const RegionSet& set, std::int32_t region,
                     std::span<const std::int32_t> tiles);

/// Makes the shapes those of the set's regions, each of which has one name; by name. With `moved`
/// they are those of an earlier map, of which the names tell which are others now. Gives the names
/// of those that were looked at.
std::vector<std::int32_t> update_shapes(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                        const RegionSet& set, const TileParts& tiles,
                                        const MovedCells* moved, std::vector<RegionShape>& shapes,
                                        const Checkpoint& checkpoint);

}  // namespace stope::topology
