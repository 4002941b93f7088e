// Problem: an outline of 100 000 edges changes in a few places; give its edges new numbers without
// walking the map.
// Idea: an edge's successor depends on the cells around its own cell only. So the edges of cells in
// or beside the window are cut out of their outlines, which leaves chains of the others; the new
// boundary is walked within the window, and where the walk leaves it, it goes on with the chain
// that starts there. Numbers then follow from the chains by counting.
// Cost: linear in the window's area and, with a small constant, in the outlines' length.
#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "plugins/topology/named_outlines.hpp"

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

/// Edges of an outline that stayed, in a row.
struct Chain {
  std::int32_t outline = 0, along = 0, count = 0;
};

/// A new outline.
struct Ring {
  std::vector<OutlineEdge> names;
  Outline outline;
  Outlines::Place start;
};

class OutlineUpdate {
 public:
  OutlineUpdate(NamedOutlines& outlines, FreeSpace& space, EdgeGrid& edges,
                const CellWindow& window, std::int32_t reach)
      : outlines_(outlines),
        named_(outlines.by_name),
        space_(space),
        edges_(edges),
        reach_(reach),
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
    find_what_changed();
    put_in_order();
    return std::move(change_);
  }

 private:
  struct Local {
    CellIndex cell;
    int side;
    OutlineEdge name;
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
        if (name < 0) name = new_name({column, row}, side);
        locals_.push_back({cell, side, name});
        named_.of_edge[at(name)] = kUnvisited;
      }
      if (!wanted) space_[cell] &= static_cast<std::uint8_t>(~kOnOutline);
    });
  }
  OutlineEdge new_name(Outlines::Place place, int side) {
    named_.place.push_back(place);
    named_.of_edge.push_back(kUnvisited);
    outlines_.number.push_back(-1);
    outlines_.side.push_back(static_cast<std::uint8_t>(side));
    return static_cast<OutlineEdge>(named_.place.size()) - 1;
  }

  void make_chains() {
    const std::vector<Outline>& list = outlines_.by_number.list;
    touched_.assign(list.size(), false);
    for (auto begin = cuts_.begin(); begin != cuts_.end();) {
      const std::int32_t outline = outlines_.by_number.of_edge[at(*begin)];
      const Outline& whole = list[at(outline)];
      const auto end = std::lower_bound(begin, cuts_.end(), whole.first + whole.count);
      touched_[at(outline)] = true;
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
    for (const Local& local : locals_) {
      if (named_.of_edge[at(local.name)] == kUnvisited) walk(local);
    }
  }

  void walk(const Local& first) {
    Ring ring;
    CellIndex cell = first.cell;
    int side = first.side;
    do {
      const OutlineEdge name = sides_of(cell)[at(side)];
      ring.names.push_back(name);
      named_.of_edge[at(name)] = kVisited;
      go_on(cell, side);
      if (is_local(space_.column(cell), space_.row(cell))) continue;
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

  /// Of each ring the runs of edges that were in a row before.
  void find_what_changed() {
    std::unordered_map<std::int32_t, std::size_t> ring_of;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const std::vector<OutlineEdge>& names = rings_[i].names;
      const auto old_number = [&](std::size_t place) {
        return outlines_.number[at(names[place % names.size()])];
      };
      std::int32_t group = -1;
      std::size_t begin = 0, count = names.size();
      // From the first place where a run ends, all around.
      while (begin < count && follows(old_number(begin), old_number(begin + 1))) ++begin;
      if (begin == count) continue;
      for (std::size_t k = begin + 1, run = 0; k <= begin + count; ++k, ++run) {
        const std::int32_t own = old_number(k);
        if (run == 0 && own >= 0) {
          const std::int32_t outline = outlines_.by_number.of_edge[at(own)];
          change_.regrouped = change_.regrouped || (group >= 0 && group != outline) ||
                              ring_of.emplace(outline, i).first->second != i;
          group = outline;
        }
        if (follows(own, old_number(k + 1))) continue;
        if (own >= 0) add_near(names, k - run, run + 1);
        run = static_cast<std::size_t>(-1);
      }
    }
  }
  /// Whether one number came right behind another.
  bool follows(std::int32_t first, std::int32_t second) const {
    if (first < 0 || second < 0) return false;
    if (second == first + 1) return true;
    const Outline& whole = outlines_.by_number.list[at(outlines_.by_number.of_edge[at(first)])];
    return second == whole.first && first == whole.first + whole.count - 1;
  }
  void add_near(const std::vector<OutlineEdge>& names, std::size_t first, std::size_t count) {
    const std::size_t reach = std::min(at(reach_), count);
    for (std::size_t i = 0; i < reach; ++i) {
      change_.near.push_back(names[(first + i) % names.size()]);
      change_.near.push_back(names[(first + count - 1 - i) % names.size()]);
    }
  }

  /// Lets a ring start where trace_outlines would, and measures its box.
  void start_ring(Ring& ring) {
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
    std::rotate(ring.names.begin(), ring.names.begin() + static_cast<std::ptrdiff_t>(first),
                ring.names.end());
    ring.start = {lowest.second, lowest.first};
  }

  void put_in_order() {
    for (Ring& ring : rings_) start_ring(ring);
    std::sort(rings_.begin(), rings_.end(), [](const Ring& a, const Ring& b) {
      return std::tie(a.start.row, a.start.column) < std::tie(b.start.row, b.start.column);
    });
    Outlines now;
    now.gap = named_.gap;
    std::vector<OutlineEdge> names;
    names.reserve(outlines_.name.size() + locals_.size() + 1024);
    const Outlines& old = outlines_.by_number;
    std::size_t ring = 0, outline = 0;
    const auto add = [&](Outline whole, const OutlineEdge* begin, std::int32_t count,
                         bool same_numbers) {
      whole.first = static_cast<OutlineEdge>(names.size());
      whole.count = count;
      names.insert(names.end(), begin, begin + count);
      names.insert(names.end(), at(now.gap), -1);
      if (!same_numbers) {
        for (std::int32_t i = 0; i < count; ++i) {
          outlines_.number[at(begin[i])] = whole.first + i;
          named_.of_edge[at(begin[i])] = static_cast<std::int32_t>(now.list.size());
        }
      }
      now.list.push_back(whole);
    };
    while (true) {
      while (outline < old.list.size() && touched_[outline]) ++outline;
      const bool more = outline < old.list.size();
      if (!more && ring == rings_.size()) break;
      const auto start_of = [&](const Outline& whole) {
        return named_.place[at(outlines_.name[at(whole.first)])];
      };
      const auto comes_first = [](Outlines::Place a, Outlines::Place b) {
        return std::tie(a.row, a.column) < std::tie(b.row, b.column);
      };
      if (ring < rings_.size() &&
          (!more || comes_first(rings_[ring].start, start_of(old.list[outline])))) {
        add(rings_[ring].outline, rings_[ring].names.data(),
            static_cast<std::int32_t>(rings_[ring].names.size()), false);
        ++ring;
      } else {
        const Outline& whole = old.list[outline];
        add(whole, outlines_.name.data() + whole.first, whole.count,
            at(whole.first) == names.size() && outline == now.list.size());
        ++outline;
      }
    }
    number_all(now, std::move(names));
  }

  void number_all(Outlines& now, std::vector<OutlineEdge> names) {
    now.of_edge.resize(names.size(), -1);
    for (std::size_t i = 0; i < now.list.size(); ++i) {
      const Outline& whole = now.list[i];
      std::fill_n(now.of_edge.begin() + whole.first, whole.count, static_cast<std::int32_t>(i));
    }
    outlines_.name = std::move(names);
    outlines_.by_number = std::move(now);
    named_.list = outlines_.by_number.list;
  }

  static constexpr std::int32_t kUnvisited = -2, kVisited = -3;

  NamedOutlines& outlines_;
  Outlines& named_;
  FreeSpace& space_;
  EdgeGrid& edges_;
  std::int32_t reach_, left_, bottom_, right_, top_;
  std::array<CellIndex, 4> step_;
  std::vector<OutlineEdge> cuts_;  ///< numbers
  std::vector<Local> locals_;
  std::vector<bool> touched_;  ///< by outline
  std::vector<Chain> chains_;
  std::unordered_map<OutlineEdge, std::size_t> chain_at_;
  std::vector<Ring> rings_;
  OutlineChange change_;
};

}  // namespace

NamedOutlines::NamedOutlines(const Outlines& outlines, const EdgeGrid& edges)
    : by_name(outlines), by_number(outlines), side(outlines.place.size(), 0) {
  by_number.sides.clear();
  number.resize(outlines.place.size(), -1);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (outlines.of_edge[i] < 0) continue;
    const auto edge = static_cast<OutlineEdge>(i);
    const Outlines::Place place = outlines.place[i];
    const auto& sides = outlines.sides[at(edges[edges.index(place.column, place.row)])];
    number[i] = edge;
    side[i] =
        static_cast<std::uint8_t>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
  }
  name = number;
}

std::vector<std::uint8_t> NamedOutlines::sides_by_number() const {
  std::vector<std::uint8_t> result(name.size(), 0);
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] >= 0) result[i] = side[at(name[i])];
  return result;
}

void NamedOutlines::place_by_number() {
  by_number.place.assign(name.size(), {});
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] >= 0) by_number.place[i] = by_name.place[at(name[i])];
}

OutlineChange update_outlines(NamedOutlines& outlines, FreeSpace& space, EdgeGrid& edges,
                              const CellWindow& window, std::int32_t reach) {
  return OutlineUpdate(outlines, space, edges, window, reach).run();
}

}  // namespace stope::topology
