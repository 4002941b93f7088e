#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "plugins/topology/looked_at.hpp"
#include "plugins/topology/tile_set.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// A centre line in its final form, measured and in the direction that a canonical graph gives it.
struct FinishedRoad {
  std::vector<RoadVertex> vertices;
  RoadEdge edge;                         ///< but for its places in a graph
  std::array<std::uint64_t, 2> nodes{};  ///< ids of the nodes at its first and its last vertex
};

/// Remembers what became of courses, for as long as the distances around them do not change.
class RoadMemo {
 public:
  /// What became of the course of this name before, or null.
  const FinishedRoad* find(std::int64_t name);
  const FinishedRoad& add(std::int64_t name, FinishedRoad road, const LookedAt& looked_at);
  /// Forgets the roads that were not asked for since the last call, and those of which a place lies
  /// in one of the tiles or a cell that was probed in one that has flipped cells. Both sets are
  /// like those of use_tiles.
  void forget(const TileSet& tiles, const TileSet& flipped);
  void use_tiles(const TileSet& tiles, CellIndex stride) { tiles_ = &tiles, stride_ = stride; }

 private:
  struct Entry {
    FinishedRoad road;
    std::vector<std::int32_t> tiles, probed;
    bool used = true;
  };

  std::unordered_map<std::int64_t, Entry> entries_;
  const TileSet* tiles_ = nullptr;
  CellIndex stride_ = 0;
};

}  // namespace stope::topology
