// What dense networks are prepared with, piece by piece, against brute force.
#include "plugins/planner/cell_contraction.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>

#include "plugins/planner/hierarchy_search.hpp"
#include "plugins/planner/least_cover.hpp"
#include "plugins/planner/min_plus.hpp"
#include "plugins/planner/rest_network.hpp"
#include "stope/random.hpp"
#include "tests/benchmarks/routing/test_networks.hpp"

namespace stope::planner {
namespace {

TEST(LeastCover, TouchesAllLinksWithNoMoreNodesThanAnySetNeeds) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const auto left = static_cast<std::uint32_t>(random.below(6));
    TwoSides sides;
    sides.right_count = static_cast<std::uint32_t>(random.below(6));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
    for (std::uint32_t a = 0; a < left; ++a) {
      for (std::uint32_t b = 0; b < sides.right_count; ++b) {
        if (random.below(3) != 0) continue;
        links.emplace_back(a, b);
        sides.right.push_back(b);
      }
      sides.first.push_back(static_cast<std::uint32_t>(sides.right.size()));
    }
    int least = 99;
    for (std::uint32_t set = 0; set < 1U << (left + sides.right_count); ++set) {
      const bool covers = std::all_of(links.begin(), links.end(), [&](const auto& link) {
        return (set >> link.first & 1U) != 0 || (set >> (left + link.second) & 1U) != 0;
      });
      if (covers) least = std::min(least, std::popcount(set));
    }
    const Cover cover = least_cover(sides);
    EXPECT_EQ(std::count(cover.left.begin(), cover.left.end(), true) +
                  std::count(cover.right.begin(), cover.right.end(), true),
              least);
    for (const auto& [a, b] : links) EXPECT_TRUE(cover.left[a] || cover.right[b]);
  }
}

TEST(MinPlus, TakesTheLeastOfEightSums) {
  Random random(2);
  for (std::uint32_t count = 0; count < 40; ++count) {
    std::vector<std::vector<std::uint32_t>> rows(kRowsAtOnce, std::vector<std::uint32_t>(count));
    std::array<std::uint32_t, kRowsAtOnce> costs;
    std::array<const std::uint32_t*, kRowsAtOnce> starts;
    std::vector<std::uint32_t> to(count);
    for (auto& cost : to) cost = static_cast<std::uint32_t>(random.below(1U << 31U));
    for (std::uint32_t k = 0; k < kRowsAtOnce; ++k) {
      costs[k] = static_cast<std::uint32_t>(random.below(1U << 31U));
      for (auto& cost : rows[k]) cost = static_cast<std::uint32_t>(random.below(1U << 31U));
      starts[k] = rows[k].data();
    }
    std::vector<std::uint32_t> expected = to;
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t k = 0; k < kRowsAtOnce; ++k)
        expected[i] = std::min(expected[i], costs[k] + rows[k][i]);
    take_least_sums(to.data(), costs, starts, count);
    EXPECT_EQ(to, expected);
  }
}

NeighbourLists neighbours_in(const SearchGraph& graph) {
  NeighbourLists lists;
  lists.first.push_back(0);
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    for (std::uint32_t arc = graph.first_arc(node); arc < graph.end_arc(node); ++arc)
      lists.nodes.push_back(graph.arc(arc).to);
    for (const SearchGraph::Into& into : graph.into(node)) lists.nodes.push_back(into.from);
    lists.first.push_back(static_cast<std::uint32_t>(lists.nodes.size()));
  }
  return lists;
}

TEST(Dissection, NoLinkLeadsFromOneHalfOfACellToTheOther) {
  for (const TestNetwork& network : {lattice(30, 1, 1), road_like(12, 2)}) {
    const SearchGraph graph = network.graph();
    const NeighbourLists neighbours = neighbours_in(graph);
    const Dissection found = dissect(neighbours, network.places(), [] {});
    std::vector<std::uint32_t> place(graph.node_count(), kNoArc), cell_at(graph.node_count());
    for (std::uint32_t i = 0; i < graph.node_count(); ++i) {
      ASSERT_EQ(place[found.order[i]], kNoArc);  // each node once
      place[found.order[i]] = i;
    }
    for (std::uint32_t c = 0; c < found.cells.size(); ++c) {
      const Cell& cell = found.cells[c];
      for (std::uint32_t i = cell.own; i < cell.end; ++i) cell_at[i] = c;
      if (cell.parent == Cell::kNone) continue;
      EXPECT_GT(cell.parent, c);
      EXPECT_LE(found.cells[cell.parent].first, cell.first);
      EXPECT_GE(found.cells[cell.parent].own, cell.end);
    }
    EXPECT_EQ(found.cells.back().end, graph.node_count());
    // So the more important end lies in the other's cell or in one above it.
    for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
      for (const std::uint32_t other : neighbours.of(node)) {
        if (place[other] < place[node]) continue;
        std::uint32_t cell = cell_at[place[node]];
        while (cell != Cell::kNone && cell != cell_at[place[other]])
          cell = found.cells[cell].parent;
        EXPECT_NE(cell, Cell::kNone);
      }
    }
  }
}

TEST(CellContraction, GridsAreToldFromRoads) {
  const TestNetwork grid = lattice(40, 1, 1), roads = road_like(40, 1);
  EXPECT_TRUE(ContractionHierarchy(grid.graph(), grid.places()).has_chains());
  EXPECT_FALSE(ContractionHierarchy(roads.graph(), roads.places()).has_chains());
}

TEST(CellContraction, GivesTheSameOnAnyNumberOfThreads) {
  const TestNetwork network = lattice(150, 2, 1);
  const SearchGraph graph = network.graph();
  const auto made_on = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return ContractionHierarchy(graph, network.places());
  };
  const ContractionHierarchy one = made_on(1), four = made_on(4);
  for (std::uint32_t node = 0; node < graph.node_count(); ++node)
    ASSERT_EQ(one.rank(node), four.rank(node));
  for (const auto half : {&ContractionHierarchy::up, &ContractionHierarchy::down}) {
    const auto &a = (one.*half)(), &b = (four.*half)();
    EXPECT_EQ(a.first, b.first);
    ASSERT_EQ(a.arcs.size(), b.arcs.size());
    for (std::size_t i = 0; i < a.arcs.size(); ++i) {
      ASSERT_EQ(a.arcs[i].to, b.arcs[i].to);
      ASSERT_EQ(a.arcs[i].cost, b.arcs[i].cost);
      ASSERT_EQ(a.parts[i].up, b.parts[i].up);
      ASSERT_EQ(a.parts[i].down, b.parts[i].down);
    }
  }
}

TEST(CellContraction, RefusesWaysThatCostTooMuch) {
  TestNetwork network = lattice(20, 1, 1);
  for (ArcBetween& arc : network.arcs) arc.cost = 1U << 28U;
  EXPECT_ANY_THROW(ContractionHierarchy(network.graph(), network.places()));
}

TEST(CellContraction, GivesUpWhenAsked) {
  const TestNetwork network = lattice(150, 1, 1);
  int asked = 0;
  const auto stop = [&] {
    if (++asked == 2) throw std::runtime_error("stopped");
  };
  EXPECT_ANY_THROW(ContractionHierarchy(network.graph(), network.places(), stop));
}

}  // namespace
}  // namespace stope::planner
