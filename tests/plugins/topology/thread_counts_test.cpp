#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <thread>

#include "plugins/topology/dividing_lines.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

/// All that the kernels leave behind.
struct Result {
  std::vector<std::uint8_t> bits;
  std::vector<OutlineEdge> edges;
  std::vector<CellIndex> corners;
  bool operator==(const Result&) const = default;
};

Result kernels(const OccupancyGrid& grid) {
  FreeSpace space = make_free_space(grid, {});
  EdgeGrid edges(space.width(), space.height());
  std::fill_n(edges.data(), edges.size(), -1);
  const Outlines outlines = trace_outlines(space, edges, 3, 8);
  find_nearest_outline(space, outlines, edges);
  Result result;
  result.corners = find_dividing_lines(space, outlines, SideRule::between_sides(outlines), edges);
  result.bits.assign(space.data(), space.data() + space.size());
  result.edges.assign(edges.data(), edges.data() + edges.size());
  return result;
}

TEST(ThreadCounts, LeaveTheSameBytes) {
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const OccupancyGrid& grid :
       {random_grid(300, 700, 0.98, 1, 1), random_grid(500, 900, 0.6, 9, 2),
        random_grid(1, 1000, 0.9, 1, 3), random_grid(1000, 1, 0.9, 1, 4),
        random_grid(321, 641, 1.0, 1, 5), grid_of({"."})}) {
    tbb::task_arena one(1);
    const Result expected = one.execute([&] { return kernels(grid); });
    for (const int threads : {2, 3, 8}) {
      tbb::task_arena arena(threads);
      for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(arena.execute([&] { return kernels(grid); }) == expected) << threads;
    }
  }
}

TEST(Checkpoints, AreCalledByTheCallerAloneAndEndTheWork) {
  struct Stopped {};
  const OccupancyGrid grid = random_grid(300, 3000, 0.98, 1, 1);
  tbb::task_arena arena(4);
  int calls = 0;
  arena.execute([&] {
    const std::thread::id caller = std::this_thread::get_id();
    const auto stop_at = [&](int last) {
      return [&, last, count = 0]() mutable {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        ++calls;
        if (++count == last) throw Stopped();
      };
    };
    EXPECT_THROW(make_free_space(grid, {}, stop_at(2)), Stopped);
    FreeSpace space = make_free_space(grid, {}, stop_at(-1));
    EdgeGrid edges(space.width(), space.height());
    const Outlines outlines = trace_outlines(space, edges, 3, 8);
    EXPECT_THROW(find_nearest_outline(space, outlines, edges, stop_at(3)), Stopped);
    find_nearest_outline(space, outlines, edges, stop_at(-1));
    EXPECT_THROW(
        find_dividing_lines(space, outlines, SideRule::between_sides(outlines), edges, stop_at(2)),
        Stopped);
  });
  EXPECT_GT(calls, 7);
}

}  // namespace
}  // namespace stope::topology
