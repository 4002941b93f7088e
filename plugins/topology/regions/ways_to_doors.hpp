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
  void enclose(const std::vector<std::int32_t>& tiles);
  std::int32_t place_of(CellIndex cell) const {
    return (ground_.row(cell) - bottom_) * width_ + ground_.column(cell) - left_;
  }
  CellIndex cell_at(std::int32_t place) const {
    return ground_.index(left_ + place % width_, bottom_ + place / width_);
  }

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  std::int32_t least_;
  // The box around the region's tiles, and by place in it, in the order of cells: what the way from
  // the centre costs, and the step by which it comes.
  std::int32_t left_ = 0, bottom_ = 0, width_ = 0, height_ = 0;
  std::vector<float> cost_;
  std::vector<std::uint8_t> back_;
};

}  // namespace stope::topology
