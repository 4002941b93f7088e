// Problem: in which order should the nodes of a dense, flat network be taken out, so that few
// shortcuts appear?
// Idea: nested dissection (George 1973). The nodes are swept in four directions; of all straight
// cuts that leave at least a third on either side the one that the fewest links cross is taken, and
// the smallest set of nodes that touches all of these links parts the rest into two, which are
// treated alike. Within such a set the middle one comes last, so that climbing along it takes few
// steps. The nodes are sorted once for each direction and the sorted lists parted with the cells.
// Cost: O(n log n), and O(n) a level, some twenty levels; halves at once.
#include "plugins/planner/nested_dissection.hpp"

#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <thread>

#include "plugins/planner/least_cover.hpp"

namespace stope::planner {
namespace {

constexpr std::uint32_t kNone = Cell::kNone;
constexpr std::uint32_t kUndivided = 8;      // nodes of a cell, at most
constexpr std::uint32_t kAlone = 1U << 14U;  // nodes from which on halves are parted at once
constexpr std::array<std::array<float, 2>, 4> kSweeps{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

class Dissector {
 public:
  Dissector(const NeighbourLists& neighbours, std::span<const NodePlace> places,
            const std::function<void()>& pause)
      : neighbours_(neighbours),
        places_(places),
        pause_(pause),
        cell_(places.size(), 0),
        place_(places.size()),
        side_(places.size()),
        parted_(places.size()),
        order_(places.size()) {
    std::vector<std::pair<float, std::uint32_t>> keys(places.size());
    for (std::size_t sweep = 0; sweep < kSweeps.size(); ++sweep) {
      for (std::uint32_t node = 0; node < keys.size(); ++node)
        keys[node] = {along(kSweeps[sweep], node), node};
      std::sort(keys.begin(), keys.end());
      for (const auto& [key, node] : keys) swept_[sweep].push_back(node);
    }
  }

  struct Cut {
    std::size_t sweep = 0;
    std::uint32_t before = 0;  // nodes of the cell
    std::int64_t crossing = std::numeric_limits<std::int64_t>::max();
  };

  /// Of the cell whose nodes stand in [begin, end) of the swept lists.
  Cut best_cut(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t count = end - begin, middle = count / 2;
    const auto off = [&](std::uint32_t k) { return k > middle ? k - middle : middle - k; };
    std::vector<std::int32_t> change(count + 1);
    Cut best;
    for (std::size_t sweep = 0; sweep < kSweeps.size(); ++sweep) {
      place(sweep, begin, end);
      std::fill(change.begin(), change.end(), 0);
      for (std::uint32_t i = 0; i < count; ++i) {
        for (const std::uint32_t other : neighbours_.of(swept_[sweep][begin + i])) {
          if (cell_[other] != begin || place_[other] <= i) continue;
          ++change[i + 1];
          --change[place_[other] + 1];
        }
      }
      Cut cut{sweep, middle};
      std::int64_t crossing = 0;
      for (std::uint32_t k = 0; k <= count; ++k) {
        crossing += change[k];
        if (k < (count + 2) / 3 || count - k < (count + 2) / 3) continue;
        if (crossing < cut.crossing || (crossing == cut.crossing && off(k) < off(cut.before)))
          cut.before = k, cut.crossing = crossing;
      }
      if (cut.crossing < best.crossing) best = cut;
    }
    return best;
  }

  Dissection dissect() {
    const auto caller = std::this_thread::get_id();
    Dissection found;
    tbb::this_task_arena::isolate(
        [&] { found.cells = part(0, static_cast<std::uint32_t>(places_.size()), caller); });
    found.order = std::move(order_);
    return found;
  }

 private:
  float along(const std::array<float, 2>& way, std::uint32_t node) const {
    return way[0] * places_[node].x + way[1] * places_[node].y;
  }

  void place(std::size_t sweep, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) place_[swept_[sweep][i]] = i - begin;
  }

  std::vector<Cell> part(std::uint32_t begin, std::uint32_t end, std::thread::id caller) {
    if (end - begin <= kUndivided) {
      std::copy(swept_[0].begin() + begin, swept_[0].begin() + end, order_.begin() + begin);
      return {{begin, begin, end, kNone}};
    }
    const bool large = end - begin > kAlone;
    if (large && std::this_thread::get_id() == caller) pause_();
    const auto [after, own] = divide(begin, end);
    std::vector<Cell> cells, others;
    const auto first = [&, middle = after] {
      if (middle > begin) cells = part(begin, middle, caller);
    };
    const auto second = [&, middle = after, last = own] {
      if (last > middle) others = part(middle, last, caller);
    };
    if (large) {
      tbb::parallel_invoke(first, second);
    } else {
      first();
      second();
    }
    const auto before = static_cast<std::uint32_t>(cells.size());
    for (Cell cell : others) {
      if (cell.parent != kNone) cell.parent += before;
      cells.push_back(cell);
    }
    const auto whole = static_cast<std::uint32_t>(cells.size());
    if (before > 0) cells[before - 1].parent = whole;
    if (whole > before) cells[whole - 1].parent = whole;
    cells.push_back({begin, own, end, kNone});
    return cells;
  }

  /// Parts the swept lists of a cell into first half, second half and the nodes between, which get
  /// their places in the order. Where the second half and the nodes between begin.
  std::pair<std::uint32_t, std::uint32_t> divide(std::uint32_t begin, std::uint32_t end) {
    const Cut cut = best_cut(begin, end);
    std::vector<std::uint32_t> between = nodes_between(cut, begin, end);
    std::array<std::uint32_t, 3> next{begin, 0, 0};
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint8_t side = side_[swept_[0][i]];
      next[1] += side == 0 ? 1 : 0;
      next[2] += side < 2 ? 1 : 0;
    }
    next[1] += begin, next[2] += begin;
    const std::uint32_t after = next[1], own = next[2];
    for (auto& list : swept_) {
      auto to = next;
      for (std::uint32_t i = begin; i < end; ++i) parted_[to[side_[list[i]]]++] = list[i];
      std::copy(parted_.begin() + begin, parted_.begin() + end, list.begin() + begin);
    }
    for (std::uint32_t i = after; i < own; ++i) cell_[swept_[0][i]] = after;
    for (const std::uint32_t node : between) cell_[node] = kNone;
    const std::array<float, 2> across{-kSweeps[cut.sweep][1], kSweeps[cut.sweep][0]};
    std::sort(between.begin(), between.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(along(across, a), a) < std::pair(along(across, b), b);
    });
    std::uint32_t place = own;
    middle_last(between, place);
    return {after, own};
  }

  /// Writes the side of each node of the cell (2: between them) and lists those between.
  std::vector<std::uint32_t> nodes_between(const Cut& cut, std::uint32_t begin, std::uint32_t end) {
    const auto& swept = swept_[cut.sweep];
    const std::uint32_t middle = begin + cut.before;
    place(cut.sweep, begin, end);
    TwoSides links;
    std::vector<std::uint32_t> left, right;
    std::vector<std::uint32_t> number(end - middle, kNone);  // of right nodes, by place
    for (std::uint32_t i = begin; i < end; ++i) side_[swept[i]] = i < middle ? 0 : 1;
    for (std::uint32_t i = begin; i < middle; ++i) {
      const std::size_t known = links.right.size();
      for (const std::uint32_t other : neighbours_.of(swept[i])) {
        if (cell_[other] != begin || place_[other] < cut.before) continue;
        std::uint32_t& named = number[place_[other] - cut.before];
        if (named == kNone) {
          named = links.right_count++;
          right.push_back(other);
        }
        links.right.push_back(named);
      }
      if (links.right.size() == known) continue;
      left.push_back(swept[i]);
      links.first.push_back(static_cast<std::uint32_t>(links.right.size()));
    }
    const Cover cover = least_cover(links);
    std::vector<std::uint32_t> between;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (cover.left[i]) between.push_back(left[i]);
    for (std::size_t i = 0; i < right.size(); ++i)
      if (cover.right[i]) between.push_back(right[i]);
    for (const std::uint32_t node : between) side_[node] = 2;
    return between;
  }

  void middle_last(std::span<const std::uint32_t> nodes, std::uint32_t& place) {
    if (nodes.empty()) return;
    const std::size_t middle = nodes.size() / 2;
    middle_last(nodes.first(middle), place);
    middle_last(nodes.subspan(middle + 1), place);
    order_[place++] = nodes[middle];
  }

  const NeighbourLists& neighbours_;
  std::span<const NodePlace> places_;
  const std::function<void()>& pause_;
  std::array<std::vector<std::uint32_t>, kSweeps.size()> swept_;
  // Cells at work at the same time share no nodes, so each writes to places of its own.
  std::vector<std::uint32_t> cell_;   // of each node: where its cell begins; none: has its place
  std::vector<std::uint32_t> place_;  // of each node in the sweep at hand
  std::vector<std::uint8_t> side_;
  std::vector<std::uint32_t> parted_, order_;
};

}  // namespace

Dissection dissect(const NeighbourLists& neighbours, std::span<const NodePlace> places,
                   const std::function<void()>& pause) {
  return Dissector(neighbours, places, pause).dissect();
}

std::uint64_t least_crossing(const NeighbourLists& neighbours, std::span<const NodePlace> places) {
  const auto count = static_cast<std::uint32_t>(places.size());
  if (count < 3) return 0;
  const std::function<void()> pause;
  return static_cast<std::uint64_t>(
      Dissector(neighbours, places, pause).best_cut(0, count).crossing);
}

}  // namespace stope::planner
