#include <gtest/gtest.h>

#include "framework/cache/keeper.hpp"
#include "framework/cache/stored_stage.hpp"
#include "stope/testing/memory_context.hpp"
#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {
namespace {

using Fates = std::vector<Fate>;

/// Counts, squares each number and sums them up: a source, a stream and a value.
class ReuseTest : public ::testing::Test {
 protected:
  struct Ran {
    Fates fates;
    std::int64_t sum = -1;
    RunRecord record;
    std::string complaint;
  };

  Ran run(const PlanBuilder::Parameters& of_count, const PlanBuilder::Parameters& of_square,
          Keep keep, std::uint64_t seed = 0) {
    PlanBuilder bench;
    bench.stage<Count>("count", {}, of_count)
        .stage<Square>("square", {{"number", "count.numbers"}}, of_square)
        .stage<Sum>("sum", {{"numbers", "square.square"}});
    const std::vector<PlannedSource> wanted{bench.source("sum.sum")};
    KeyFacts facts;
    facts.seed = seed;
    const std::vector<StageKey> keys = stage_keys(bench.plan, bench.catalogue, facts);
    Ran ran;
    const Reuse reuse = decide(bench.plan, keys, wanted, kept_, store_);
    ran.fates = reuse.fates;
    const Plan plan = with_reuse(bench.plan, reuse);
    const ReusingCatalogue catalogue(bench.plan, reuse, bench.catalogue, store_);
    const FileDigests digests{{}};
    const InputCheck inputs(bench.plan, keys, reuse.fates, digests);
    Keeper keeper(bench.plan, keys, reuse, wanted, keep, inputs, kept_, store_);
    std::vector<Sink> sinks = keeper.sinks();
    sinks.push_back({"result",
                     wanted[0],
                     [&](const AnyItem& item) { ran.sum = Item<Number>(item)->value; },
                     {}});
    ran.record = run_plan(plan, catalogue, sinks, bench.options, bench.log);
    ran.complaint = keeper.complaint();
    EXPECT_EQ(ran.record.end, RunRecord::End::kDone) << ran.record.sentence;
    return ran;
  }

  static PlanBuilder::Parameters count(std::int64_t count) { return {{"count", count}}; }
  static std::int64_t squares_below(std::int64_t count) {
    return (count - 1) * count * (2 * count - 1) / 6;
  }

  ::stope::testing::MemoryContext context_;
  ObjectStore store_{context_.temporary_folder() / "store"};
  KeptStages kept_{context_.temporary_folder() / "store"};
};

TEST_F(ReuseTest, AnUnchangedRunExecutesNothing) {
  EXPECT_EQ(run(count(50), {}, Keep::kValues).fates,
            (Fates{Fate::kRuns, Fate::kRuns, Fate::kRuns}));
  const Ran again = run(count(50), {}, Keep::kValues);
  EXPECT_EQ(again.fates, (Fates{Fate::kNotNeeded, Fate::kNotNeeded, Fate::kStored}));
  EXPECT_EQ(again.sum, squares_below(50));
  EXPECT_EQ(again.record.processes[0].items_written, 0U);
  EXPECT_EQ(again.record.processes[1].items_written, 0U);
}

TEST_F(ReuseTest, OnlyWhatIsBelowAChangeRunsIfAllIsKept) {
  run(count(50), {}, Keep::kAll);
  const Ran changed = run(count(50), {{"pause_us", std::int64_t{1}}}, Keep::kAll);
  EXPECT_EQ(changed.fates, (Fates{Fate::kStored, Fate::kRuns, Fate::kRuns}));
  EXPECT_EQ(changed.sum, squares_below(50));
}

TEST_F(ReuseTest, StreamsAreMadeAgainIfOnlyValuesAreKept) {
  run(count(50), {}, Keep::kValues);
  EXPECT_EQ(usage_of(store_).objects, 1U);
  const Ran changed = run(count(60), {}, Keep::kValues);
  EXPECT_EQ(changed.fates, (Fates{Fate::kRuns, Fate::kRuns, Fate::kRuns}));
  EXPECT_EQ(changed.sum, squares_below(60));
}

TEST_F(ReuseTest, NothingIsKeptIfNothingIsAskedFor) {
  run(count(50), {}, Keep::kNothing);
  EXPECT_EQ(usage_of(store_).objects, 0U);
  EXPECT_EQ(run(count(50), {}, Keep::kNothing).fates[2], Fate::kRuns);
}

TEST_F(ReuseTest, AnotherSeedIsAnotherRun) {
  run(count(50), {}, Keep::kAll, 1);
  EXPECT_EQ(run(count(50), {}, Keep::kAll, 2).fates[0], Fate::kRuns);
  EXPECT_EQ(run(count(50), {}, Keep::kAll, 1).fates[2], Fate::kStored);
}

TEST_F(ReuseTest, WhatWasRemovedIsComputedAnew) {
  run(count(50), {}, Keep::kAll);
  collect_garbage(store_, 0);
  const Ran again = run(count(50), {}, Keep::kAll);
  EXPECT_EQ(again.fates, (Fates{Fate::kRuns, Fate::kRuns, Fate::kRuns}));
  EXPECT_EQ(again.sum, squares_below(50));
}

TEST_F(ReuseTest, AStoreThatCannotBeWrittenToFailsNoRun) {
  std::filesystem::remove_all(store_.root() / "new");
  const Ran ran = run(count(50), {}, Keep::kAll);
  EXPECT_EQ(ran.sum, squares_below(50));
  EXPECT_NE(ran.complaint.find("cannot make a file in"), std::string::npos) << ran.complaint;
  EXPECT_EQ(run(count(50), {}, Keep::kAll).fates[2], Fate::kRuns);
}

TEST_F(ReuseTest, AStageThatDidNotEndIsNotKept) {
  PlanBuilder bench;
  bench.stage<Count>("count", {}, {{"fail_at", std::int64_t{5}}})
      .stage<Sum>("sum", {{"numbers", "count.numbers"}});
  const std::vector<PlannedSource> wanted{bench.source("sum.sum")};
  const std::vector<StageKey> keys = stage_keys(bench.plan, bench.catalogue, {});
  const Reuse reuse = decide(bench.plan, keys, wanted, kept_, store_);
  const FileDigests digests{{}};
  const InputCheck inputs(bench.plan, keys, reuse.fates, digests);
  Keeper keeper(bench.plan, keys, reuse, wanted, Keep::kAll, inputs, kept_, store_);
  EXPECT_EQ(run_plan(bench.plan, bench.catalogue, keeper.sinks(), bench.options, bench.log).end,
            RunRecord::End::kFailed);
  EXPECT_FALSE(kept_.find(keys[0].digest));
  EXPECT_FALSE(kept_.find(keys[1].digest));
}

}  // namespace
}  // namespace stope::toy
