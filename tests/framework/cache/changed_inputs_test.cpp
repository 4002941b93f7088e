// Runs whose input files somebody else changes meanwhile: nothing of it may be believed later.
#include <chrono>
#include <fstream>
#include <mutex>
#include <thread>

#include "tests/framework/cache/cached_running.hpp"

namespace stope::toy {
namespace {

namespace fs = std::filesystem;

/// Gives the numbers in a file, which it reads when they are touched. Before it reads that at
/// `swap_at`, somebody writes something else into the file; afterwards he puts back what was there.
class FileNumbers final : public Stage {
 public:
  struct Params {
    std::filesystem::path file;
    std::int64_t swap_at = -1;
    bool lazy = false;
  } params;
  Out<Number> numbers;
  static inline bool swaps = false;
  static void describe(About<FileNumbers>& about) {
    about.output("numbers", &FileNumbers::numbers)
        .param("file", &Params::file, "What to read.")
        .param("swap_at", &Params::swap_at, "When it is swapped.")
        .param("lazy", &Params::lazy, "Whether it reads late.");
  }
  void run(Context&) override {
    const auto load = [params = params](std::size_t i) {
      // Only the item at `swap_at` is read from what does not belong there.
      static std::mutex mutex;
      const std::lock_guard lock(mutex);
      const bool swap = swaps && static_cast<std::int64_t>(i) == params.swap_at;
      const std::vector<std::int64_t> right = read(params.file);
      if (swap) write(params.file, std::vector<std::int64_t>(right.size(), -1));
      const Number number{read(params.file).at(i)};
      if (swap) write(params.file, right);
      return number;
    };
    const std::size_t count = read(params.file).size();
    for (std::size_t i = 0; i < count; ++i) {
      const Stamp stamp = 10 * (static_cast<Stamp>(i) + 1);
      if (params.lazy)
        numbers.put_lazy(
            stamp, [load, i] { return load(i); }, 1 << 20);
      else
        numbers.put(stamp, load(i));
    }
  }
  static std::vector<std::int64_t> read(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::vector<std::int64_t> numbers;
    for (std::int64_t number = 0; stream >> number;) numbers.push_back(number);
    return numbers;
  }
  static void write(const std::filesystem::path& file, const std::vector<std::int64_t>& numbers) {
    std::ofstream stream(file);
    for (const std::int64_t number : numbers) stream << number << '\n';
  }
};

/// A file of numbers, their squares, and the sum of these.
class SwappedInputTest : public CachedRunTest {
 protected:
  SwappedInputTest() { FileNumbers::write(file_, {1, 2, 3, 4}); }
  ~SwappedInputTest() override { FileNumbers::swaps = false; }

  void build(PlanBuilder& bench, bool lazy) const {
    bench
        .stage<FileNumbers>(
            "read", {}, {{"file", file_.string()}, {"swap_at", std::int64_t{2}}, {"lazy", lazy}})
        .stage<Square>("square", {{"number", "read.numbers"}})
        .stage<Sum>("sum", {{"numbers", "square.square"}})
        .stage<Count>("count")
        .stage<Sum>("other", {{"numbers", "count.numbers"}})
        .stage<Add>("end", {{"a", "sum.sum"}, {"b", "other.sum"}});
  }
  static bool warned(const PlanBuilder& bench) {
    return std::any_of(bench.log.lines.begin(), bench.log.lines.end(), [](const std::string& line) {
      return line.find("numbers.txt was changed, replaced or touched") != std::string::npos;
    });
  }

  fs::path file_ = context_.temporary_folder() / "numbers.txt";
};

TEST_F(SwappedInputTest, NothingThatDependsOnItIsKeptAndTheRestIs) {
  for (const bool lazy : {false, true}) {
    PlanBuilder first, second, third;
    build(first, lazy), build(second, lazy), build(third, lazy);
    // Times of files go on in steps.
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    FileNumbers::swaps = true;
    EXPECT_EQ(run(first, "end.sum").values, (std::vector<std::int64_t>{1 + 4 + 1 + 16 + 45}));
    EXPECT_TRUE(warned(first));
    FileNumbers::swaps = false;
    const Ran again = run(second, "end.sum");
    EXPECT_EQ(again.values, (std::vector<std::int64_t>{1 + 4 + 9 + 16 + 45}));
    // A lazy source may end before its file is swapped: then it is only opened again, and what it
    // reads now is looked at by those below.
    std::set<std::string> ran = ran_stages(second, again.reuse);
    if (lazy) ran.insert("read");
    EXPECT_EQ(ran, (std::set<std::string>{"read", "square", "sum", "end"}));
    EXPECT_FALSE(warned(second));
    const Ran kept = run(third, "end.sum");
    EXPECT_EQ(kept.values, again.values);
    EXPECT_EQ(kept.reuse.count(Fate::kRuns), 0U);
  }
}

TEST_F(SwappedInputTest, NoItemOfAMapThatWasStoppedIsBelieved) {
  const auto build = [&](PlanBuilder& bench) {
    bench
        .stage<FileNumbers>(
            "read", {}, {{"file", file_.string()}, {"swap_at", std::int64_t{2}}, {"lazy", true}})
        .stage<Fragile>("square", {{"number", "read.numbers"}});
  };
  FileNumbers::write(file_, {1, 2, 3, 4, 9});
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  PlanBuilder first, second;
  build(first), build(second);
  FileNumbers::swaps = true;
  Fragile::broken = true;
  CachedRun stopped(first.plan, first.catalogue, 1, use_, first.log);
  EXPECT_EQ(stopped
                .run(
                    {first.source("square.square")},
                    [](const Reuse&) { return std::vector<Sink>{}; }, first.options)
                .end,
            RunRecord::End::kFailed);
  FileNumbers::swaps = false;
  Fragile::broken = false;
  EXPECT_EQ(run(second, "square.square").values, (std::vector<std::int64_t>{1, 4, 9, 16, 81}));
}

TEST_F(SwappedInputTest, NotesOfItAreNotKept) {
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  PlanBuilder bench;
  build(bench, false);
  FileNumbers::swaps = true;
  CachedRun swapped(bench.plan, bench.catalogue, 1, use_, bench.log);
  swapped.run(
      {bench.source("end.sum")}, [](const Reuse&) { return std::vector<Sink>{}; }, bench.options);
  for (std::size_t stage = 0; stage < bench.plan.stages.size(); ++stage) {
    swapped.note(stage, "a note", [](ByteSink& sink) { encode(std::string("seen"), sink); });
    const bool depends = stage != 3 && stage != 4;  // on the file
    EXPECT_EQ(swapped.inputs_hold(stage), !depends) << stage;
    EXPECT_EQ(swapped.noted(stage, "a note", [](ByteSource&) {}), !depends) << stage;
  }
}

TEST_F(SwappedInputTest, WithoutAStoreItIsWarnedOfAsWell) {
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  use_.store.clear();
  PlanBuilder bench;
  build(bench, false);
  FileNumbers::swaps = true;
  run(bench, "end.sum");
  EXPECT_TRUE(warned(bench));
}

}  // namespace
}  // namespace stope::toy
