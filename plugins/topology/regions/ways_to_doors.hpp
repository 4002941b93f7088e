#pragma once

#include <vector>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// Finds ways within regions, one after the other.
class WaysToDoors {
 public:
  /// Ways lead over cells of at least a squared clearance of `least` only, which is 1 or more.
  WaysToDoors(const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
              std::int32_t least)
      : ground_(ground), names_(names), set_(set), least_(least) {}
  /// For each of the cells `doors` the cells from it to `centre`, both included; none if such cells
  /// of the region, in which all lie, do not join the two. `tiles` are all with cells of the
  /// region, increasing.
  std::vector<std::vector<CellIndex>> find(CellIndex centre, const std::vector<CellIndex>& doors,
                                           const std::vector<std::int32_t>& tiles);

 private:
  std::int32_t region_of(CellIndex cell) const { return set_.of(names_[cell]); }
  std::vector<CellIndex> straight(CellIndex from, CellIndex to) const;
  void search(CellIndex centre, std::vector<CellIndex> doors);
  void spread(std::int32_t region, const std::vector<std::int32_t>& tiles);
  std::int32_t place_of(CellIndex cell) const;
  std::int32_t beside(std::int32_t place, std::int32_t dx, std::int32_t dy) const;

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  std::int32_t least_;
  // The region's tiles one after the other, and in each its cells, row after row, have places: for
  // each, what half a step through the cell costs, or that it is a wall; what the way from the
  // centre costs, and the step by which it comes.
  std::vector<float> slowness_, cost_;
  std::vector<std::uint8_t> back_;
  float slowest_ = 0, quickest_ = 0;
  // In the box of tiles around them, which has a margin: which of them a tile is, and back.
  std::int32_t left_ = 0, bottom_ = 0, across_ = 0;
  std::vector<std::int32_t> number_, box_place_;
};

}  // namespace stope::topology
