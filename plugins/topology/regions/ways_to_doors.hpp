#pragma once

#include <vector>

#include "plugins/topology/regions/region_set.hpp"
#include "plugins/topology/tile_set.hpp"

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
        geometry_(ground.width(), ground.height()),
        least_(least) {}
  /// For each of the cells `doors` the cells from it to `centre`, both included; none if such cells
  /// of the region, in which all lie, do not join the two. `tiles` gives all with cells of the
  /// region, increasing; it is asked only where straight lines do not do. No cell that a way can
  /// lead over has a squared clearance of more than `widest`.
  std::vector<std::vector<CellIndex>> find(CellIndex centre, const std::vector<CellIndex>& doors,
                                           std::int32_t widest,
                                           const std::function<std::vector<std::int32_t>()>& tiles);

 private:
  std::int32_t region_of(CellIndex cell) const { return set_.of(names_[cell]); }
  std::vector<CellIndex> straight(CellIndex from, CellIndex to) const;
  std::vector<CellIndex> search(CellIndex door, CellIndex centre);
  float least_cost_on(std::int32_t place) const;
  void box_tiles(std::int32_t region, const std::vector<std::int32_t>& tiles);
  std::int32_t place_of(CellIndex cell);
  std::int32_t beside(std::int32_t place, std::int32_t dx, std::int32_t dy);
  std::int32_t block_at(std::int32_t box_place);

  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  TileSet geometry_;
  std::int32_t least_;
  // The region's tiles, as far as the search has come, one after the other, and in each its cells,
  // row after row, have places.
  struct Cell {
    float slowness;  ///< what half a step through it costs, or that it is a wall
    float cost;      ///< of the way from the door
    float left;      ///< at least this is left from here to the centre
    float gone_on;   ///< the cost with which its neighbours were reached last
  };
  struct Goal {
    float x = 0, y = 0, clearance = 0, log_clearance = 0;
    float widest = 0, log_widest = 0;  ///< clearance there can be
  };
  Goal goal_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> back_;                  ///< the step by which that way comes
  std::vector<std::vector<std::int32_t>> buckets_;  ///< places to go on from, by cost, in turn
  std::vector<std::int32_t> reached_;               ///< places
  // In the box of the region's tiles, which has a margin: which of them a tile is, and back.
  std::int32_t region_ = 0, left_ = 0, bottom_ = 0, across_ = 0;
  std::vector<std::int32_t> number_, box_place_;
};

}  // namespace stope::topology
