#pragma once

#include <memory>

#include "plugins/topology/regions/finish_regions.hpp"
#include "plugins/topology/regions/join_at_doors.hpp"

namespace stope::topology {

/// Divides free space at its doors. Remembers the last grid, and of one that differs within a
/// window computes only what that can reach, with the same result.
class RoomDivider {
 public:
  /// What topology/voronoi_regions is told.
  struct Rule {
    double door_ratio = 0.93;
    double similar_ratio = 0.8;
    double hub_ratio = 1.0;
    double min_region_area = 50.0;  ///< m^2
  };

  RoomDivider(const ExtractionParams& extraction, const Rule& rule, const RegionRoadsRule& roads);
  ~RoomDivider();
  RoomDivider(RoomDivider&&) noexcept;
  RoomDivider& operator=(RoomDivider&&) noexcept;

  /// Throws Error as Ground. `keep` is for a grid that others with changes may follow.
  RegionsAndRoads full(const OccupancyGrid& grid, bool keep,
                       const Checkpoint& checkpoint = never_stop);
  /// Of a grid that differs from the last one within `window` only.
  RegionsAndRoads update(const OccupancyGrid& grid, const CellWindow& window,
                         const Checkpoint& checkpoint = never_stop);
  void forget();
  /// How many regions of the last grid were taken from the one before it.
  std::size_t reused() const;

 private:
  struct State;
  static void label(const State& state, RegionsAndRoads& result);
  RegionsAndRoads finish(State& state, const ChangedSquares* changed,
                         const Checkpoint& checkpoint) const;

  ExtractionParams extraction_;
  Rule rule_;
  RegionRoadsRule roads_;
  std::unique_ptr<State> state_;
};

}  // namespace stope::topology
