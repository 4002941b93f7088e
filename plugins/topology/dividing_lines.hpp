#pragma once

#include <vector>

#include "plugins/topology/nearest_outline.hpp"
#include "plugins/topology/outline_shape.hpp"
#include "plugins/topology/outline_turns.hpp"

namespace stope::topology {

/// Which neighbouring cells belong to different sides of a road, by their nearest outline edges.
/// Edges of different outlines always do. Two edges of one outline do or do not depending on these
/// two and the outline between them, the shorter way round.
class SideRule {
 public:
  /// Never two edges of one outline: a watershed.
  static SideRule between_outlines(const Outlines& outlines) { return {outlines, Kind::kOutlines}; }
  /// If they lie more than outlines.gap edges apart along it.
  static SideRule between_sides(const Outlines& outlines) { return {outlines, Kind::kSides}; }
  /// If the way along it is at least `cells` longer than the straight one (Ogniewicz and Kuebler
  /// 1995, chord residual).
  static SideRule by_residual(const Outlines& outlines, const OutlineWays& ways, double cells) {
    SideRule rule{outlines, Kind::kResidual};
    rule.ways_ = &ways;
    rule.least_ = cells;
    return rule;
  }
  /// If it turns towards the free side between them and they are more than outlines.gap apart.
  static SideRule between_parts(const Outlines& outlines, const OutlineTurns& turns) {
    SideRule rule{outlines, Kind::kParts};
    rule.turns_ = &turns;
    return rule;
  }

  /// False wherever the edges' numbers differ by at most outlines.gap.
  bool divided(OutlineEdge a, OutlineEdge b) const {
    const std::int32_t apart = a < b ? b - a : a - b;
    return apart > outlines_->gap && divided_far(a, b, apart);
  }

 private:
  enum class Kind { kOutlines, kSides, kResidual, kParts };
  SideRule(const Outlines& outlines, Kind kind) : outlines_(&outlines), kind_(kind) {}
  bool divided_far(OutlineEdge a, OutlineEdge b, std::int32_t apart) const {
    const std::int32_t outline = outlines_->of_edge[static_cast<std::size_t>(a)];
    if (outline != outlines_->of_edge[static_cast<std::size_t>(b)]) return true;
    if (kind_ == Kind::kOutlines) return false;
    const Outline& whole = outlines_->list[static_cast<std::size_t>(outline)];
    if (whole.count - apart <= outlines_->gap) return false;
    return kind_ == Kind::kSides || divided_within(a, b, outline);
  }
  bool divided_within(OutlineEdge a, OutlineEdge b, std::int32_t outline) const;

  const Outlines* outlines_;
  const OutlineWays* ways_ = nullptr;
  const OutlineTurns* turns_ = nullptr;
  Kind kind_;
  double least_ = 0;
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
