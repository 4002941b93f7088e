#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/padded_grid.hpp"
#include "plugins/topology/regions/blocked_slopes.hpp"
#include "plugins/topology/regions/cell_runs.hpp"
#include "plugins/topology/regions/connected_runs.hpp"
#include "plugins/topology/regions/growing_hull.hpp"
#include "plugins/topology/regions/growth_window.hpp"
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
  std::vector<CellRun> runs;  ///< its cells, increasing; no two runs touch
  std::int32_t scanned = 0;   ///< the last ring looked at
};

/// Grows regions by Algorithm 1 of Wang et al. Keeps its tables, so one is made for many regions.
class RegionGrower {
 public:
  explicit RegionGrower(const GrowthRule& rule) : rule_(rule) {}
  /// `open`: 1 in cells a region may have, else 0; it is not changed. The growth point is open.
  /// What comes out depends on no cell further than Growth::scanned (rounded) from the growth
  /// point, but more are read: `before_reading` may still change them.
  Growth grow(const PaddedGrid<std::uint8_t>& open, CellIndex from,
              GrowthWindow::BeforeReading before_reading = {});

 private:
  struct BlockedCell {
    std::uint8_t octant;
    std::uint16_t along, aside;
  };

  /// A cell that the hull did not take in, because with it that would have held so many failed
  /// ones.
  struct Refusal {
    HullPoint cell;
    std::size_t failed = 0;
  };

  void start_scanning(std::int32_t radius);
  std::size_t scan_ring(const PaddedGrid<std::uint8_t>& open, CellIndex from, std::int32_t radius);
  template <std::size_t kOctant>
  std::size_t scan_octant(std::int32_t radius, std::size_t more);
  bool fits_hull(const HullPoint& cell, std::size_t qualified, Refusal& refusal);
  bool lies_behind(const HullPoint& cell, const HullPoint& between) const;
  void block_rays();
  std::vector<CellRun> disc(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                            std::int32_t radius) const;
  std::vector<CellRun> qualified_cells(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                                       std::int32_t radius);

  GrowthRule rule_;
  RingTable rings_;
  GrowthWindow window_;
  GrowingHull hull_;
  BlockedSlopes slopes_;
  std::vector<BlockedCell> blocked_;  ///< in this ring
  std::vector<Refusal> refusals_;     ///< the last in each direction
  ConnectedRuns connected_;
  std::size_t taken_ = 0;  ///< cells, before this ring
  std::size_t failed_in_hull_ = 0;
};

}  // namespace stope::topology
