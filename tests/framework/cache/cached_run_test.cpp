// Small networks that run with a store: what runs again, and what happens when the store is ill.
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "tests/framework/cache/cached_running.hpp"

namespace stope::toy {
namespace {

namespace fs = std::filesystem;

/// Counts like Count, but its numbers are made when they are touched; and says how many there are.
class LazyCount final : public Stage {
 public:
  struct Params {
    std::int64_t count = 10;
  } params;
  Out<Number> numbers;
  OutValue<Number> size;
  static void describe(About<LazyCount>& about) {
    about.output("numbers", &LazyCount::numbers)
        .output("size", &LazyCount::size)
        .param("count", &Params::count, "How many.");
  }
  void run(Context&) override {
    size.set({params.count});
    for (std::int64_t i = 0; i < params.count; ++i)
      numbers.put_lazy(
          10 * (i + 1), [i] { return Number{i}; }, 1 << 20);
  }
};

/// Gives something that every Stope can read.
class Figure final : public Map<Measures(Number)> {
 public:
  struct Params {
  } params;
  static void describe(About<Figure>& about) { about.ports("number", "measures"); }
  Measures apply(const Number& number, Context&) const {
    return {{"number"}, {static_cast<double>(number.value)}, {""}, {""}};
  }
};

/// Knows stages, but must not make one.
class Closed final : public Catalogue {
 public:
  explicit Closed(const Catalogue& known) : known_(known) {}
  const std::vector<StageRecord>& stages() const override { return known_.stages(); }
  const StageRecord* find(std::string_view id) const override { return known_.find(id); }
  std::unique_ptr<StageInstance> create(std::string_view id) const override {
    throw Error("the plugin of " + std::string(id) + " was opened");
  }

 private:
  const Catalogue& known_;
};

/// Takes note that it ran.
class Effect final : public Stage {
 public:
  struct Params {
  } params;
  In<Number> numbers;
  static void describe(About<Effect>& about) { about.input("numbers", &Effect::numbers); }
  void run(Context& context) override {
    while (numbers.next()) {
    }
    context.info("the effect was had");
  }
};

/// Twelve stages: two lazy sources, two branches that join, a tail that forks.
class TwelveStages {
 public:
  /// Stage `changed` has another parameter than the others' default.
  explicit TwelveStages(int changed = -1) {
    source("s0", changed == 0);
    source("s1", changed == 1);
    square("a0", "s0.numbers", changed == 2);
    square("a1", "a0.square", changed == 3);
    square("b0", "s1.numbers", changed == 4);
    square("b1", "b0.square", changed == 5);
    bench.stage<Sum>("offset", {{"numbers", "b1.square"}}, most(changed == 6));
    bench.stage<Add>("join", {{"a", "a1.square"}, {"b", "offset.sum"}});
    square("c0", "join.sum", changed == 8);
    square("c1", "c0.square", changed == 9);
    bench.stage<Sum>("total", {{"numbers", "c1.square"}}, most(changed == 10));
    bench.stage<Sum>("half", {{"numbers", "c0.square"}}, most(changed == 11));
    bench.stage<Add>("end", {{"a", "total.sum"}, {"b", "half.sum"}});
  }

  /// The stage and all that reads it, however far below, by name.
  std::set<std::string> below(std::size_t stage) const {
    std::set<std::string> names{bench.plan.stages[stage].name};
    for (std::size_t i = stage + 1; i < bench.plan.stages.size(); ++i)
      for (const auto& input : bench.plan.stages[i].inputs)
        if (input && names.contains(bench.plan.stages[input->stage].name))
          names.insert(bench.plan.stages[i].name);
    return names;
  }

  PlanBuilder bench;

 private:
  void source(const std::string& name, bool changed) {
    bench.stage<LazyCount>(name, {}, {{"count", std::int64_t{changed ? 7 : 6}}});
  }
  void square(const std::string& name, const std::string& from, bool changed) {
    bench.stage<Square>(name, {{"number", from}}, {{"pause_us", std::int64_t{changed ? 1 : 0}}});
  }
  static PlanBuilder::Parameters most(bool changed) {
    return changed ? PlanBuilder::Parameters{{"most", std::int64_t{5}}} : PlanBuilder::Parameters{};
  }
};

TEST_F(CachedRunTest, AnUnchangedRunExecutesNothingAndGivesTheSame) {
  TwelveStages first, second;
  const Ran cold = run(first.bench, "end.sum");
  EXPECT_EQ(cold.reuse.count(Fate::kRuns), first.bench.plan.stages.size());
  const Ran warm = run(second.bench, "end.sum");
  EXPECT_EQ(warm.reuse.count(Fate::kRuns), 0U);
  EXPECT_EQ(warm.values, cold.values);
  EXPECT_EQ(warm.complaint, "");
}

TEST_F(CachedRunTest, AChangedParameterRunsItsStageAndWhatIsBelowAndNothingElse) {
  TwelveStages cold;
  run(cold.bench, "end.sum");
  for (const int changed : {0, 1, 2, 3, 4, 5, 6, 8, 9, 10, 11}) {
    TwelveStages warm(changed), alone(changed);
    const Ran ran = run(warm.bench, "end.sum");
    EXPECT_EQ(ran_stages(warm.bench, ran.reuse), warm.below(static_cast<std::size_t>(changed)))
        << changed;
    std::vector<Number> expected;
    alone.bench.collect("end.sum", expected).run();
    ASSERT_EQ(expected.size(), 1U);
    EXPECT_EQ(ran.values, (std::vector<std::int64_t>{expected[0].value})) << changed;
  }
}

TEST_F(CachedRunTest, ALazySourceIsReopenedAndItsItemsAreNotCopied) {
  PlanBuilder cold, warm;
  cold.stage<LazyCount>("count").stage<Square>("square", {{"number", "count.numbers"}});
  run(cold, "square.square");
  EXPECT_EQ(objects().size(), 10U);  // squares alone
  warm.stage<LazyCount>("count").stage<Square>("square", {{"number", "count.numbers"}},
                                               {{"pause_us", std::int64_t{1}}});
  const Ran ran = run(warm, "square.square");
  EXPECT_EQ(ran.reuse.fates, (std::vector<Fate>{Fate::kReopened, Fate::kRuns}));
  EXPECT_EQ(ran.values.size(), 10U);
}

TEST_F(CachedRunTest, AFlippedBitIsFoundAndTheStageComputedAnewInTheSameRun) {
  PlanBuilder cold;
  cold.stage<Count>("count").stage<Sum>("sum", {{"numbers", "count.numbers"}});
  EXPECT_EQ(run(cold, "sum.sum").values, (std::vector<std::int64_t>{45}));
  for (const fs::path& file : objects()) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    constexpr int kAfterTheHeader = 17;
    stream.seekg(kAfterTheHeader);
    const char byte = static_cast<char>(stream.get());
    stream.seekp(kAfterTheHeader);
    stream.put(static_cast<char>(byte ^ 1));
  }
  PlanBuilder warm;
  warm.stage<Count>("count").stage<Sum>("sum", {{"numbers", "count.numbers"}});
  const Ran ran = run(warm, "sum.sum");
  EXPECT_EQ(ran.values, (std::vector<std::int64_t>{45}));
  EXPECT_GT(ran.attempts, 1);
  PlanBuilder again;
  again.stage<Count>("count").stage<Sum>("sum", {{"numbers", "count.numbers"}});
  const Ran sound = run(again, "sum.sum");
  EXPECT_EQ(sound.attempts, 1);
  EXPECT_EQ(sound.reuse.count(Fate::kRuns), 0U);
}

TEST_F(CachedRunTest, AStoreThatCannotBeMadeFailsNoRun) {
  const fs::path file = context_.temporary_folder() / "a file";
  std::ofstream(file) << "in the way";
  use_.store = file / "store";
  PlanBuilder bench;
  bench.stage<Count>("count");
  const Ran ran = run(bench, "count.numbers");
  EXPECT_EQ(ran.values.size(), 10U);
  EXPECT_NE(ran.complaint.find("cannot make the store"), std::string::npos) << ran.complaint;
}

TEST_F(CachedRunTest, ADiskThatIsFullFailsNoRunAndIsSaid) {
  PlanBuilder bench;
  bench.stage<Count>("count").stage<Sum>("sum", {{"numbers", "count.numbers"}});
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{0, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &none);
  const Ran ran = run(bench, "sum.sum");
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(ran.values, (std::vector<std::int64_t>{45}));
  EXPECT_NE(ran.complaint.find("cannot write"), std::string::npos) << ran.complaint;
  EXPECT_TRUE(objects().empty());
  EXPECT_TRUE(fs::is_empty(use_.store / "new"));
}

TEST_F(CachedRunTest, AStageWithoutOutputsAlwaysRuns) {
  for (int i = 0; i < 2; ++i) {
    PlanBuilder bench;
    bench.stage<Count>("count").stage<Effect>("effect", {{"numbers", "count.numbers"}});
    const Ran ran = run(bench, "count.numbers");
    EXPECT_EQ(ran.reuse.fates[1], Fate::kRuns);
    EXPECT_TRUE(
        std::any_of(bench.log.lines.begin(), bench.log.lines.end(), [](const std::string& line) {
          return line.starts_with("effect: ") && line.ends_with("the effect was had");
        }));
  }
}

TEST_F(CachedRunTest, WhatIsNotTakenIsStillKept) {
  use_.take = false;
  for (int i = 0; i < 2; ++i) {
    PlanBuilder bench;
    bench.stage<Count>("count");
    EXPECT_EQ(run(bench, "count.numbers").reuse.fates[0], Fate::kRuns);
  }
  use_.take = true;
  PlanBuilder bench;
  bench.stage<Count>("count");
  EXPECT_EQ(run(bench, "count.numbers").reuse.fates[0], Fate::kStored);
}

TEST_F(CachedRunTest, TheStoreIsKeptToItsLimit) {
  use_.limit = 1;
  PlanBuilder bench;
  bench.stage<Count>("count");
  EXPECT_EQ(run(bench, "count.numbers").values.size(), 10U);
  EXPECT_TRUE(objects().empty());
}

TEST_F(CachedRunTest, AMapThatWasStoppedGoesOnWhereItWas) {
  const auto build = [](PlanBuilder& bench) {
    bench.stage<LazyCount>("count").stage<Fragile>("square", {{"number", "count.numbers"}});
  };
  PlanBuilder first, second;
  build(first), build(second);
  Fragile::broken = true;
  CachedRun stopped(first.plan, first.catalogue, 1, use_, first.log);
  EXPECT_EQ(stopped
                .run(
                    {first.source("square.square")},
                    [](const Reuse&) { return std::vector<Sink>{}; }, first.options)
                .end,
            RunRecord::End::kFailed);
  // One that can be told from what the map would compute.
  ItemJournal journal(use_.store);
  ObjectStore store(use_.store);
  const Digest key = stopped.keys()[1].digest;
  const StoredObject marked = store.put([](ByteSink& sink) { encode(Number{-7}, sink); });
  journal.add(key, "square", {30, 2, marked.digest, marked.size});
  const int made = static_cast<int>(journal.items(key, "square").size());
  Fragile::broken = false;
  Fragile::computed = 0;
  EXPECT_EQ(run(second, "square.square").values,
            (std::vector<std::int64_t>{0, 1, -7, 9, 16, 25, 36, 49, 64, 81}));
  EXPECT_EQ(Fragile::computed, 10 - made);
  EXPECT_TRUE(journal.items(key, "square").empty());
}

TEST_F(CachedRunTest, AnUnchangedRunOpensNoPlugin) {
  PlanBuilder bench;
  bench.stage<Count>("count")
      .stage<Sum>("sum", {{"numbers", "count.numbers"}})
      .stage<Figure>("figure", {{"number", "sum.sum"}});
  const PlannedSource wanted = bench.source("figure.measures");
  std::vector<double> figures;
  const auto sinks = [&](const Reuse&) {
    return std::vector<Sink>{
        {"result",
         wanted,
         [&](const AnyItem& item) { figures.push_back(Item<Measures>(item)->values.at(0)); },
         {}}};
  };
  CachedRun(bench.plan, bench.catalogue, 1, use_, bench.log).run({wanted}, sinks, bench.options);
  const Closed closed(bench.catalogue);
  CachedRun again(bench.plan, closed, 1, use_, bench.log);
  const RunRecord record = again.run({wanted}, sinks, bench.options);
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(again.reuse().count(Fate::kRuns), 0U);
  EXPECT_EQ(figures, (std::vector<double>{45, 45}));
}

TEST(ItemJournal, LeavesOutWhatWasTornAtTheEnd) {
  ::stope::testing::MemoryContext context;
  ItemJournal journal(context.temporary_folder());
  const Digest key{1, 2};
  journal.add(key, "grid", {10, 0, {3, 4}, 5});
  journal.add(key, "grid", {20, 1, {6, 7}, 8});
  const fs::path file = context.temporary_folder() / "partial" / (key.text() + ".grid");
  fs::resize_file(file, fs::file_size(file) - 1);
  const auto items = journal.items(key, "grid");
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items.at(0).object, (Digest{3, 4}));
  EXPECT_TRUE(journal.items(key, "other").empty());
}

TEST_F(CachedRunTest, NotesComeBackInLaterRunsOfTheSameKey) {
  const auto noted = [&](std::int64_t count, bool write) {
    PlanBuilder bench;
    bench.stage<Count>("count", {}, {{"count", count}});
    CachedRun run(bench.plan, bench.catalogue, 1, use_, bench.log);
    if (write) run.note(0, "a note", [](ByteSink& sink) { encode(std::string("seen"), sink); });
    std::string text;
    return run.noted(0, "a note", [&](ByteSource& source) { decode(text, source); }) ? text
                                                                                     : "nothing";
  };
  EXPECT_EQ(noted(5, false), "nothing");
  EXPECT_EQ(noted(5, true), "seen");
  EXPECT_EQ(noted(5, false), "seen");
  EXPECT_EQ(noted(6, false), "nothing");
}

TEST_F(CachedRunTest, StopsWhileItReadsFilesIfItIsTold) {
  const fs::path file = context_.temporary_folder() / "data";
  std::ofstream(file) << "content";
  PlanBuilder bench;
  bench.stage<Count>("count");
  bench.plan.stages[0].info.parameters[0].kind = ParameterKind::kPath;
  bench.plan.stages[0].parameters[0] = file.string();
  const std::atomic<bool> stop = true;
  EXPECT_THROW(CachedRun(bench.plan, bench.catalogue, 1, use_, bench.log, &stop), Cancelled);
}

}  // namespace
}  // namespace stope::toy
