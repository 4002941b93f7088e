// Problem: dividing lines move in a part of the map; mark them there as if all had been marked
// anew.
// Idea: whether cells are divided depends on the edges they see in the end, and these depend on the
// nearest edges and on what strictly nearer neighbours see in the end. So cells that may be cut off
// are decided in the order of distance, those outside of the stale part only if a neighbour they
// depend on has changed: whatever order the full computation takes them in, the result is the same.
// Cost: linear in the area of the stale tiles.
#include "plugins/topology/update_dividing_lines.hpp"

#include <algorithm>
#include <array>
#include <queue>
#include <unordered_map>

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

class Remarker {
 public:
  Remarker(FreeSpace& space, const NamedOutlines& outlines, const SideRule& rule, EdgeGrid& edges,
           const TileSet& stale, TileSet& touched)
      : space_(space),
        outlines_(outlines),
        rule_(rule),
        edges_(edges),
        stale_(stale),
        touched_(touched),
        stride_(space.stride()),
        step_{1, stride_, -1, -stride_} {}

  void run(const std::vector<OutlineEdge>& replacement, std::vector<ReplacedEdge>& replaced) {
    std::vector<Divide> divides;
    for (const std::int32_t tile : stale_.list()) find_divides(tile, divides);
    for (const Divide divide : divides) {
      consider(divide.cell);
      consider(divide.cell + (divide.north ? stride_ : 1));
    }
    for (const ReplacedEdge& old : replaced) {
      consider(old.cell);
      consider_behind(old.cell);
    }
    decide();
    for (std::size_t i = 0; i < replaced.size(); ++i) {
      const CellIndex cell = replaced[i].cell;
      if (!free(cell)) continue;
      const bool changed = edges_[cell] != replacement[i];
      if (changed) touch_around(cell);
      if (changed || !nearest_.contains(cell)) to_mark_.push_back(cell);
      was_replaced_.emplace(cell, replacement[i]);
    }
    for (const auto& [cell, nearest] : nearest_) {
      const auto before = was_replaced_.find(cell);
      if (before != was_replaced_.end() && before->second == edges_[cell]) continue;
      touch_around(cell);
      to_mark_.push_back(cell);
    }
    for (const std::int32_t tile : stale_.list()) mark_tile(tile);
    for (const CellIndex cell : to_mark_)
      for (const Divide divide : around(cell)) mark(divide);
    replaced.clear();
    for (const auto& [cell, nearest] : nearest_) replaced.push_back({cell, nearest});
    std::sort(replaced.begin(), replaced.end(),
              [](const auto& a, const auto& b) { return a.cell < b.cell; });
  }

 private:
  bool free(CellIndex cell) const { return !(space_[cell] & kObstacle); }
  OutlineEdge edge_facing(CellIndex obstacle, int side) const {
    return outlines_.by_name.sides[at(edges_[obstacle])][at(side)];
  }
  bool divided(OutlineEdge a, OutlineEdge b) const {
    return a != b && rule_.divided(outlines_.number[at(a)], outlines_.number[at(b)]);
  }
  /// Whether a line runs between two neighbours; `direction` leads from `a` to `b`.
  bool divided(CellIndex a, CellIndex b, int direction) const {
    const bool a_free = free(a), b_free = free(b);
    if (!a_free && !b_free) return false;
    return divided(a_free ? edges_[a] : edge_facing(a, direction),
                   b_free ? edges_[b] : edge_facing(b, (direction + 2) % 4));
  }
  /// The last cells of the padded grid have no neighbours there.
  bool has_neighbours(CellIndex cell) const { return at(cell) + at(stride_) < space_.size(); }

  void find_divides(std::int32_t tile, std::vector<Divide>& divides) const {
    stale_.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      for (CellIndex cell = first; cell < first + count && has_neighbours(cell); ++cell) {
        if (divided(cell, cell + 1, kEast)) divides.push_back({cell, false});
        if (divided(cell, cell + stride_, kNorth)) divides.push_back({cell, true});
      }
    });
  }

  OutlineEdge nearest(CellIndex cell) const {
    const auto known = nearest_.find(cell);
    return known == nearest_.end() ? edges_[cell] : known->second;
  }
  std::int64_t distance(CellIndex cell) const {
    return free(cell) ? squared_distance(edges_, outlines_.by_name, cell, nearest(cell)) : 0;
  }

  void consider(CellIndex cell) {
    if (free(cell)) open_.emplace(distance(cell), cell);
  }
  /// What a cell sees matters to those of its neighbours that are further from obstacles.
  void consider_behind(CellIndex cell) {
    if (!free(cell)) return;
    const std::int64_t own = distance(cell);
    for (const CellIndex step : step_)
      if (free(cell + step) && distance(cell + step) > own) consider(cell + step);
  }

  void decide() {
    std::pair<std::int64_t, CellIndex> last{-1, -1};
    while (!open_.empty()) {
      const auto next = open_.top();
      open_.pop();
      if (next == last) continue;
      last = next;
      if (decide(next.second)) consider_behind(next.second);
    }
  }

  /// Gives a cell what it sees in the end; whether that is something else than before.
  bool decide(CellIndex cell) {
    const OutlineEdge own = nearest(cell), before = edges_[cell];
    const std::int64_t from_own = distance(cell);
    edges_[cell] = own;
    std::int64_t least = from_own;
    OutlineEdge front = own;
    bool cut_off = true;
    for (int side = 0; side < 4 && cut_off; ++side) {
      const CellIndex next = cell + step_[at(side)];
      const std::int64_t there = distance(next);
      if (there >= from_own) continue;
      cut_off = divided(cell, next, side);
      if (there >= least) continue;
      least = there;
      front = free(next) ? edges_[next] : edge_facing(next, (side + 2) % 4);
    }
    if (cut_off && front != own) {
      nearest_.emplace(cell, own);
      edges_[cell] = front;
    } else {
      nearest_.erase(cell);
    }
    return edges_[cell] != before;
  }

  std::array<Divide, 4> around(CellIndex cell) const {
    return {{{cell, false}, {cell, true}, {cell - 1, false}, {cell - stride_, true}}};
  }
  void touch_around(CellIndex cell) {
    const std::int32_t column = space_.column(cell), row = space_.row(cell);
    touched_.add(column - 1, row - 1, column + 1, row + 1);
  }

  void mark(Divide divide) {
    const CellIndex other = divide.cell + (divide.north ? stride_ : 1);
    const std::uint8_t bit = divide.north ? kDividedNorth : kDividedEast;
    const bool line = divided(divide.cell, other, divide.north ? kNorth : kEast);
    if (line == ((space_[divide.cell] & bit) != 0)) return;
    space_[divide.cell] ^= bit;
    touch_around(divide.cell);
  }

  void mark_tile(std::int32_t tile) {
    stale_.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      for (CellIndex cell = first; cell < first + count && has_neighbours(cell); ++cell) {
        mark({cell, false});
        mark({cell, true});
      }
    });
  }

  FreeSpace& space_;
  const NamedOutlines& outlines_;
  const SideRule& rule_;
  EdgeGrid& edges_;
  const TileSet& stale_;
  TileSet& touched_;
  CellIndex stride_;
  std::array<CellIndex, 4> step_;
  using Entry = std::pair<std::int64_t, CellIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::unordered_map<CellIndex, OutlineEdge>
      nearest_;  ///< of the cells that see another in the end
  std::unordered_map<CellIndex, OutlineEdge> was_replaced_;
  std::vector<CellIndex> to_mark_;
};

}  // namespace

void update_dividing_lines(FreeSpace& space, const NamedOutlines& outlines, const SideRule& rule,
                           EdgeGrid& edges, const TileSet& stale,
                           const std::vector<OutlineEdge>& replacement,
                           std::vector<ReplacedEdge>& replaced, TileSet& touched) {
  Remarker(space, outlines, rule, edges, stale, touched).run(replacement, replaced);
}

}  // namespace stope::topology
