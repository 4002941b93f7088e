#pragma once

#include <memory>
#include <vector>

#include "plugins/topology/tile_set.hpp"
#include "plugins/topology/trace_lines.hpp"

namespace stope::topology {

/// The traced lines of a map, in order, and which of them pass a tile.
class LineStore {
 public:
  LineStore(std::vector<TracedLine> lines, const TileSet& tiles);

  /// Traces the lines that pass the tiles anew, after their marks or the edges seen there changed.
  void update(LineTracer& tracer, const FreeSpace& space, const TileSet& tiles);
  std::vector<const TracedLine*> list() const;
  std::vector<CourseId> courses() const;

 private:
  struct Entry {
    TracedLine line;
    std::vector<std::int32_t> tiles;  ///< that it passes, ascending
    bool gone = false;
  };
  std::unique_ptr<Entry> enter(TracedLine line, const TileSet& tiles);

  std::vector<std::unique_ptr<Entry>> entries_;  ///< in the order of their lines
  std::vector<std::vector<Entry*>> at_tile_;
};

}  // namespace stope::topology
