#pragma once

#include <vector>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// What searches for ways need for every cell. Regions share no cells, so those within different
/// ones can be under way at once.
class WaySearchCells {
 public:
  WaySearchCells(std::int32_t width, std::int32_t height);

 private:
  friend class WaysToDoors;
  PaddedGrid<float> cost_;         ///< infinite where no search is under way
  PaddedGrid<std::uint8_t> back_;  ///< the step by which a cell was reached
};

/// Finds ways within regions, one after the other.
class WaysToDoors {
 public:
  /// Ways lead over cells of at least a squared clearance of `least` only, which is 1 or more.
  WaysToDoors(const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
              WaySearchCells& cells, std::int32_t least)
      : ground_(ground),
        names_(names),
        set_(set),
        cost_(cells.cost_),
        back_(cells.back_),
        least_(least) {}
  /// For each of the cells `doors` the cells from it to `centre`, both included; none if such cells
  /// of the region, in which all lie, do not join the two.
  std::vector<std::vector<CellIndex>> find(CellIndex centre, const std::vector<CellIndex>& doors);

 private:
  std::int32_t region_of(CellIndex cell) const { return set_.of(names_[cell]); }
  std::vector<CellIndex> straight(CellIndex from, CellIndex to) const;
  void search(CellIndex centre, const std::vector<CellIndex>& doors);

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  PaddedGrid<float>& cost_;
  PaddedGrid<std::uint8_t>& back_;
  std::int32_t least_;
  std::vector<CellIndex> reached_;
};

}  // namespace stope::topology
