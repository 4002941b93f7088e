#include "framework/executor/run.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {
namespace {

std::vector<std::int64_t> values(const std::vector<Number>& numbers) {
  std::vector<std::int64_t> list;
  for (const Number& number : numbers) list.push_back(number.value);
  return list;
}

TEST(Run, AChainOfStagesGivesItsSum) {
  PlanBuilder bench;
  std::vector<Number> sum;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{1000}}})
      .stage<Pass>("pass", {{"numbers", "count.numbers"}})
      .stage<Sum>("sum", {{"numbers", "pass.same"}})
      .collect("sum.sum", sum);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(values(sum), std::vector<std::int64_t>{999 * 1000 / 2});
  ASSERT_EQ(record.channels.size(), 3U);
  EXPECT_EQ(record.channels[0].from, "count.numbers");
  EXPECT_EQ(record.channels[0].to, "pass.numbers");
  EXPECT_EQ(record.channels[0].items, 1000U);
  EXPECT_EQ(record.channels[0].capacity, 16U);
  EXPECT_EQ(record.processes[1].items_read, 1000U);
  EXPECT_EQ(record.processes[1].items_written, 1000U);
}

class RunOnThreads : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Threads, RunOnThreads, ::testing::Values(1, 2, 8));

TEST_P(RunOnThreads, AMapKeepsTheOrderOfItsItems) {
  PlanBuilder bench;
  bench.options.threads = GetParam();
  std::vector<std::int64_t> squares, expected;
  std::vector<Stamp> stamps, expected_stamps;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{300}}})
      .stage<Square>("square", {{"number", "count.numbers"}}, {{"pause_us", std::int64_t{100}}})
      .sink("square.square", [&](const AnyItem& item) {
        EXPECT_EQ(item.index, squares.size());
        squares.push_back(Item<Number>(item)->value);
        stamps.push_back(item.stamp);
      });
  for (std::int64_t i = 0; i < 300; ++i) {
    expected.push_back(i * i);
    expected_stamps.push_back(10 * (i + 1));
  }
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(squares, expected);
  EXPECT_EQ(stamps, expected_stamps);
  EXPECT_GT(record.processes[1].work, 0);
}

TEST_P(RunOnThreads, TheSeedOfAnItemDependsOnRunStageAndIndexAlone) {
  const auto seeds = [&](std::uint64_t seed, int threads) {
    PlanBuilder bench;
    bench.options.threads = threads;
    bench.options.seed = seed;
    std::vector<Number> out;
    bench.stage<Count>("count", {}, {{"count", std::int64_t{50}}})
        .stage<Square>("square", {{"number", "count.numbers"}}, {{"seeded", true}})
        .collect("square.square", out);
    EXPECT_EQ(bench.run().end, RunRecord::End::kDone);
    return values(out);
  };
  const auto here = seeds(7, GetParam());
  EXPECT_EQ(here, seeds(7, 1));
  EXPECT_NE(here, seeds(8, 1));
  EXPECT_EQ(std::set<std::int64_t>(here.begin(), here.end()).size(), 50U);
}

TEST_P(RunOnThreads, OfAMapsErrorsTheLowestItemsIsTheRuns) {
  PlanBuilder bench;
  bench.options.threads = GetParam();
  std::vector<Number> squares;
  // Number 21 is quicker to fail than number 20.
  bench.stage<Count>("count", {}, {{"count", std::int64_t{300}}})
      .stage<Square>("square", {{"number", "count.numbers"}},
                     {{"pause_us", std::int64_t{2000}}, {"fail_at", std::int64_t{20}}})
      .collect("square.square", squares);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kFailed);
  EXPECT_EQ(record.failed_stage, "square");
  EXPECT_EQ(record.sentence, "stage \"square\" failed at item 20 (0.00000021 s): cannot square 20");
}

TEST(Run, OneOutputFeedsManyReaders) {
  PlanBuilder bench;
  std::vector<Number> sum, squares, plain;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{500}}})
      .stage<Sum>("sum", {{"numbers", "count.numbers"}})
      .stage<Square>("square", {{"number", "count.numbers"}})
      .collect("sum.sum", sum)
      .collect("square.square", squares)
      .collect("count.numbers", plain);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(sum.at(0).value, 499 * 500 / 2);
  EXPECT_EQ(squares.size(), 500U);
  EXPECT_EQ(plain.size(), 500U);
  EXPECT_EQ(growths(record), 0U);
}

TEST(Run, AnOutputThatNobodyReadsIsNotWanted) {
  PlanBuilder bench;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{500}}})
      .stage<Sum>("sum", {{"numbers", "count.numbers"}});
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(record.processes[1].items_written, 0U);
}

TEST(Run, AMapOfValuesGivesAValueAndAMapWithAStreamAStream) {
  PlanBuilder bench;
  std::vector<Number> value, stream;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{4}}})
      .stage<Sum>("sum", {{"numbers", "count.numbers"}})
      .stage<Add>("twice", {{"a", "sum.sum"}, {"b", "sum.sum"}})
      .stage<Add>("more", {{"a", "count.numbers"}, {"b", "twice.sum"}})
      .stage<Add>("alone", {{"a", "more.sum"}})
      .sink("twice.sum",
            [&](const AnyItem& item) {
              EXPECT_EQ(item.index, 0U);
              EXPECT_EQ(item.stamp, 0);
              value.push_back(*Item<Number>(item));
            })
      .collect("alone.sum", stream);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(values(value), std::vector<std::int64_t>{12});
  EXPECT_EQ(values(stream), (std::vector<std::int64_t>{12, 13, 14, 15}));
}

TEST(Run, AValueFeedsAStreamPortAsAStreamOfOne) {
  PlanBuilder bench;
  std::vector<Number> passed;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{4}}})
      .stage<Sum>("sum", {{"numbers", "count.numbers"}})
      .stage<Pass>("pass", {{"numbers", "sum.sum"}})
      .collect("pass.same", passed);
  EXPECT_EQ(bench.run().end, RunRecord::End::kDone);
  EXPECT_EQ(values(passed), std::vector<std::int64_t>{6});
}

TEST(Run, AReaderMayEndBeforeItsInput) {
  PlanBuilder bench;
  std::vector<Number> sum, plain;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{1000}}})
      .stage<Sum>("sum", {{"numbers", "count.numbers"}}, {{"most", std::int64_t{3}}})
      .collect("sum.sum", sum)
      .collect("count.numbers", plain);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(sum.at(0).value, 3);
  EXPECT_EQ(plain.size(), 1000U);
}

TEST(Run, AnUnendingSourceEndsWhenAllItsReadersHaveLeft) {
  PlanBuilder bench;
  std::vector<Number> sum;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{-1}}})
      .stage<Square>("square", {{"number", "count.numbers"}})
      .stage<Sum>("sum", {{"numbers", "square.square"}}, {{"most", std::int64_t{4}}})
      .collect("sum.sum", sum);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(sum.at(0).value, 0 + 1 + 4 + 9);
}

}  // namespace
}  // namespace stope::toy
