#pragma once

#include <vector>

#include "plugins/topology/nearest_outline.hpp"

namespace stope::topology {

/// Which neighbouring cells belong to different sides of a road, by their nearest outline edges.
class SideRule {
 public:
  /// Cells are divided where their nearest edges belong to different outlines.
  static SideRule between_outlines(const Outlines& outlines) { return {outlines, -1}; }
  /// … or lie more than outlines.gap edges apart on the same one, the shorter way round.
  static SideRule between_sides(const Outlines& outlines) { return {outlines, outlines.gap}; }

  bool divided(OutlineEdge a, OutlineEdge b) const {
    const std::int32_t apart = a < b ? b - a : a - b;
    return apart > outlines_->gap && divided_far(a, b, apart);
  }

 private:
  SideRule(const Outlines& outlines, std::int32_t bound) : outlines_(&outlines), bound_(bound) {}
  bool divided_far(OutlineEdge a, OutlineEdge b, std::int32_t apart) const {
    const std::int32_t outline = outlines_->of_edge[static_cast<std::size_t>(a)];
    if (outline != outlines_->of_edge[static_cast<std::size_t>(b)]) return true;
    if (bound_ < 0) return false;
    return outlines_->list[static_cast<std::size_t>(outline)].count - apart > bound_;
  }
  const Outlines* outlines_;
  std::int32_t bound_;
};

/// One step of a dividing line: the side between a cell and its eastern or northern neighbour.
struct Divide {
  CellIndex cell = 0;
  bool north = false;
};

/// A cell that was given a neighbour's edge instead of its own nearest one.
struct ReplacedEdge {
  CellIndex cell = 0;
  OutlineEdge nearest = 0;
};

/// Marks all dividing lines in `space` and returns the places of the corners they pass, in no
/// particular but a fixed order.
///
/// Every cell is kept together with its nearest outline: where the grid would cut a cell off from
/// it (exact influence zones of points can fall into pieces on a grid), `edges` is changed to a
/// neighbour's; `replaced`, if given, says what was there. Therefore the lines enclose nothing but
/// obstacles: cutting the plane along them leaves one piece for each obstacle, and they have one
/// independent cycle for each hole.
std::vector<CellIndex> find_dividing_lines(FreeSpace& space, const Outlines& outlines,
                                           const SideRule& rule, EdgeGrid& edges,
                                           const Checkpoint& checkpoint = never_stop,
                                           std::vector<ReplacedEdge>* replaced = nullptr);

}  // namespace stope::topology
