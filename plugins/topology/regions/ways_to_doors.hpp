#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "plugins/topology/regions/way_search.hpp"

namespace stope::topology {

/// Finds ways within regions, one after the other.
class WaysToDoors {
 public:
  /// Ways lead over cells of at least a squared clearance of `least` only, which is 1 or more.
  WaysToDoors(const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
              std::int32_t least)
      : ground_(ground),
        names_(names),
        set_(set),
        least_(least),
        search_(ground, names, set, least) {}

  /// How many doors a region has decides how its ways are searched for. Where both have as many or
  /// as few, a way depends on its door, the centre and the region only.
  static bool are_many(std::size_t doors) { return doors > 8; }

  /// For each of the cells `doors` the cells from it to `centre`, both included; none if such cells
  /// of the region, in which all lie, do not join the two. `many`: whether the region's doors are.
  /// `tiles` gives all with cells of the region, increasing; it is asked only where straight lines
  /// do not do. No cell that a way can lead over has a squared clearance of more than `widest`.
  std::vector<std::vector<CellIndex>> find(CellIndex centre, const std::vector<CellIndex>& doors,
                                           bool many, std::int32_t widest,
                                           const std::function<std::vector<std::int32_t>()>& tiles);

 private:
  std::int32_t region_of(CellIndex cell) const { return set_.of(names_[cell]); }
  std::vector<CellIndex> straight(CellIndex from, CellIndex to) const;

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  std::int32_t least_;
  WaySearch search_;
};

}  // namespace stope::topology
