#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {
namespace {

/// Breaks one rule of ports, chosen by its parameter.
class RuleBreaker final : public Stage {
 public:
  struct Params {
    std::string rule;
  } params;
  Out<Number> stream;
  OutValue<Number> value;
  static void describe(About<RuleBreaker>& about) {
    about.summary("Breaks a rule.")
        .output("stream", &RuleBreaker::stream)
        .output("value", &RuleBreaker::value)
        .param("rule", &Params::rule, "Which.");
  }
  void run(Context&) override {
    stream.put(2'000'000'000, {1}, 5);
    if (params.rule == "time") stream.put(1'000'000'000, {2});
    if (params.rule == "index") stream.put(2'000'000'000, {2}, 5);
    if (params.rule == "cancelled") throw Cancelled();
    if (params.rule == "other") throw 42;
    if (params.rule == "twice") value.set({1});
    if (params.rule != "unset") value.set({2});
  }
};

std::string sentence_for(const std::string& rule) {
  PlanBuilder bench;
  std::vector<Number> stream, value;
  bench.stage<RuleBreaker>("breaker", {}, {{"rule", rule}})
      .collect("breaker.stream", stream)
      .collect("breaker.value", value);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end == RunRecord::End::kFailed, !record.sentence.empty());
  EXPECT_EQ(record.processes.size(), 3U) << "the record of a failed run is complete";
  return record.sentence;
}

TEST(Failure, EveryBrokenRuleOfAPortHasItsSentence) {
  EXPECT_EQ(sentence_for("none"), "");
  EXPECT_EQ(sentence_for("time"),
            "stage \"breaker\" failed after item 5 (2.000 s): output \"stream\" goes back in time, "
            "from item 5 (2.000 s) to "
            "item 6 (1.000 s): stamps of a stream must never decrease");
  EXPECT_EQ(sentence_for("index"),
            "stage \"breaker\" failed after item 5 (2.000 s): output \"stream\" goes from index 5 "
            "to 5: indices of a stream "
            "must increase");
  EXPECT_EQ(sentence_for("twice"),
            "stage \"breaker\" failed after item 5 (2.000 s): output \"value\" is a value and was "
            "set twice: set it once");
  EXPECT_EQ(
      sentence_for("unset"),
      "stage \"breaker\" failed: it ended without setting its output \"value\", which is read");
  EXPECT_EQ(sentence_for("cancelled"),
            "stage \"breaker\" failed after item 5 (2.000 s): it gave up as if the run had been "
            "cancelled, which it was "
            "not");
  EXPECT_EQ(sentence_for("other"),
            "stage \"breaker\" failed after item 5 (2.000 s): something that is not a "
            "std::exception was thrown");
}

TEST(Failure, AValueThatNobodyReadsNeedNotBeSet) {
  PlanBuilder bench;
  std::vector<Number> stream;
  bench.stage<RuleBreaker>("breaker", {}, {{"rule", std::string("unset")}})
      .collect("breaker.stream", stream);
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
}

TEST(Failure, NamesTheItemThatTheStageWasAt) {
  PlanBuilder bench;
  bench.stage<Count>("count").sink("count.numbers", [](const AnyItem& item) {
    if (item.index == 3) throw Error("the picture cannot be drawn");
  });
  const RunRecord record = bench.run();
  EXPECT_EQ(
      record.sentence,
      "stage \"sink of count.numbers\" failed at item 3 (0.00000004 s): the picture cannot be "
      "drawn");
}

TEST(Failure, StreamsOfAMapMustRunInStep) {
  const auto sentence = [](std::int64_t left, std::int64_t right, bool shifted) {
    PlanBuilder bench;
    std::vector<Number> sums;
    bench.stage<Count>("left", {}, {{"count", left}}).stage<Count>("right", {}, {{"count", right}});
    std::string second = "right.numbers";
    if (shifted) {
      bench.stage<RuleBreaker>("shifted", {}, {{"rule", std::string("unset")}});
      second = "shifted.stream";
    }
    bench.stage<Add>("add", {{"a", "left.numbers"}, {"b", second}}).collect("add.sum", sums);
    return bench.run().sentence;
  };
  EXPECT_EQ(sentence(5, 5, false), "");
  EXPECT_EQ(
      sentence(5, 4, false),
      "stage \"add\" failed at item 4 (0.00000005 s): its inputs do not run in step: \"b\" has "
      "ended while \"a\" is at 0.00000005 s; streams that a map reads must end together");
  EXPECT_EQ(sentence(1, 1, true),
            "stage \"add\" failed at item 5 (2.000 s): its inputs do not run in step: \"a\" is at "
            "0.00000001 s, \"b\" at 2.000 s; streams that a map reads must carry equal stamps");
}

/// Two chains from one source, of which one fails in its third number.
RunRecord run_two_chains(bool go_on, std::int64_t pause, std::vector<Number>& good,
                         std::vector<Number>& bad, bool& bad_finished) {
  PlanBuilder bench;
  bench.options.go_on_after_failure = go_on;
  bench.options.channel_capacity = 1;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{50}}})
      .stage<Square>("broken", {{"number", "count.numbers"}},
                     {{"fail_at", std::int64_t{3}}, {"pause_us", pause}})
      .stage<Pass>("behind", {{"numbers", "broken.square"}})
      .stage<Sum>("last", {{"numbers", "behind.same"}})
      .stage<Pass>("other", {{"numbers", "count.numbers"}})
      .stage<Sum>("sum", {{"numbers", "other.same"}})
      .collect("sum.sum", good)
      .collect("last.sum", bad);
  bench.sinks[1].finish = [&] { bad_finished = true; };
  return bench.run();
}

TEST(Failure, LeavesWhatDoesNotDependOnItRunningIfAsked) {
  for (int time = 0; time < 10; ++time) {
    std::vector<Number> good, bad;
    bool bad_finished = false;
    const RunRecord record = run_two_chains(true, time * 50, good, bad, bad_finished);
    EXPECT_EQ(record.end, RunRecord::End::kFailed);
    EXPECT_FALSE(record.stopped);
    ASSERT_EQ(record.failures.size(), 1U) << "those behind it have not failed";
    EXPECT_EQ(record.failures[0].stage, "broken");
    EXPECT_EQ(record.failed_stage, "broken");
    EXPECT_EQ(record.sentence, "stage \"broken\" failed at item 3 (0.00000004 s): cannot square 3");
    ASSERT_EQ(good.size(), 1U);
    EXPECT_EQ(good[0].value, 49 * 50 / 2);
    EXPECT_TRUE(bad.empty()) << "a sum of what came before the failure would be wrong";
    EXPECT_FALSE(bad_finished);
  }
}

TEST(Failure, StopsAllIfNotAskedOtherwise) {
  std::vector<Number> good, bad;
  bool bad_finished = false;
  const RunRecord record = run_two_chains(false, 0, good, bad, bad_finished);
  EXPECT_EQ(record.end, RunRecord::End::kFailed);
  EXPECT_TRUE(record.stopped);
  EXPECT_EQ(record.failures.size(), 1U);
  EXPECT_TRUE(bad.empty());
  EXPECT_FALSE(bad_finished);
}

TEST(Failure, AllAreToldOfARunThatGoesOn) {
  PlanBuilder bench;
  bench.options.go_on_after_failure = true;
  std::vector<Number> sum;
  bench.stage<Count>("count")
      .stage<Square>("one", {{"number", "count.numbers"}}, {{"fail_at", std::int64_t{3}}})
      .stage<Square>("two", {{"number", "count.numbers"}}, {{"fail_at", std::int64_t{5}}})
      .stage<Add>("both", {{"a", "one.square"}, {"b", "two.square"}})
      .stage<Sum>("sum", {{"numbers", "both.sum"}})
      .collect("sum.sum", sum)
      .sink("count.numbers", [](const AnyItem&) { throw Error("the disk is gone"); });
  const RunRecord record = bench.run();
  std::vector<std::string> stages;
  for (const StageFailure& failure : record.failures) stages.push_back(failure.stage);
  std::sort(stages.begin(), stages.end());
  EXPECT_EQ(stages, (std::vector<std::string>{"one", "sink of count.numbers", "two"}));
  EXPECT_TRUE(sum.empty());
}

TEST(Failure, AStageThatCannotBeMadeIsNamed) {
  struct Broken final : Catalogue {
    const std::vector<StageRecord>& stages() const override { return none; }
    const StageRecord* find(std::string_view) const override { return nullptr; }
    std::unique_ptr<StageInstance> create(std::string_view) const override {
      throw Error("libtoy.so was built for another epoch");
    }
    std::vector<StageRecord> none;
  };
  PlanBuilder bench;
  bench.stage<Count>("count");
  const RunRecord record = run_plan(bench.plan, Broken(), {}, {}, bench.log);
  EXPECT_EQ(record.end, RunRecord::End::kFailed);
  EXPECT_EQ(record.failed_stage, "count");
  EXPECT_EQ(record.sentence,
            "stage \"count\" cannot be made: libtoy.so was built for another epoch");
}

/// Does what a long computation does: asks now and then whether to give up.
class Patient final : public Stage {
 public:
  struct Params {
  } params;
  Out<Number> numbers;
  static void describe(About<Patient>& about) {
    about.summary("Waits.").output("numbers", &Patient::numbers);
  }
  void run(Context& context) override {
    const auto folder = context.temporary_folder();
    if (folder != context.temporary_folder() || !std::filesystem::is_empty(folder))
      throw Error("not a folder of my own");
    context.info("writes to " + folder.string());
    numbers.put(5'000'000'000, {1});
    for (;;) {
      context.stop_if_cancelled();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

TEST(Cancellation, ReachesStagesThatWaitAndStagesThatAsk) {
  PlanBuilder bench;
  std::atomic<bool> stop{false};
  bench.options.stop = &stop;
  std::vector<Number> sum, numbers;
  bench.stage<Patient>("patient")
      .stage<Sum>("sum", {{"numbers", "patient.numbers"}})
      .collect("sum.sum", sum)
      .sink("patient.numbers", [&](const AnyItem&) { stop = true; });
  bench.sinks[0].finish = [] { FAIL() << "the run was stopped"; };
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kCancelled);
  EXPECT_EQ(record.sentence, "");
  EXPECT_TRUE(sum.empty());
  ASSERT_EQ(bench.log.lines.size(), 1U);
  const std::string folder = bench.log.lines[0].substr(bench.log.lines[0].find('/'));
  EXPECT_FALSE(std::filesystem::exists(folder)) << folder;
}

TEST(Record, SpansCoverTheLifeOfEachProcess) {
  PlanBuilder bench;
  std::vector<Number> sum;
  bench.options.channel_capacity = 1;
  bench.stage<Count>("count", {}, {{"count", std::int64_t{60'000}}})
      .stage<Square>("square", {{"number", "count.numbers"}})
      .stage<Sum>("sum", {{"numbers", "square.square"}})
      .collect("sum.sum", sum);
  int looks = 0;
  RunProgress last;
  const RunRecord record = run_plan(bench.plan, bench.catalogue, bench.sinks, bench.options,
                                    bench.log, [&](const RunProgress& progress) {
                                      ++looks;
                                      last = progress;
                                    });
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  std::size_t spans = 0;
  for (const ProcessRecord& process : record.processes) {
    const std::int64_t life = process.end - process.begin;
    EXPECT_GE(process.run + process.wait_in + process.wait_out + process.io, life * 98 / 100);
    EXPECT_LE(process.run + process.wait_in + process.wait_out + process.io, life);
    std::int64_t busy = 0;
    for (const Span& span : process.spans) {
      busy += span.busy;
      EXPECT_LE(process.begin, span.begin);
      EXPECT_LE(span.busy, span.end - span.begin);
      EXPECT_LE(span.end, process.end);
    }
    EXPECT_EQ(busy, process.run + process.wait_in + process.wait_out + process.io);
    spans += process.spans.size();
  }
  EXPECT_LE(spans, 100'000U);
  EXPECT_GT(record.peak_resident, 1U << 20U);
  EXPECT_GE(looks, 2);
  ASSERT_EQ(last.processes.size(), 4U);
  EXPECT_EQ(last.processes[0].fraction, 1.0);
  EXPECT_EQ(last.processes[1].items_written, 60'000U);
  EXPECT_TRUE(last.processes[3].finished);
}

}  // namespace
}  // namespace stope::toy
