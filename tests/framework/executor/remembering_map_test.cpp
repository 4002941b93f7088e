#include <gtest/gtest.h>

#include <tuple>

#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {
namespace {

/// Gives a number's half and its remainder, at two outputs.
class Halve final : public Map<Outputs<Number, Number>(Number)> {
 public:
  struct Params {
  } params;
  static void describe(About<Halve>& about) {
    about.summary("Halves.").ports("number", "half", "rest");
  }
  std::tuple<Number, Number> apply(const Number& number, Context&) const {
    return {{number.value / 2}, {number.value % 2}};
  }
};

/// Adds the number of the item before; fails if it was given another item than the next.
class AddPrevious final : public Map<Number(Number)> {
 public:
  struct Params {
  } params;
  static void describe(About<AddPrevious>& about) {
    about.summary("Adds the number before.").in_order().ports("number", "sum");
  }
  Number apply(const Number& number, Context& context) const {
    if (context.index() != next_) throw Error("given out of order");
    ++next_;
    const std::int64_t sum = previous_ + number.value;
    previous_ = number.value;
    return {sum};
  }

 private:
  mutable std::uint64_t next_ = 0;
  mutable std::int64_t previous_ = 0;
};

class MapOnThreads : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, MapOnThreads, ::testing::Values(1, 2, 8));

TEST_P(MapOnThreads, AMapOfSeveralOutputsWritesEachInItsOrder) {
  PlanBuilder bench;
  bench.options.threads = GetParam();
  std::vector<Number> halves, rests;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{200}}})
      .stage<Halve>("halve", {{"number", "count.numbers"}})
      .collect("halve.half", halves)
      .collect("halve.rest", rests);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  ASSERT_EQ(halves.size(), 200U);
  ASSERT_EQ(rests.size(), 200U);
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_EQ(2 * halves[i].value + rests[i].value, static_cast<std::int64_t>(i));
}

TEST_P(MapOnThreads, AnOutputNobodyReadsDoesNotHoldUpTheOther) {
  PlanBuilder bench;
  bench.options.threads = GetParam();
  std::vector<Number> rests;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{200}}})
      .stage<Halve>("halve", {{"number", "count.numbers"}})
      .collect("halve.rest", rests);
  EXPECT_EQ(bench.run().end, RunRecord::End::kDone);
  EXPECT_EQ(rests.size(), 200U);
}

TEST_P(MapOnThreads, AReaderOfOneOutputThatLeavesEarlyDoesNotEndTheOther) {
  PlanBuilder bench;
  bench.options.threads = GetParam();
  std::vector<Number> sum, rests;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{200}}})
      .stage<Halve>("halve", {{"number", "count.numbers"}})
      .stage<Sum>("sum", {{"numbers", "halve.half"}}, {{"most", std::int64_t{4}}})
      .collect("sum.sum", sum)
      .collect("halve.rest", rests);
  EXPECT_EQ(bench.run().end, RunRecord::End::kDone);
  ASSERT_EQ(sum.size(), 1U);
  EXPECT_EQ(sum[0].value, 0 + 0 + 1 + 1);
  EXPECT_EQ(rests.size(), 200U);
}

TEST_P(MapOnThreads, AMapThatRemembersIsGivenItsItemsInOrder) {
  PlanBuilder bench;
  bench.options.threads = GetParam();
  std::vector<Number> sums;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{500}}})
      .stage<AddPrevious>("add", {{"number", "count.numbers"}})
      .collect("add.sum", sums);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  ASSERT_EQ(sums.size(), 500U);
  for (std::size_t i = 1; i < 500; ++i)
    EXPECT_EQ(sums[i].value, static_cast<std::int64_t>(2 * i - 1));
}

}  // namespace
}  // namespace stope::toy
