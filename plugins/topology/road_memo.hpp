#pragma once

#include <unordered_map>
#include <vector>

#include "plugins/topology/line_network.hpp"
#include "plugins/topology/tile_set.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// A centre line in its final form.
struct FinishedRoad {
  std::vector<RoadVertex> vertices;
  double width = 0;
};

/// Remembers what became of centre lines, for as long as neither they nor the distances around them
/// change.
class RoadMemo {
 public:
  /// What became of these points before, or null.
  const FinishedRoad* find(const std::vector<LinePoint>& points);
  /// `places` are the points whose surroundings have been looked at.
  const FinishedRoad& add(const std::vector<LinePoint>& points, FinishedRoad road,
                          const std::vector<LinePoint>& places);
  /// Forgets the roads that were not asked for since the last call, and those of which a place lies
  /// in one of the tiles, which those of later calls belong to.
  void forget(const TileSet& tiles);
  void use_tiles(const TileSet& tiles, CellIndex stride) { tiles_ = &tiles, stride_ = stride; }

 private:
  struct Entry {
    std::vector<LinePoint> points;
    FinishedRoad road;
    std::vector<std::int32_t> tiles;
    bool used = true;
  };
  static std::uint64_t key_of(const std::vector<LinePoint>& points);

  std::unordered_multimap<std::uint64_t, Entry> entries_;
  const TileSet* tiles_ = nullptr;
  CellIndex stride_ = 0;
};

}  // namespace stope::topology
