#pragma once

#include <vector>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/tile_set.hpp"

namespace stope::topology {

/// From where outline edges are seen: a box for each 32 edges with neighbouring names. Boxes only
/// ever grow, so they may be larger than need be.
class SeenFrom {
 public:
  SeenFrom(const FreeSpace& space, const EdgeGrid& edges,
           const std::vector<ReplacedEdge>& replaced) {
    for (std::int32_t row = 0; row < space.height(); ++row) {
      const std::uint8_t* bits = space.padded_row(row) + 1;
      const std::int32_t* seen = edges.padded_row(row) + 1;
      for (std::int32_t begin = 0; begin < space.width();) {
        std::int32_t end = begin + 1;
        if (!(bits[begin] & kObstacle)) {
          while (end < space.width() && !(bits[end] & kObstacle) &&
                 seen[end] / kEdges == seen[begin] / kEdges)
            ++end;
          add(seen[begin], begin, end - 1, row);
        }
        begin = end;
      }
    }
    for (const ReplacedEdge& cell : replaced)
      add(cell.nearest, edges.column(cell.cell), edges.column(cell.cell), edges.row(cell.cell));
  }

  void add(OutlineEdge edge, std::int32_t left, std::int32_t right, std::int32_t row) {
    const auto block = static_cast<std::size_t>(edge / kEdges);
    if (block >= boxes_.size()) boxes_.resize(block + 1);
    Box& box = boxes_[block];
    box.left = std::min(box.left, left), box.right = std::max(box.right, right);
    box.bottom = std::min(box.bottom, row), box.top = std::max(box.top, row);
  }

  /// Names the tiles that hold all cells that see one of the edges, and their neighbours.
  void add_tiles(const std::vector<OutlineEdge>& edges, TileSet& tiles) const {
    std::vector<std::int32_t> blocks;
    for (const OutlineEdge edge : edges) blocks.push_back(edge / kEdges);
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    for (const std::int32_t block : blocks) {
      if (static_cast<std::size_t>(block) >= boxes_.size()) continue;
      const Box& box = boxes_[static_cast<std::size_t>(block)];
      if (box.left <= box.right)
        tiles.add(box.left - 1, box.bottom - 1, box.right + 1, box.top + 1);
    }
  }

 private:
  static constexpr std::int32_t kEdges = 32;
  struct Box {
    std::int32_t left = INT32_MAX, bottom = INT32_MAX, right = INT32_MIN, top = INT32_MIN;
  };
  std::vector<Box> boxes_;
};

}  // namespace stope::topology
