#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "framework/executor/resident_size.hpp"
#include "framework/executor/spill_files.hpp"
#include "tests/framework/executor/bench_of_stages.hpp"
#include "tests/framework/executor/blob_stages.hpp"

namespace stope::toy {
namespace {

namespace fs = std::filesystem;

/// A recording of `count` blobs read twice, the second time from the start again once the first
/// has ended.
PlanBuilder two_passes(bool lazy, std::int64_t count, std::vector<Number>& again) {
  PlanBuilder bench;
  bench.options.threads = 2;
  bench.stage<Blobs>("blobs", {}, {{"count", count}, {"lazy", lazy}})
      .stage<BlobTotal>("total", {{"blobs", "blobs.blobs"}})
      .stage<BlobAgain>("again", {{"blob", "blobs.blobs"}, {"total", "total.total"}})
      .collect("again.again", again);
  return bench;
}

class Memory : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(LazyAndDerived, Memory, ::testing::Bool());

TEST_P(Memory, PayloadsComeBackAsTheyWereWhenThereIsNoRoomForAny) {
  const bool lazy = GetParam();
  constexpr std::int64_t kCount = 300;
  std::vector<Number> again;
  PlanBuilder bench = two_passes(lazy, kCount, again);
  // Less than the process has anyway: everything that can go goes at once.
  bench.options.memory = 1 << 20;
  const RunRecord record = bench.run();
  ASSERT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  ASSERT_EQ(again.size(), static_cast<std::size_t>(kCount));
  for (std::int64_t i = 0; i < kCount; ++i)
    EXPECT_EQ(again[i].value, checksum(make_blob(static_cast<std::uint64_t>(i), 5000)));
  EXPECT_GT(record.payloads_evicted, 100U);
  if (lazy) {
    EXPECT_EQ(record.payloads_spilled, 0U);
    EXPECT_GT(record.payloads_loaded, 300U);
  } else {
    EXPECT_GT(record.payloads_spilled, 100U);
    EXPECT_LE(record.payloads_spilled, 300U) << "a payload is written once, however often it goes";
    EXPECT_GT(record.bytes_spilled, record.payloads_spilled * 40'000);
    EXPECT_GT(record.payloads_loaded, 100U);
  }
  // Reading and writing payloads is input and output of whoever needed the room.
  std::int64_t io = 0;
  for (const ProcessRecord& process : record.processes) io += process.io;
  EXPECT_GT(io, 0);
}

TEST_P(Memory, WithRoomForAllNothingIsEvicted) {
  std::vector<Number> again;
  PlanBuilder bench = two_passes(GetParam(), 100, again);
  bench.options.memory = std::size_t{8} << 30;
  const RunRecord record = bench.run();
  ASSERT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(record.payloads_evicted, 0U);
  EXPECT_EQ(record.payloads_spilled, 0U);
  EXPECT_EQ(record.payloads_loaded, GetParam() ? 100U : 0U) << "each once, for both readers";
}

TEST(Memory, AnItemPinsItsPayloadUntilItDies) {
  PlanBuilder bench;
  bench.options.memory = 1 << 20;
  std::vector<Item<Blob>> items;
  std::vector<const Blob*> places;
  bench.stage<Blobs>("blobs", {}, {{"count", std::int64_t{50}}})
      .sink("blobs.blobs", [&](const AnyItem& any) {
        items.emplace_back(any);
        places.push_back(&*items.back());
        for (std::size_t i = 0; i < items.size(); ++i) ASSERT_EQ(&*items[i], places[i]);
      });
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_EQ(record.payloads_evicted, 0U);
  // Payloads may outlive the run.
  for (std::uint64_t i = 0; i < items.size(); ++i)
    EXPECT_EQ(checksum(*items[i]), checksum(make_blob(i, 5000)));
}

TEST(Memory, SpilledPayloadsThatOutliveTheRunCanStillBeRead) {
  PlanBuilder bench;
  bench.options.memory = 1 << 20;
  std::vector<AnyItem> items;
  bench.stage<Blobs>("blobs", {}, {{"count", std::int64_t{100}}, {"lazy", false}})
      .sink("blobs.blobs", [&](const AnyItem& any) { items.push_back(any); });
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kDone) << record.sentence;
  EXPECT_GT(record.payloads_spilled, 50U);
  for (std::uint64_t i = 0; i < items.size(); ++i)
    EXPECT_EQ(checksum(*Item<Blob>(items[i])), checksum(make_blob(i, 5000)));
}

TEST(Memory, APayloadThatCannotBeLoadedStopsTheRunWithItsItem) {
  std::vector<Number> again;
  PlanBuilder bench = two_passes(true, 30, again);
  for (std::size_t i = 0; i < bench.plan.stages[0].parameters.size(); ++i) {
    if (bench.plan.stages[0].info.parameters[i].name == "fail_at")
      bench.plan.stages[0].parameters[i] = std::int64_t{7};
  }
  const RunRecord record = bench.run();
  EXPECT_EQ(record.end, RunRecord::End::kFailed);
  EXPECT_EQ(record.sentence,
            "stage \"total\" failed at item 7 (7.000 s): the file is shorter than its header says");
}

TEST(Memory, AFullDiskStopsTheRunWithASentence) {
  // The limit on the size of a file stands in for the end of a disk; it holds for a whole process.
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 20, 1 << 20};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::vector<Number> again;
    PlanBuilder bench = two_passes(false, 300, again);
    bench.options.memory = 1 << 20;
    const RunRecord record = bench.run();
    const bool told = record.end == RunRecord::End::kFailed &&
                      record.sentence.find("cannot be moved to disk") != std::string::npos &&
                      record.sentence.find("File too large") != std::string::npos;
    _exit(told ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Memory, NothingIsLeftInTheScratchFolder) {
  const fs::path scratch =
      fs::path(::testing::TempDir()) / ("stope-scratch-" + std::to_string(getpid()));
  std::vector<Number> again;
  PlanBuilder bench = two_passes(false, 200, again);
  bench.options.memory = 1 << 20;
  bench.options.scratch = scratch / "below";
  EXPECT_EQ(bench.run().end, RunRecord::End::kDone);
  EXPECT_FALSE(fs::exists(scratch)) << "it was not there before";

  fs::create_directories(scratch);
  std::ofstream(scratch / "mine.txt") << "keep";
  bench.options.scratch = scratch;
  EXPECT_EQ(bench.run().end, RunRecord::End::kDone);
  EXPECT_TRUE(fs::exists(scratch / "mine.txt"));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch), fs::directory_iterator()), 1);
  fs::remove_all(scratch);
}

TEST(Memory, ASpilledPayloadIsReadBackBitByBit) {
  ScratchFolder scratch({});
  SpillFiles files(scratch);
  std::vector<Blob> blobs;
  std::vector<SpillPlace> places;
  for (const std::size_t words : {0, 1, 100, 8191, 8192, 20'000, 300'000}) {
    blobs.push_back(make_blob(words, words));
    blobs.back().text.assign(words / 3, 'x');
    places.push_back(files.write(payload_type<Blob>(), &blobs.back()));
  }
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const auto back =
        std::static_pointer_cast<const Blob>(read_back(payload_type<Blob>(), places[i]));
    EXPECT_EQ(back->words, blobs[i].words);
    EXPECT_EQ(back->text, blobs[i].text);
  }
}

TEST(Memory, TheResidentSizeFollowsWhatIsTouched) {
  const ResidentSize resident;
  const std::size_t before = resident.measure();
  std::vector<char> block(64 << 20, 1);
  EXPECT_GT(resident.measure(), before + (60U << 20U));
  EXPECT_GE(ResidentSize::peak(), resident.measure());
  EXPECT_EQ(block[1000], 1);
}

}  // namespace
}  // namespace stope::toy
