#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {
namespace {

/// The case to keep in mind: a stream feeds an estimate that needs all of it and, from the start
/// again, a stage that first waits for the estimate.
PlanBuilder two_passes(std::int64_t count, std::vector<Number>& sums) {
  PlanBuilder bench;
  bench.stage<Count>("scans", {}, {{"count", count}})
      .stage<Sum>("odometry", {{"numbers", "scans.numbers"}})
      .stage<AddLater>("map", {{"offset", "odometry.sum"}, {"numbers", "scans.numbers"}})
      .collect("map.sums", sums);
  return bench;
}

TEST(Deadlock, TheSecondReaderOfARecordingMayWaitForTheFirst) {
  std::vector<Number> sums;
  PlanBuilder bench = two_passes(1000, sums);
  bench.options.channel_capacity = 4;
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  ASSERT_EQ(sums.size(), 1000U);
  for (std::int64_t i = 0; i < 1000; ++i) EXPECT_EQ(sums[i].value, 999 * 1000 / 2 + i);
  // Only the channel from the scans to the map grows, and no further than it must.
  for (const ChannelRecord& channel : record.channels) {
    const bool grows = channel.from == "scans.numbers" && channel.to == "map.numbers";
    EXPECT_EQ(channel.capacity, grows ? 1024U : 4U) << channel.from << " -> " << channel.to;
    EXPECT_EQ(channel.growths, grows ? 8U : 0U) << channel.from << " -> " << channel.to;
  }
}

TEST(Deadlock, ChainsAndTreesNeverGrow) {
  for (const std::size_t capacity : {1, 2, 3, 4, 16}) {
    PlanBuilder bench;
    bench.options.channel_capacity = capacity;
    bench.options.threads = 2;
    std::vector<Number> out, other;
    bench.stage<Count>("count", {}, {{"count", std::int64_t{2000}}})
        .stage<Pass>("pass", {{"numbers", "count.numbers"}})
        .stage<Square>("square", {{"number", "pass.same"}})
        .stage<Pass>("again", {{"numbers", "square.square"}})
        .stage<Square>("branch", {{"number", "pass.same"}})
        .collect("again.same", out)
        .collect("branch.square", other);
    const RunRecord record = bench.run();
    EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
    EXPECT_EQ(out.size(), 2000U);
    EXPECT_EQ(other.size(), 2000U);
    EXPECT_EQ(growths(record), 0U) << "at capacity " << capacity;
  }
}

TEST(Deadlock, IsResolvedBesideASourceThatNeverEnds) {
  std::vector<Number> sums;
  PlanBuilder bench = two_passes(500, sums);
  std::atomic<bool> stop{false};
  bench.options.stop = &stop;
  std::atomic<std::uint64_t> others{0};
  bench.stage<Count>("sensor", {}, {{"count", std::int64_t{-1}}})
      .stage<Square>("square", {{"number", "sensor.numbers"}})
      .sink("square.square", [&](const AnyItem&) { ++others; });
  bench.sinks[0].finish = [&] {
    while (others == 0) std::this_thread::yield();
    stop = true;
  };
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kCancelled);
  EXPECT_EQ(sums.size(), 500U);
  EXPECT_GT(others, 0U);
  EXPECT_GT(growths(record), 0U);
}

TEST(Deadlock, IsResolvedBetweenTwoReadersOfOppositeOrder) {
  // `map` reads its offset's stream to the end before it reads the other, `odometry` the other way
  // round: every number must be held for someone.
  PlanBuilder bench;
  bench.options.channel_capacity = 1;
  std::vector<Number> a, b;
  bench.stage<Count>("left", {}, {{"count", std::int64_t{200}}})
      .stage<Count>("right", {}, {{"count", std::int64_t{300}}})
      .stage<Sum>("left_sum", {{"numbers", "left.numbers"}})
      .stage<Sum>("right_sum", {{"numbers", "right.numbers"}})
      .stage<AddLater>("left_later", {{"offset", "right_sum.sum"}, {"numbers", "left.numbers"}})
      .stage<AddLater>("right_later", {{"offset", "left_sum.sum"}, {"numbers", "right.numbers"}})
      .collect("left_later.sums", a)
      .collect("right_later.sums", b);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(a.size(), 200U);
  EXPECT_EQ(b.size(), 300U);
  EXPECT_EQ(a[0].value, 299 * 300 / 2);
}

}  // namespace
}  // namespace stope::toy
