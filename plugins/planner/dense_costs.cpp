// Problem: which links of a cell cost what, and which of them are needed?
// Idea: all nodes of a cell are joined, so the costs are one matrix, and eight of its rows at a
// time are offered as ways over their nodes (take_least_sums()). Downwards the same with true costs
// tells which links are needed: a link v-b goes if some third node a above v has cost(v, a) +
// cost(a, b)
// <= cost(v, b). The ways left suffice: let x be the most important node on any cheapest way from s
// to t. If the first link s-y of a climb to x is gone, some a made it needless; a lies on a
// cheapest way to x, is above s, and nearer to it than y; so among such a the nearest has its link
// kept, and the climb goes on from there to x, which is nearer now. Cost: as in the header, 0.05 ns
// each.
#include "plugins/planner/dense_costs.hpp"

#include <algorithm>
#include <array>

#include "plugins/planner/min_plus.hpp"

namespace stope::planner {
namespace {

void lead_over(std::uint32_t* row, std::uint32_t over, const std::uint32_t* onward,
               std::uint32_t end) {
  const std::uint32_t here = row[over];
  for (std::uint32_t to = over + 1; to < end; ++to) row[to] = std::min(row[to], here + onward[to]);
}

/// take_least_sums() of up to eight rows, `stride` apart.
void take_rows(std::uint32_t* to, const std::uint32_t* costs, const std::uint32_t* rows,
               std::uint32_t stride, std::uint32_t row_count, std::uint32_t count) {
  std::array<std::uint32_t, kRowsAtOnce> chosen;
  std::array<const std::uint32_t*, kRowsAtOnce> from;
  chosen.fill(kNever);
  from.fill(rows);
  bool any = false;
  for (std::uint32_t i = 0; i < row_count; ++i) {
    chosen[i] = costs[i];
    from[i] = rows + static_cast<std::size_t>(i) * stride;
    any = any || costs[i] < kNever;
  }
  if (any) take_least_sums(to, chosen, from, count);
}

/// Of the links from a node (or, the other way round, to it): `round` has the costs of ways to
/// nodes from `end` on over such nodes; those over and to nodes between come to it.
void keep_needed_of(std::uint32_t node, std::uint32_t end, std::uint32_t size, std::uint32_t* costs,
                    std::uint32_t* round, CostMatrix& across, CostMatrix& back) {
  for (std::uint32_t over = node + 1; over < end; ++over) {
    const std::uint32_t* onward = across.data() + static_cast<std::size_t>(over) * size;
    for (std::uint32_t to = end; to < size; ++to)
      round[to] = std::min(round[to], costs[over] + onward[to]);
  }
  for (std::uint32_t to = node + 1; to < end; ++to) {
    const std::uint32_t* into = back.data() + static_cast<std::size_t>(to) * size;
    std::uint32_t least = kNever;
    for (std::uint32_t over = node + 1; over < size; ++over)
      least = std::min(least, costs[over] + into[over]);
    round[to] = least;
  }
  for (std::uint32_t to = node + 1; to < size; ++to) {
    const std::uint32_t true_cost = std::min(costs[to], round[to]);
    across[static_cast<std::size_t>(node) * size + to] = true_cost;
    back[static_cast<std::size_t>(to) * size + node] = true_cost;
    if (costs[to] >= round[to]) costs[to] = kNever;
  }
}

}  // namespace

void lead_over_own(std::uint32_t* costs, std::uint32_t own_count, std::uint32_t size) {
  const auto row_of = [&](std::uint32_t node) {
    return costs + static_cast<std::size_t>(node) * size;
  };
  for (std::uint32_t begin = 0; begin < own_count; begin += kRowsAtOnce) {
    const std::uint32_t end = std::min(begin + kRowsAtOnce, own_count);
    for (std::uint32_t over = begin; over < end; ++over) {
      for (std::uint32_t from = over + 1; from < end; ++from)
        lead_over(row_of(from), over, row_of(over), size);
    }
    for (std::uint32_t from = end; from < size; ++from) {
      for (std::uint32_t over = begin; over < end; ++over)
        lead_over(row_of(from), over, row_of(over), end);
      take_rows(row_of(from) + end, row_of(from) + begin, row_of(begin) + end, size, end - begin,
                size - end);
    }
  }
}

/// From the last own node to the first, eight at once.
void keep_needed(std::uint32_t* up, std::uint32_t* down, std::uint32_t own_count,
                 std::uint32_t size, TrueCosts& truth) {
  const auto row = [&](std::uint32_t node, bool is_up) {
    return (is_up ? up : down) + static_cast<std::size_t>(node) * size;
  };
  CostMatrix round(2ULL * kRowsAtOnce * size);
  for (std::uint32_t end = own_count; end > 0;) {
    const std::uint32_t begin = (end - 1) / kRowsAtOnce * kRowsAtOnce;
    std::fill(round.begin(), round.end(), kNever);
    const auto round_of = [&](std::uint32_t node, bool is_up) {
      return round.data() + (2ULL * (node - begin) + (is_up ? 1 : 0)) * size;
    };
    for (const bool is_up : {true, false}) {
      const CostMatrix& across = is_up ? truth.from : truth.to;
      for (std::uint32_t over = end; over < size; over += kRowsAtOnce) {
        for (std::uint32_t node = begin; node < end; ++node)
          take_rows(round_of(node, is_up) + end, row(node, is_up) + over,
                    across.data() + static_cast<std::size_t>(over) * size + end, size,
                    std::min(kRowsAtOnce, size - over), size - end);
      }
    }
    for (std::uint32_t node = end; node-- > begin;) {
      keep_needed_of(node, end, size, row(node, true), round_of(node, true), truth.from, truth.to);
      keep_needed_of(node, end, size, row(node, false), round_of(node, false), truth.to,
                     truth.from);
    }
    end = begin;
  }
}

}  // namespace stope::planner
