// Warnings belong to a result: whoever takes it from the store hears them again.
#include "tests/framework/cache/cached_running.hpp"

namespace stope::toy {
namespace {

/// Doubts each number it passes on.
class Doubt final : public Map<Number(Number)> {
 public:
  struct Params {
  } params;
  static void describe(About<Doubt>& about) { about.ports("number", "doubted"); }
  Number apply(const Number& number, Context& context) const {
    context.warn("is " + std::to_string(number.value) + " right?");
    return number;
  }
};

class WarningMemoryTest : public CachedRunTest {
 protected:
  /// How often each warning of the stage was said.
  std::map<std::string, int> warnings_of_run(std::int64_t count) {
    PlanBuilder bench;
    bench.stage<Count>("count", {}, {{"count", count}})
        .stage<Doubt>("doubt", {{"number", "count.numbers"}})
        .stage<Sum>("sum", {{"numbers", "doubt.doubted"}});
    last_ = run(bench, "sum.sum");
    std::map<std::string, int> said;
    for (const std::string& line : bench.log.lines)
      if (line.starts_with("doubt: ")) ++said[line];
    return said;
  }

  Ran last_;
};

TEST_F(WarningMemoryTest, TheyAreSaidAgainOfResultsFromTheStore) {
  const auto first = warnings_of_run(3);
  EXPECT_EQ(first.size(), 3U);
  EXPECT_EQ(warnings_of_run(3), first);
  EXPECT_EQ(last_.reuse.count(Fate::kRuns), 0U);
}

TEST_F(WarningMemoryTest, TheyAreSaidAlsoOfStagesWhoseStreamsAreNotKept) {
  use_.keep = Keep::kValues;
  const auto first = warnings_of_run(3);
  EXPECT_EQ(first.size(), 3U);
  EXPECT_EQ(warnings_of_run(3), first);
  EXPECT_EQ(last_.reuse.count(Fate::kRuns), 0U);
  EXPECT_EQ(last_.reuse.fates[1], Fate::kNotNeeded);
}

TEST_F(WarningMemoryTest, OfThousandsTheFirstAreRememberedAndTheOthersCounted) {
  EXPECT_EQ(warnings_of_run(250).size(), 250U);
  const auto again = warnings_of_run(250);
  EXPECT_EQ(again.size(), 101U);
  EXPECT_TRUE(again.contains("doubt: it warned 150 more times when it was computed"));
}

TEST_F(WarningMemoryTest, NothingIsRepeatedWhereNothingIsTaken) {
  warnings_of_run(3);
  use_.take = false;
  EXPECT_EQ(warnings_of_run(3).size(), 3U);
  EXPECT_EQ(last_.reuse.count(Fate::kRuns), 3U);
}

}  // namespace
}  // namespace stope::toy
