#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/padded_grid.hpp"
#include "plugins/topology/regions/growing_hull.hpp"
#include "plugins/topology/regions/ring_table.hpp"

namespace stope::topology {

/// How a region grows (Wang et al. 2019, sec. 2.1). Lengths in cells.
struct GrowthRule {
  double growth_radius = 10;     ///< R_max at the start
  double max_radius = 30;        ///< R_max never passes this; the paper has no such bound
  double radius_weight = 1;      ///< R_w of eq. 1
  double addition_ratio = 0.3;   ///< r_a: a ring with a smaller share of qualified points is last
  double obstacle_ratio = 0.05;  ///< r_o: most unqualified points in the hull for a qualified one
  bool as_printed = false;       ///< Algorithm 1 to the letter: see docs/regions.md
};

/// What grew from a point.
struct Growth {
  std::vector<CellIndex> cells;  ///< the growth point first
  std::int32_t scanned = 0;      ///< the last ring looked at
};

/// Grows regions by Algorithm 1 of Wang et al. Keeps its tables, so one is made for many regions.
class RegionGrower {
 public:
  explicit RegionGrower(const GrowthRule& rule) : rule_(rule) {}
  /// `open`: 1 in cells a region may have, else 0; it is not changed. The growth point is open.
  /// Reads no cell further than Growth::scanned (rounded) from the growth point.
  Growth grow(const PaddedGrid<std::uint8_t>& open, CellIndex from);

 private:
  enum State : std::uint8_t { kQualified = 1, kFailed = 2, kInHull = 4 };
  struct Site;  ///< the open cells around a growth point

  bool ring_is_open(const Site& site, std::int32_t radius);
  bool ray_is_open(const Site& site, const CellOffset& to) const;
  std::size_t scan_ring(const Site& site, std::int32_t radius, Growth& growth);
  void fail(const CellOffset& cell);
  bool fits_hull(const CellOffset& cell, std::size_t qualified);
  void forget_marks(std::int32_t radius);
  void keep_connected(const Site& site, Growth& growth);
  void prepare_marks(std::int32_t radius);
  std::uint8_t& mark(std::int32_t dx, std::int32_t dy) {
    return marks_[static_cast<std::size_t>((dy + reach_) * (2 * reach_ + 1) + dx + reach_)];
  }

  GrowthRule rule_;
  RingTable rings_;
  GrowingHull hull_;
  std::vector<std::uint8_t> marks_;  ///< State by offset, within reach_ of the growth point
  std::int32_t reach_ = 0;
  std::int32_t clear_ = 0;  ///< rings up to this one are open throughout
  std::size_t failed_in_hull_ = 0;
};

}  // namespace stope::topology
