#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/named_outlines.hpp"
#include "plugins/topology/tile_set.hpp"

namespace stope::topology {

/// From where outline edges are seen: a box for each 32 edges with neighbouring names, and the
/// largest distance. Both only ever grow, so they may be larger than need be.
class SeenFrom {
 public:
  SeenFrom(const FreeSpace& space, const EdgeGrid& edges, const Outlines& outlines,
           const std::vector<ReplacedEdge>& replaced) {
    for (std::int32_t row = 0; row < space.height(); ++row) {
      const std::uint8_t* bits = space.padded_row(row) + 1;
      const std::int32_t* seen = edges.padded_row(row) + 1;
      for (std::int32_t begin = 0; begin < space.width();) {
        std::int32_t end = begin + 1;
        if (!(bits[begin] & kObstacle)) {
          while (end < space.width() && !(bits[end] & kObstacle) &&
                 together(seen[end], seen[begin]))
            ++end;
          add(outlines, seen[begin], seen[end - 1], begin, end - 1, row);
        }
        begin = end;
      }
    }
    for (const ReplacedEdge& cell : replaced) {
      const std::int32_t column = edges.column(cell.cell), row = edges.row(cell.cell);
      add(outlines, cell.nearest, cell.nearest, column, column, row);
    }
  }

  /// Whether two edges share a box.
  static bool together(OutlineEdge a, OutlineEdge b) {
    return a / kNamesOfBlock == b / kNamesOfBlock;
  }

  /// Neighbouring cells of a row whose edges are of the same 32; those of the first and the last.
  void add(const Outlines& outlines, OutlineEdge first, OutlineEdge last, std::int32_t left,
           std::int32_t right, std::int32_t row) {
    const auto block = static_cast<std::size_t>(first / kNamesOfBlock);
    if (block >= boxes_.size()) boxes_.resize(block + 1);
    Box& box = boxes_[block];
    box.left = std::min(box.left, left), box.right = std::max(box.right, right);
    box.bottom = std::min(box.bottom, row), box.top = std::max(box.top, row);
    // From cell to cell the distance changes by at most 1.
    const auto distance = [&](OutlineEdge edge, std::int32_t column) {
      const Outlines::Place place = outlines.place[static_cast<std::size_t>(edge)];
      const auto dx = static_cast<float>(column - place.column);
      const auto dy = static_cast<float>(row - place.row);
      return std::sqrt(dx * dx + dy * dy);
    };
    const float most =
        (distance(first, left) + distance(last, right) + static_cast<float>(right - left)) / 2;
    box.farthest = std::max(box.farthest, most);
    farthest_ = std::max(farthest_, most);
  }

  /// Names the tiles that hold all cells that see one of the edges, what these are on, and their
  /// neighbours.
  void add_tiles(const std::vector<OutlineEdge>& edges, const Outlines& outlines,
                 TileSet& tiles) const {
    std::vector<std::int32_t> blocks;
    for (const OutlineEdge edge : edges) {
      const Outlines::Place place = outlines.place[static_cast<std::size_t>(edge)];
      tiles.add(place.column - 1, place.row - 1, place.column + 1, place.row + 1);
      if (blocks.empty() || blocks.back() != edge / kNamesOfBlock)
        blocks.push_back(edge / kNamesOfBlock);
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    for (const std::int32_t block : blocks) {
      if (static_cast<std::size_t>(block) >= boxes_.size()) continue;
      const Box& box = boxes_[static_cast<std::size_t>(block)];
      if (box.left <= box.right)
        tiles.add(box.left - 1, box.bottom - 1, box.right + 1, box.top + 1);
    }
  }

  /// From how far away an edge, or any edge, is seen at most, in cells.
  double farthest(OutlineEdge edge) const {
    const auto block = static_cast<std::size_t>(edge / kNamesOfBlock);
    return block < boxes_.size() ? static_cast<double>(boxes_[block].farthest) : 0.0;
  }
  double farthest() const { return static_cast<double>(farthest_); }

 private:
  struct Box {
    std::int32_t left = INT32_MAX, bottom = INT32_MAX, right = INT32_MIN, top = INT32_MIN;
    float farthest = 0;
  };
  std::vector<Box> boxes_;
  float farthest_ = 0;
};

}  // namespace stope::topology
