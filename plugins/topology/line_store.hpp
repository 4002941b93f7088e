#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "plugins/topology/tile_set.hpp"
#include "plugins/topology/trace_lines.hpp"

namespace stope::topology {

/// The traced lines of a map, in order, and which of them pass a tile.
class LineStore {
 public:
  LineStore(std::vector<TracedLine> lines, const TileSet& tiles);

  /// Traces the lines that pass the tiles anew, after their marks or the edges seen there changed.
  void update(LineTracer& tracer, const FreeSpace& space, const TileSet& tiles,
              const Courses& courses);
  std::vector<const TracedLine*> list() const;
  std::vector<CourseId> courses() const;
  /// Of the lines listed.
  LineEnds ends() const;

 private:
  struct Entry {
    TracedLine line;
    std::vector<std::int32_t> tiles;  ///< that it passes, ascending
    std::int32_t from = 0, to = 0;    ///< places in nodes_
    bool gone = false;
  };
  /// A corner that lines end at.
  struct Node {
    CellIndex corner = 0;
    std::int32_t lines = 0;  ///< how many ends; 0: not in use
    std::int32_t rank = 0;   ///< among the corners in order
  };
  std::unique_ptr<Entry> enter(TracedLine line, const TileSet& tiles);
  std::int32_t node_at(CellIndex corner);
  void leave(std::int32_t node);
  void put_nodes_in_order();

  std::vector<std::unique_ptr<Entry>> entries_;  ///< in the order of their lines
  std::vector<std::vector<Entry*>> at_tile_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> unused_nodes_, new_nodes_, nodes_in_order_;
  std::unordered_map<CellIndex, std::int32_t> node_of_corner_;
};

}  // namespace stope::topology
