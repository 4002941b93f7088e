#pragma once

#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plugins/topology/regions/region_shape.hpp"
#include "plugins/topology/simplify_line.hpp"

namespace stope::topology {

/// A road from one region's centre to that of another, in cells.
struct RegionRoad {
  std::vector<LinePoint> line;  ///< none if there is no way wide enough
  double median = 0;            ///< distance in cells
};

/// What was found out about the regions of a map, for those of the next that are the same.
struct RegionMemo {
  struct Known {
    std::vector<CellIndex> members, cut_off;
    std::int64_t cells = 0;
    Axes axes;
    ShapePoint centre;
    std::vector<CellIndex> doors;
    std::vector<std::vector<CellIndex>> ways;
  };
  /// By the lowest of the members; looked up, never gone through.
  std::unordered_map<CellIndex, Known> regions;
  /// By the cells of the border that they cross.
  std::map<std::pair<CellIndex, CellIndex>, RegionRoad> roads;
  std::size_t reused = 0;  ///< regions that were taken as they were
};

}  // namespace stope::topology
