#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "framework/cache/cached_run.hpp"
#include "stope/testing/memory_context.hpp"
#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/toy_stages.hpp"

namespace stope::toy {

/// Squares, but from 6 on it fails while it is broken, which no key tells.
class Fragile final : public Map<Number(Number)> {
 public:
  struct Params {
  } params;
  static inline std::atomic<bool> broken{false};
  static inline std::atomic<int> computed{0};
  static void describe(About<Fragile>& about) { about.ports("number", "square"); }
  Number apply(const Number& number, Context&) const {
    if (broken && number.value >= 6) throw Error("it broke");
    ++computed;
    return {number.value * number.value};
  }
};

/// Runs small networks with a store of its own.
class CachedRunTest : public ::testing::Test {
 protected:
  CachedRunTest() {
    use_.store = context_.temporary_folder() / "store";
    use_.keep = Keep::kAll;
  }

  struct Ran {
    RunRecord record;
    Reuse reuse;
    std::string complaint;
    std::vector<std::int64_t> values;
    int attempts = 0;
  };

  /// Runs the builder's plan for what stands at `wanted`.
  Ran run(PlanBuilder& bench, const std::string& wanted) {
    Ran ran;
    CachedRun run(bench.plan, bench.catalogue, 1, use_, bench.log);
    ran.record = run.run(
        {bench.source(wanted)},
        [&](const Reuse&) {
          ++ran.attempts;
          ran.values.clear();
          return std::vector<Sink>{
              {"result",
               bench.source(wanted),
               [&](const AnyItem& item) { ran.values.push_back(Item<Number>(item)->value); },
               {}}};
        },
        bench.options);
    ran.reuse = run.reuse();
    ran.complaint = run.complaint();
    EXPECT_EQ(ran.record.end, RunRecord::End::kDone) << ran.record.sentence;
    return ran;
  }

  static std::set<std::string> ran_stages(const PlanBuilder& bench, const Reuse& reuse) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < reuse.fates.size(); ++i)
      if (reuse.fates[i] == Fate::kRuns) names.insert(bench.plan.stages[i].name);
    return names;
  }

  std::vector<std::filesystem::path> objects() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(use_.store / "objects"))
      if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
  }

  ::stope::testing::MemoryContext context_;
  CacheUse use_;
};

}  // namespace stope::toy
