// Problem: dense, grid-like networks have so many ways that searches for witnesses never end.
// Idea: customizable contraction hierarchies (Dibbelt, Strasser and Wagner 2014): which nodes get
// joined follows from the order alone. A cell's own nodes and those at its border are all joined to
// each other, so their costs are taken as one dense matrix, from the halves upwards, as
// multifrontal elimination does for linear equations (Duff and Reid 1983): what remains between the
// border's nodes is handed to the cell above. Then from the whole downwards: each cell is told the
// true costs between its border's nodes, and a link of its own goes that another node above makes
// needless (as dear is needless too, since costs are positive: see the proof in dense_costs.cpp).
// What is left is a small hierarchy without a single search. Cost: O(n log n) links, O(n^1.5)
// triangles at 0.05 ns each, some 2 * 10^10 upwards and twice as many downwards for a grid of a
// million nodes; 8 bytes a link while it runs. Halves are taken at once.
#include "plugins/planner/cell_contraction.hpp"

#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <thread>

#include "plugins/planner/dense_costs.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

constexpr std::uint32_t kMost = 0x3FFFFFFF;  // two such costs stay below kNever
constexpr std::uint32_t kAlone = 1U << 14U;  // nodes from which on halves are taken at once

class CellContraction {
 public:
  CellContraction(const Dissection& dissection, const CellBorders& borders,
                  std::span<const CellLink> links, const std::function<void()>& pause)
      : cells_(dissection.cells),
        borders_(borders),
        links_(links),
        pause_(pause),
        caller_(std::this_thread::get_id()),
        by_lower_(static_cast<std::uint32_t>(dissection.order.size()), links),
        halves_(cells_.size(), {Cell::kNone, Cell::kNone}),
        first_row_(1, 0) {
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      first_row_.push_back(first_row_.back() + 2ULL * own(cell) * width(cell));
      if (cells_[cell].parent == Cell::kNone) continue;
      auto& [first, second] = halves_[cells_[cell].parent];
      (first == Cell::kNone ? first : second) = cell;
    }
    rows_.resize(first_row_.back());
  }

  KeptHalves contract() {
    if (cells_.empty()) return {};
    const auto whole = static_cast<std::uint32_t>(cells_.size() - 1);
    tbb::this_task_arena::isolate([&] {
      take_ways_through(whole);
      drop_needless(whole, whole, {});
    });
    return kept();
  }

 private:
  std::uint32_t own(std::uint32_t cell) const { return cells_[cell].end - cells_[cell].own; }
  std::uint32_t width(std::uint32_t cell) const {
    return own(cell) + static_cast<std::uint32_t>(borders_.of(cell).size());
  }
  /// Costs from one of a cell's own nodes to all its nodes after it, and the other way.
  std::uint32_t* row(std::uint32_t cell, std::uint32_t node, bool is_up) {
    const std::uint64_t number = (is_up ? 0 : own(cell)) + node;
    return rows_.data() + first_row_[cell] + number * width(cell);
  }
  std::uint32_t number_in(std::uint32_t cell, std::uint32_t place) const {
    if (place < cells_[cell].end) return place - cells_[cell].own;
    const auto border = borders_.of(cell);
    const auto at = std::lower_bound(border.begin(), border.end(), place);
    return own(cell) + static_cast<std::uint32_t>(at - border.begin());
  }
  std::vector<std::uint32_t> border_in(std::uint32_t cell, std::uint32_t parent) const {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t place : borders_.of(cell)) numbers.push_back(number_in(parent, place));
    return numbers;
  }
  bool is_large(std::uint32_t cell) const { return cells_[cell].end - cells_[cell].first > kAlone; }
  template <class Work>
  void for_halves(std::uint32_t cell, const Work& work) {
    const auto one = [&](std::size_t which) {
      if (halves_[cell][which] != Cell::kNone) work(halves_[cell][which], which);
    };
    if (is_large(cell)) {
      if (std::this_thread::get_id() == caller_) pause_();
      tbb::parallel_invoke([&] { one(0); }, [&] { one(1); });
    } else {
      one(0);
      one(1);
    }
  }

  /// Writes the rows of all nodes in a cell; the costs between its border's nodes through it.
  CostMatrix take_ways_through(std::uint32_t cell) {
    std::array<CostMatrix, 2> through;
    for_halves(cell, [&](std::uint32_t half, std::size_t which) {
      through[which] = take_ways_through(half);
    });
    const std::uint32_t size = width(cell), own_count = own(cell), next = size - own_count;
    CostMatrix costs(static_cast<std::size_t>(size) * size, kNever);
    const auto lower = [&](std::uint32_t from, std::uint32_t to, std::uint32_t cost) {
      std::uint32_t& known = costs[static_cast<std::size_t>(from) * size + to];
      known = std::min(known, cost);
    };
    for (std::uint32_t i = by_lower_.first[cells_[cell].own]; i < by_lower_.first[cells_[cell].end];
         ++i) {
      const CellLink& link = links_[by_lower_.links[i]];
      if (link.cost > kMost) refuse();
      lower(number_in(cell, link.from), number_in(cell, link.to), link.cost);
    }
    for (std::size_t which = 0; which < 2; ++which) {
      if (through[which].empty()) continue;
      const auto numbers = border_in(halves_[cell][which], cell);
      for (std::size_t a = 0; a < numbers.size(); ++a)
        for (std::size_t b = 0; b < numbers.size(); ++b)
          lower(numbers[a], numbers[b], through[which][a * numbers.size() + b]);
      CostMatrix().swap(through[which]);
    }
    lead_over_own(costs.data(), own_count, size);
    for (std::uint32_t node = 0; node < own_count; ++node) {
      std::uint32_t *up = row(cell, node, true), *down = row(cell, node, false);
      for (std::uint32_t other = node + 1; other < size; ++other) {
        up[other] = costs[static_cast<std::size_t>(node) * size + other];
        down[other] = costs[static_cast<std::size_t>(other) * size + node];
        for (const std::uint32_t cost : {up[other], down[other]})
          if (cost > kMost && cost < kNever) refuse();
      }
    }
    CostMatrix rest(static_cast<std::size_t>(next) * next);
    for (std::uint32_t i = 0; i < next; ++i)
      std::copy_n(costs.data() + static_cast<std::size_t>(own_count + i) * size + own_count, next,
                  rest.data() + static_cast<std::size_t>(i) * next);
    return rest;
  }

  /// Tells a cell the true costs between its border's nodes, which its parent knows.
  void drop_needless(std::uint32_t cell, std::uint32_t parent, const TrueCosts& above) {
    const std::uint32_t size = width(cell), own_count = own(cell);
    TrueCosts truth;
    for (CostMatrix* matrix : {&truth.from, &truth.to})
      matrix->assign(static_cast<std::size_t>(size) * size, kNever);
    if (own_count < size) {
      const auto numbers = border_in(cell, parent);
      const std::size_t stride = width(parent);
      for (std::size_t a = 0; a < numbers.size(); ++a) {
        for (std::size_t b = 0; b < numbers.size(); ++b) {
          const std::size_t there = numbers[a] * stride + numbers[b];
          const std::size_t here = (own_count + a) * size + own_count + b;
          truth.from[here] = above.from[there];
          truth.to[here] = above.to[there];
        }
      }
    }
    keep_needed(row(cell, 0, true), row(cell, 0, false), own_count, size, truth);
    for_halves(cell, [&](std::uint32_t half, std::size_t) { drop_needless(half, cell, truth); });
  }

  KeptHalves kept() {
    KeptHalves kept;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      const auto border = borders_.of(cell);
      const std::uint32_t own_count = own(cell), size = width(cell);
      for (std::uint32_t node = 0; node < own_count; ++node) {
        for (const bool is_up : {true, false}) {
          KeptArcs& half = is_up ? kept.up : kept.down;
          const std::uint32_t* costs = row(cell, node, is_up);
          for (std::uint32_t to = node + 1; to < size; ++to) {
            if (costs[to] < kNever)
              half.arcs.push_back(
                  {to < own_count ? cells_[cell].own + to : border[to - own_count], costs[to]});
          }
          if (half.arcs.size() >= kNever)
            throw Error("the road graph is too dense to prepare for fast search");
          half.first.push_back(static_cast<std::uint32_t>(half.arcs.size()));
        }
      }
    }
    return kept;
  }

  [[noreturn]] static void refuse() {
    throw Error("the road graph has ways too long to prepare for fast search");
  }

  const std::vector<Cell>& cells_;
  const CellBorders& borders_;
  std::span<const CellLink> links_;
  const std::function<void()>& pause_;
  std::thread::id caller_;
  LinksByLower by_lower_;
  std::vector<std::array<std::uint32_t, 2>> halves_;
  std::vector<std::uint64_t> first_row_;
  std::vector<std::uint32_t> rows_;
};

}  // namespace

KeptHalves contract_cells(const Dissection& dissection, const CellBorders& borders,
                          std::span<const CellLink> links, const std::function<void()>& pause) {
  return CellContraction(dissection, borders, links, pause).contract();
}

}  // namespace stope::planner
