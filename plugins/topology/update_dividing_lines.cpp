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
    for (const std::int32_t tile : stale_.list()) find_divides(tile);
    for (const Divide divide : divides_)
      for (const CellIndex cell : {divide.cell, divide.cell + (divide.north ? stride_ : 1)})
        if (free(cell) && !reached_straight(cell)) consider(cell);
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
      // What a cell sees that was given its edge can be far away, where the outline has changed.
      to_mark_.push_back(cell);
      const auto before = was_replaced_.find(cell);
      if (before == was_replaced_.end() || before->second != edges_[cell]) touch_around(cell);
    }
    for (const Divide divide : divides_) mark(divide);
    for (const Divide divide : marked_) mark(divide);
    for (const CellIndex cell : to_mark_)
      for (const Divide divide : around(cell)) mark(divide);
    replaced.clear();
    for (const auto& [cell, nearest] : nearest_) replaced.push_back({cell, nearest});
    std::sort(replaced.begin(), replaced.end(),
              [](const auto& a, const auto& b) { return a.cell < b.cell; });
  }

 private:
  static constexpr std::uint8_t kMarked = kDividedEast | kDividedNorth;
  /// Far from all numbers.
  static constexpr std::int32_t kNone = INT32_MIN / 2;
  using Row = std::array<std::int32_t, TileSet::kSide + 1>;

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
  /// Lists all steps of lines in a tile, and those that were marked before.
  void find_divides(std::int32_t tile) {
    const auto last = static_cast<CellIndex>(space_.size()) - stride_ - 1;
    CellIndex numbered = -1;
    stale_.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      count = std::min(count, last - first);
      if (count <= 0) return;
      if (numbered == first) {
        std::swap(here_, above_);
      } else {
        number_row(first, here_);
      }
      numbered = first + stride_;
      number_row(numbered, above_);
      if (!may_be_divided(first, count)) return;
      for (std::int32_t i = 0; i < count; ++i) {
        const CellIndex cell = first + i;
        if (is_divided(cell, i, here_[at(i) + 1], kEast)) divides_.push_back({cell, false});
        if (is_divided(cell, i, above_[at(i)], kNorth)) divides_.push_back({cell, true});
        if (!(space_[cell] & kMarked)) continue;
        if (space_[cell] & kDividedEast) marked_.push_back({cell, false});
        if (space_[cell] & kDividedNorth) marked_.push_back({cell, true});
      }
    });
  }
  /// Numbers of the edges that cells in a row see; kNone of obstacles.
  void number_row(CellIndex first, Row& row) const {
    const std::int32_t* number = outlines_.number.data();
    const auto count =
        std::min<std::size_t>(row.size(), space_.size() - static_cast<std::size_t>(first));
    const std::uint8_t* bits = space_.data() + first;
    const std::int32_t* seen = edges_.data() + first;
    const auto is_obstacle = [](std::uint8_t cell) { return (cell & kObstacle) != 0; };
    if (std::all_of(bits, bits + count, is_obstacle)) {
      row.fill(kNone);
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
      row[i] = bits[i] & kObstacle ? kNone : number[at(seen[i])];
  }
  /// False only if no cell of the row is divided from its neighbours, nor was.
  bool may_be_divided(CellIndex first, std::int32_t count) const {
    const auto gap = static_cast<std::uint32_t>(outlines_.by_name.gap);
    std::uint32_t far = 0;
    std::uint8_t bits = 0;
    for (std::size_t i = 0; i < at(count); ++i) {
      const std::uint32_t own = static_cast<std::uint32_t>(here_[i]) + gap;
      const std::uint32_t east = own - static_cast<std::uint32_t>(here_[i + 1]);
      const std::uint32_t north = own - static_cast<std::uint32_t>(above_[i]);
      far |=
          static_cast<std::uint32_t>(east > 2 * gap) | static_cast<std::uint32_t>(north > 2 * gap);
      bits |= space_[first + static_cast<CellIndex>(i)];
    }
    return far || (bits & kMarked);
  }
  bool is_divided(CellIndex cell, std::int32_t i, std::int32_t other, int side) const {
    const std::int32_t own = here_[at(i)];
    if (own != kNone && other != kNone) {
      const std::int32_t apart = own < other ? other - own : own - other;
      return apart > outlines_.by_name.gap && rule_.divided(own, other);
    }
    return own != other && divided(cell, cell + step_[at(side)], side);
  }

  OutlineEdge nearest(CellIndex cell) const {
    const auto known = nearest_.find(cell);
    return known == nearest_.end() ? edges_[cell] : known->second;
  }
  std::int64_t distance(CellIndex cell) const {
    return free(cell) ? squared_distance(edges_, outlines_.by_name, cell, nearest(cell)) : 0;
  }

  /// While all cells see what is nearest: whether a neighbour in the direction of that sees the
  /// same side. Then the cell is not cut off, and most are found so without a look at distances; if
  /// the neighbour comes to see something else, the cell is considered then.
  bool reached_straight(CellIndex cell) const {
    const Outlines::Place seen = outlines_.by_name.place[at(edges_[cell])];
    const std::int32_t row = space_.row(cell);
    const std::int32_t column = cell - space_.index(0, row);
    const auto open = [&](int side) { return !divided(cell, cell + step_[at(side)], side); };
    return (seen.row != row && open(seen.row > row ? kNorth : kSouth)) ||
           (seen.column != column && open(seen.column > column ? kEast : kWest));
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
  std::vector<Divide> divides_, marked_;
  std::vector<CellIndex> to_mark_;
  Row here_, above_;
};

}  // namespace

void update_dividing_lines(FreeSpace& space, const NamedOutlines& outlines, const SideRule& rule,
                           EdgeGrid& edges, const TileSet& stale,
                           const std::vector<OutlineEdge>& replacement,
                           std::vector<ReplacedEdge>& replaced, TileSet& touched) {
  Remarker(space, outlines, rule, edges, stale, touched).run(replacement, replaced);
}

}  // namespace stope::topology
