#pragma once

#include <vector>

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// Finds ways within regions. Keeps a cost for every cell, so one is made for a map; each region is
/// asked for once.
class WaysToDoors {
 public:
  WaysToDoors(const Ground& ground, const RegionCells& regions);
  /// For each of the cells `doors` the cells from it to `centre`, both included; all lie in one
  /// region, which holds together.
  std::vector<std::vector<CellIndex>> find(CellIndex centre, const std::vector<CellIndex>& doors);

 private:
  std::vector<CellIndex> straight(CellIndex from, CellIndex to) const;
  void search(CellIndex centre, const std::vector<CellIndex>& doors);

  const Ground& ground_;
  const RegionCells& regions_;
  PaddedGrid<float> cost_;
  PaddedGrid<std::uint8_t> back_;  ///< the step by which a cell was reached
};

}  // namespace stope::topology
