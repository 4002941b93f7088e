// Problem: an outline of 100 000 edges changes in a few places; give its edges new numbers without
// walking the map.
// Idea: an edge's successor depends on the cells around its own cell only. So the edges of cells in
// or beside the window are cut out of their outlines, which leaves chains of the others; the new
// boundary is walked within the window, and where the walk leaves it, it goes on with the chain
// that starts there. The rings that come out get numbers of their own.
// Cost: linear in the window's area and, with a small constant, in the length of these outlines.
#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "plugins/topology/named_outlines.hpp"
#include "plugins/topology/number_outlines.hpp"
#include "plugins/topology/stayed_runs.hpp"

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

/// Edges of an outline that stayed, in a row.
struct Chain {
  std::int32_t outline = 0, along = 0, count = 0;
};

class OutlineUpdate {
 public:
  OutlineUpdate(NamedOutlines& outlines, FreeSpace& space, EdgeGrid& edges,
                const CellWindow& window)
      : outlines_(outlines),
        named_(outlines.by_name),
        space_(space),
        edges_(edges),
        left_(std::max(window.column - 1, -1)),
        bottom_(std::max(window.row - 1, -1)),
        right_(std::min(window.column + window.width, space.width())),
        top_(std::min(window.row + window.height, space.height())),
        step_{1, space.stride(), -1, -space.stride()} {}

  OutlineChange run() {
    cut_out();
    renew_sides();
    make_chains();
    walk_all();
    leave_out_unchanged();
    for (OutlineRing& ring : rings_) start_ring(ring);
    OutlineChange change;
    change.runs = find_stayed_runs(rings_, outlines_);
    change.outlines = number_rings(rings_, touched_, outlines_);
    for (StayedRun& run : change.runs) run.outline = change.outlines[at(run.outline)];
    if (renumber_if_sparse(outlines_)) forget_numbers(change);
    return change;
  }

 private:
  struct Local {
    CellIndex cell;
    int side;
  };

  template <class Visit>
  void for_each_local_cell(Visit visit) {
    for (std::int32_t row = bottom_; row <= top_; ++row)
      for (std::int32_t column = left_; column <= right_; ++column) visit(column, row);
  }
  bool is_local(std::int32_t column, std::int32_t row) const {
    return column >= left_ && column <= right_ && row >= bottom_ && row <= top_;
  }
  bool is_obstacle(CellIndex cell) const {
    return cell < 0 || at(cell) >= space_.size() || (space_[cell] & kObstacle);
  }
  std::array<OutlineEdge, 4>& sides_of(CellIndex cell) { return named_.sides[at(edges_[cell])]; }

  void cut_out() {
    for_each_local_cell([&](std::int32_t column, std::int32_t row) {
      const CellIndex cell = space_.index(column, row);
      if (!(space_[cell] & kOnOutline)) return;
      for (const OutlineEdge name : sides_of(cell))
        if (name >= 0) cuts_.push_back(outlines_.number[at(name)]);
    });
    std::sort(cuts_.begin(), cuts_.end());
  }

  void renew_sides() {
    for_each_local_cell([&](std::int32_t column, std::int32_t row) {
      const CellIndex cell = space_.index(column, row);
      int wanted = 0;
      if (is_obstacle(cell))
        for (int side = 0; side < 4; ++side)
          if (!is_obstacle(cell + step_[at(side)])) wanted |= 1 << side;
      if (!wanted && !(space_[cell] & kOnOutline)) return;
      if (!(space_[cell] & kOnOutline)) {
        space_[cell] |= kOnOutline;
        edges_[cell] = static_cast<std::int32_t>(named_.sides.size());
        named_.sides.push_back({-1, -1, -1, -1});
      }
      auto& sides = sides_of(cell);
      for (int side = 0; side < 4; ++side) {
        OutlineEdge& name = sides[at(side)];
        if (!(wanted & 1 << side)) {
          if (name >= 0) outlines_.number[at(name)] = -1;
          name = -1;
          continue;
        }
        if (name < 0)
          name = kUnnamed;
        else
          named_.of_edge[at(name)] = kUnvisited;
        locals_.push_back({cell, side});
      }
      if (!wanted) space_[cell] &= static_cast<std::uint8_t>(~kOnOutline);
    });
  }
  OutlineEdge new_name(Outlines::Place place, int side) {
    add_names(1);
    named_.place.back() = place;
    outlines_.side.back() = static_cast<std::uint8_t>(side);
    return static_cast<OutlineEdge>(named_.place.size()) - 1;
  }
  void add_names(std::size_t count) {
    const std::size_t size = named_.place.size() + count;
    named_.place.resize(size);
    named_.of_edge.resize(size, -1);
    outlines_.number.resize(size, -1);
    outlines_.side.resize(size, 0);
  }

  void make_chains() {
    const std::vector<Outline>& list = outlines_.by_number.list;
    for (auto begin = cuts_.begin(); begin != cuts_.end();) {
      const std::int32_t outline = outlines_.by_number.of_edge[at(*begin)];
      const Outline& whole = list[at(outline)];
      const auto end = std::lower_bound(begin, cuts_.end(), whole.first + whole.count);
      touched_.push_back(outline);
      for (auto cut = begin; cut != end; ++cut) {
        const std::int32_t next = cut + 1 == end ? *begin + whole.count : *(cut + 1);
        if (next - *cut <= 1) continue;
        const Chain chain{outline, *cut + 1 - whole.first, next - *cut - 1};
        chain_at_.emplace(name_in(chain, 0), chains_.size());
        chains_.push_back(chain);
      }
      begin = end;
    }
  }
  OutlineEdge name_in(const Chain& chain, std::int32_t i) const {
    const Outline& whole = outlines_.by_number.list[at(chain.outline)];
    const std::int32_t along = (chain.along + i) % whole.count;
    return outlines_.name[at(whole.first + along)];
  }

  void walk_all() {
    // Blocks of names are looked up by where they are seen from: let them be of one change.
    const std::size_t past = named_.place.size() % kNamesOfBlock;
    if (past > 0) add_names(kNamesOfBlock - past);
    for (const Local& local : locals_) {
      const OutlineEdge name = sides_of(local.cell)[at(local.side)];
      if (name == kUnnamed || named_.of_edge[at(name)] == kUnvisited) walk(local);
    }
  }

  void walk(const Local& first) {
    OutlineRing ring;
    CellIndex cell = first.cell;
    int side = first.side;
    do {
      OutlineEdge& name = sides_of(cell)[at(side)];
      // Edges side by side get names side by side.
      if (name == kUnnamed) name = new_name({space_.column(cell), space_.row(cell)}, side);
      ring.breaks.push_back(static_cast<std::int32_t>(ring.names.size()));
      ring.names.push_back(name);
      named_.of_edge[at(name)] = kVisited;
      go_on(cell, side);
      if (is_local(space_.column(cell), space_.row(cell))) continue;
      ring.breaks.push_back(static_cast<std::int32_t>(ring.names.size()));
      append(chains_[chain_at_.at(sides_of(cell)[at(side)])], ring.names);
      const OutlineEdge last = ring.names.back();
      cell = space_.index(named_.place[at(last)].column, named_.place[at(last)].row);
      side = outlines_.side[at(last)];
      go_on(cell, side);
    } while (cell != first.cell || side != first.side);
    rings_.push_back(std::move(ring));
  }
  void append(const Chain& chain, std::vector<OutlineEdge>& names) {
    const Outline& whole = outlines_.by_number.list[at(chain.outline)];
    const auto begin = outlines_.name.begin() + whole.first;
    const std::int32_t to_end = std::min(chain.count, whole.count - chain.along);
    names.insert(names.end(), begin + chain.along, begin + chain.along + to_end);
    names.insert(names.end(), begin, begin + (chain.count - to_end));
  }

  /// To the next edge, with the obstacle on the left.
  void go_on(CellIndex& cell, int& side) const {
    const int ahead = (side + 1) % 4;
    const CellIndex left_ahead = cell + step_[at(ahead)];
    if (!is_obstacle(left_ahead)) {
      side = ahead;
      return;
    }
    const CellIndex right_ahead = left_ahead + step_[at(side)];
    cell = left_ahead;
    if (!is_obstacle(right_ahead)) return;
    cell = right_ahead;
    side = (ahead + 2) % 4;
  }

  /// An outline of which no edge came or went has its numbers already.
  void leave_out_unchanged() {
    std::erase_if(rings_, [&](const OutlineRing& ring) {
      if (!stays(ring, outlines_)) return false;
      const OutlineEdge number = outlines_.number[at(ring.names.front())];
      const std::int32_t outline = outlines_.by_number.of_edge[at(number)];
      for (const std::int32_t place : ring.breaks)
        named_.of_edge[at(ring.names[at(place)])] = outline;
      std::erase(touched_, outline);
      return true;
    });
  }

  /// Lets a ring start where trace_outlines would, and measures its box.
  void start_ring(OutlineRing& ring) {
    auto key = [&](OutlineEdge name) {
      const Outlines::Place place = named_.place[at(name)];
      return std::pair(place.row, place.column);
    };
    std::pair<std::int32_t, std::int32_t> lowest{INT32_MAX, INT32_MAX};
    std::size_t first = 0;
    Outline& box = ring.outline;
    box.left = box.bottom = INT32_MAX, box.right = box.top = INT32_MIN;
    for (std::size_t i = 0; i < ring.names.size(); ++i) {
      const auto [row, column] = key(ring.names[i]);
      box.left = std::min(box.left, column), box.right = std::max(box.right, column);
      box.bottom = std::min(box.bottom, row), box.top = std::max(box.top, row);
      if (outlines_.side[at(ring.names[i])] != kSouth || lowest <= std::pair(row, column)) continue;
      lowest = {row, column};
      first = i;
    }
    ring.start = first;
    box.count = static_cast<std::int32_t>(ring.names.size());
  }

  /// All outlines have new numbers.
  void forget_numbers(OutlineChange& change) const {
    const std::vector<Outline>& list = outlines_.by_number.list;
    change.outlines.clear();
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].count > 0) change.outlines.push_back(static_cast<std::int32_t>(i));
    for (StayedRun& run : change.runs) run.old_outline_first = -1;
  }

  static constexpr std::int32_t kUnvisited = -2, kVisited = -3;  ///< as an outline
  static constexpr OutlineEdge kUnnamed = -2;

  NamedOutlines& outlines_;
  Outlines& named_;
  FreeSpace& space_;
  EdgeGrid& edges_;
  std::int32_t left_, bottom_, right_, top_;
  std::array<CellIndex, 4> step_;
  std::vector<OutlineEdge> cuts_;  ///< numbers
  std::vector<Local> locals_;
  std::vector<std::int32_t> touched_;  ///< places of outlines
  std::vector<Chain> chains_;
  std::unordered_map<OutlineEdge, std::size_t> chain_at_;
  std::vector<OutlineRing> rings_;
};

}  // namespace

OutlineChange update_outlines(NamedOutlines& outlines, FreeSpace& space, EdgeGrid& edges,
                              const CellWindow& window) {
  return OutlineUpdate(outlines, space, edges, window).run();
}

}  // namespace stope::topology
