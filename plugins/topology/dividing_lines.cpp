// Problem: draw the lines along which the sides of roads meet, with nothing but obstacles inside.
// Idea: flood from all obstacles at once in the order of distance (Meyer's watershed by flooding).
// A distance function has no minimum outside of obstacles, so a free cell is always reached from a
// 4-neighbour that is nearer to an obstacle. Which of several fronts wins the cell is decided by
// the exact distance, not by a queue: the front that carries the cell's own nearest outline edge.
// So a decision is needed only where fronts meet; everywhere else the flood has the result of the
// distance transform, and only the few cells that no such front reaches are taken in turn, in the
// order of distance, by the front of their nearest neighbour.
// Cost: two comparisons a cell; the rest is linear in the lines' length.
#include "plugins/topology/dividing_lines.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <tuple>

#include "plugins/topology/find_divides.hpp"

namespace stope::topology {
namespace {

class Divider {
 public:
  Divider(FreeSpace& space, const Outlines& outlines, const SideRule& rule, EdgeGrid& edges,
          const Checkpoint& checkpoint, std::vector<ReplacedEdge>* replaced)
      : space_(space),
        outlines_(outlines),
        rule_(rule),
        edges_(edges),
        checkpoint_(checkpoint),
        replaced_(replaced),
        stride_(space.stride()),
        step_{1, stride_, -1, -stride_} {}

  std::vector<CellIndex> run() {
    std::vector<Divide> divides =
        find_divides_between_free_cells(space_, outlines_, rule_, edges_, checkpoint_);
    checkpoint_();
    find_along_outlines(divides);
    checkpoint_();
    const std::vector<CellIndex> changed = reunite(divides);
    checkpoint_();
    for (const Divide divide : divides) mark(divide);
    for (const CellIndex cell : changed)
      for (const Divide divide : around(cell)) mark(divide);
    return std::move(corners_);
  }

 private:
  bool free(CellIndex cell) const { return !(space_[cell] & kObstacle); }

  /// Of an obstacle: its edge on the side that faces a free cell.
  OutlineEdge edge_facing(CellIndex obstacle, int side) const {
    return outlines_
        .sides[static_cast<std::size_t>(edges_[obstacle])][static_cast<std::size_t>(side)];
  }

  /// Whether a line runs between two neighbours; `direction` leads from `a` to `b`.
  bool divided(CellIndex a, CellIndex b, int direction) const {
    const bool a_free = free(a), b_free = free(b);
    if (!a_free && !b_free) return false;
    const OutlineEdge first = a_free ? edges_[a] : edge_facing(a, direction);
    const OutlineEdge second = b_free ? edges_[b] : edge_facing(b, (direction + 2) % 4);
    return rule_.divided(first, second);
  }

  /// Where a road is a cell wide, its line runs between the free cell and one of the obstacles.
  void find_along_outlines(std::vector<Divide>& divides) {
    for (const Outline& outline : outlines_.list) {
      for (OutlineEdge edge = outline.first; edge < outline.first + outline.count; ++edge) {
        const Outlines::Place place = outlines_.place[static_cast<std::size_t>(edge)];
        const CellIndex obstacle = space_.index(place.column, place.row);
        const auto& sides = outlines_.sides[static_cast<std::size_t>(edges_[obstacle])];
        for (int side = 0; side < 4; ++side) {
          if (sides[static_cast<std::size_t>(side)] != edge) continue;
          const CellIndex cell = obstacle + step_[static_cast<std::size_t>(side)];
          if (!rule_.divided(edges_[cell], edge)) continue;
          divides.push_back({side == kEast || side == kNorth ? obstacle : cell,
                             side == kNorth || side == kSouth});
        }
      }
    }
  }

  std::array<Divide, 4> around(CellIndex cell) const {
    return {{{cell, false}, {cell, true}, {cell - 1, false}, {cell - stride_, true}}};
  }

  std::int64_t distance(CellIndex cell) const {
    if (!free(cell)) return 0;
    const auto known = distance_of_changed_.find(cell);
    return known != distance_of_changed_.end()
               ? known->second
               : squared_distance(edges_, outlines_, cell, edges_[cell]);
  }

  /// Whether no front that carries the cell's own edge reaches it.
  bool cut_off(CellIndex cell) const {
    const std::int64_t own = distance(cell);
    for (int side = 0; side < 4; ++side) {
      const CellIndex next = cell + step_[static_cast<std::size_t>(side)];
      if (distance(next) < own && !divided(cell, next, side)) return false;
    }
    return true;
  }

  /// Whether a front that carries the cell's own edge reaches it from a neighbour in the direction
  /// of what it sees: such a neighbour is nearer to that. While no cell has been changed this
  /// answers most questions without asking for distances.
  bool reached_straight(CellIndex cell) const {
    const OutlineEdge edge = edges_[cell];
    const Outlines::Place seen = outlines_.place[static_cast<std::size_t>(edge)];
    const std::int32_t row = space_.row(cell);
    const std::int32_t column = cell - space_.index(0, row);
    const auto open = [&](int side) {
      return !divided(cell, cell + step_[static_cast<std::size_t>(side)], side);
    };
    return (seen.row != row && open(seen.row > row ? kNorth : kSouth)) ||
           (seen.column != column && open(seen.column > column ? kEast : kWest));
  }

  void take_nearest_front(CellIndex cell) {
    const std::int64_t own = distance(cell);
    std::int64_t least = own;
    OutlineEdge edge = edges_[cell];
    for (int side = 0; side < 4; ++side) {
      const CellIndex next = cell + step_[static_cast<std::size_t>(side)];
      const std::int64_t there = distance(next);
      if (there >= least) continue;
      least = there;
      edge = free(next) ? edges_[next] : edge_facing(next, (side + 2) % 4);
    }
    // A cell can be taken more than once; what was there first is its own.
    if (distance_of_changed_.emplace(cell, own).second && replaced_)
      replaced_->push_back({cell, edges_[cell]});
    edges_[cell] = edge;
  }

  std::vector<CellIndex> reunite(const std::vector<Divide>& divides) {
    using Entry = std::pair<std::int64_t, CellIndex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto consider = [&](CellIndex cell) {
      if (free(cell) && cut_off(cell)) open.emplace(distance(cell), cell);
    };
    for (const Divide divide : divides)
      for (const CellIndex cell : {divide.cell, divide.cell + (divide.north ? stride_ : 1)})
        if (free(cell) && !reached_straight(cell)) consider(cell);
    std::vector<CellIndex> changed;
    while (!open.empty()) {
      const auto [own, cell] = open.top();
      open.pop();
      if (!cut_off(cell)) continue;
      take_nearest_front(cell);
      changed.push_back(cell);
      for (const CellIndex step : step_)
        if (free(cell + step) && distance(cell + step) > own) consider(cell + step);
    }
    return changed;
  }

  void mark(Divide divide) {
    const CellIndex other = divide.cell + (divide.north ? stride_ : 1);
    const std::uint8_t bit = divide.north ? kDividedNorth : kDividedEast;
    if (!divided(divide.cell, other, divide.north ? kNorth : kEast)) {
      space_[divide.cell] &= static_cast<std::uint8_t>(~bit);
      return;
    }
    space_[divide.cell] |= bit;
    list_corner(divide.cell);
    list_corner(divide.north ? divide.cell - 1 : divide.cell - stride_);
  }

  void list_corner(CellIndex corner) {
    if (space_[corner] & kCorner) return;
    space_[corner] |= kCorner;
    corners_.push_back(corner);
  }

  FreeSpace& space_;
  const Outlines& outlines_;
  const SideRule& rule_;
  EdgeGrid& edges_;
  const Checkpoint& checkpoint_;
  std::vector<ReplacedEdge>* replaced_;
  CellIndex stride_;
  std::array<CellIndex, 4> step_;
  std::map<CellIndex, std::int64_t> distance_of_changed_;
  std::vector<CellIndex> corners_;
};

}  // namespace

std::vector<CellIndex> find_dividing_lines(FreeSpace& space, const Outlines& outlines,
                                           const SideRule& rule, EdgeGrid& edges,
                                           const Checkpoint& checkpoint,
                                           std::vector<ReplacedEdge>* replaced) {
  return Divider(space, outlines, rule, edges, checkpoint, replaced).run();
}

}  // namespace stope::topology
