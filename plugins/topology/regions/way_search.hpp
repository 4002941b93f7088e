#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/topology/regions/region_set.hpp"
#include "plugins/topology/tile_set.hpp"

namespace stope::topology {

/// Searches for ways of least length over clearance within a region.
class WaySearch {
 public:
  /// Ways lead over cells of at least a squared clearance of `least` only, which is 1 or more.
  WaySearch(const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
            std::int32_t least)
      : ground_(ground),
        names_(names),
        set_(set),
        geometry_(ground.width(), ground.height()),
        least_(least) {}

  /// From now on in this region, of which `tiles` are all with cells.
  void enter(std::int32_t region, const std::vector<std::int32_t>& tiles);
  /// Finds the ways from a cell to one other, for which it looks at little else. No cell that a
  /// way can lead over has a squared clearance of more than `widest`.
  void towards(CellIndex from, CellIndex to, std::int32_t widest);
  /// Finds the ways from a cell to several.
  void to_all(CellIndex from, const std::vector<CellIndex>& cells);
  /// The cells from one of those back to where the last search began, both included; none if there
  /// is no way. Of equally good ways the one that is given does not depend on what else was asked.
  std::vector<CellIndex> way_back(CellIndex to);

 private:
  struct Goal {
    bool is_one = false;
    float x = 0, y = 0, clearance = 0, log_clearance = 0;
    float widest = 0, log_widest = 0;  ///< clearance there can be
  };

  void spread(CellIndex from, std::vector<std::int32_t> wanted, float to_bucket);
  float least_cost_on(std::int32_t place) const;
  std::int32_t place_of(CellIndex cell);
  std::int32_t beside(std::int32_t place, std::int32_t dx, std::int32_t dy);
  std::int32_t block_at(std::int32_t box_place);

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  TileSet geometry_;
  std::int32_t least_;
  // The region's tiles, as far as searches have come, one after the other, and in each its cells,
  // row after row, have places.
  struct Cell {
    float slowness;  ///< what half a step through it costs, or that it is a wall
    float cost;      ///< of the way to it
    float left;      ///< at least this is left from here to the goal
    float gone_on;   ///< the cost with which its neighbours were reached last
  };
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> back_;                  ///< the step by which that way comes
  std::vector<std::vector<std::int32_t>> buckets_;  ///< places to go on from, by cost, in turn
  std::vector<std::int32_t> reached_;               ///< places, in the last search
  CellIndex from_ = 0;                              ///< where that began
  Goal goal_;
  // In the box of the region's tiles, which has a margin: which of them a tile is, and back.
  std::int32_t region_ = 0, left_ = 0, bottom_ = 0, across_ = 0;
  std::vector<std::int32_t> number_, box_place_;
};

}  // namespace stope::topology
