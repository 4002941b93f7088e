#pragma once

#include <unordered_map>
#include <vector>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/region_shape.hpp"
#include "plugins/topology/road_memo.hpp"

namespace stope::topology {

/// A road from one region's centre to that of another.
struct RegionRoad {
  FinishedRoad settled;  ///< without vertices if there is no way wide enough
  double length = 0;     ///< in cells
  bool exists() const { return !settled.vertices.empty(); }
};

/// What is known of one region.
struct KnownRegion {
  std::vector<CellIndex> members, cut_off;
  std::int64_t cells = 0;
  Axes axes;
  ShapePoint centre;
  std::int32_t widest = 0;  ///< squared clearance
  std::vector<CellIndex> doors;
  std::vector<std::vector<CellIndex>> ways;  ///< from each door to the centre
};

/// What was found out about the regions of a map, for those of the next that are the same.
struct RegionMemo {
  std::vector<KnownRegion> regions;
  std::unordered_map<CellIndex, std::int32_t> place_of;  ///< by the lowest of a region's members
  std::vector<Border> doors;                             ///< between these regions
  std::vector<RegionRoad> roads;                         ///< through these doors
  std::size_t reused = 0;                                ///< regions that were taken as they were
};

/// Which regions of a map are as they were in the one before.
struct SameRegions {
  std::vector<std::uint8_t> same;  ///< by place
  std::vector<std::int32_t> now;   ///< by place in the map before: the region it is, 0 if another

  bool has(std::int32_t region) const { return same[static_cast<std::size_t>(region) - 1] != 0; }
};

/// A door, and which one of the map before it is, if both its regions are as they were; else -1.
struct Door {
  Border border;
  std::int32_t before = -1;
};

}  // namespace stope::topology
