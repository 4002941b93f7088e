#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/framework/executor/random_network.hpp"

namespace stope::toy {
namespace {

TEST(Stress, RandomNetworksGiveWhatASequentialReferenceGives) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    RandomNetwork network(seed, 4 + seed % 17);
    network.bench().options.channel_capacity = 1 + seed % 4;
    network.bench().options.threads = 1 + static_cast<int>(seed % 3);
    const RunRecord record = network.bench().run();
    ASSERT_EQ(record.end, RunRecord::End::kDone) << "seed " << seed << ": " << record.sentence;
    ASSERT_TRUE(network.collected() == network.expected()) << "seed " << seed;
  }
}

TEST(Stress, AFailureAtAnyOperationStopsTheWholeRun) {
  int failed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomNetwork network(seed, 4 + seed % 12);
    network.bench().options.channel_capacity = 1 + seed % 4;
    network.bench().options.threads = 2;
    network.break_stage(seed / 3, static_cast<std::int64_t>(seed % 40));
    const RunRecord record = network.bench().run();
    if (record.end == RunRecord::End::kFailed) {
      ++failed;
      ASSERT_NE(record.sentence.find("broken on purpose"), std::string::npos) << record.sentence;
      ASSERT_NE(record.sentence.find(record.failed_stage), std::string::npos) << record.sentence;
    } else {
      // That operation was never reached.
      ASSERT_EQ(record.end, RunRecord::End::kDone);
      ASSERT_TRUE(network.collected() == network.expected()) << "seed " << seed;
    }
  }
  EXPECT_GT(failed, 50);
}

TEST(Stress, CancellationAtAnyMomentEndsTheRunPromptly) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomNetwork network(seed, 4 + seed % 12);
    network.make_sources_endless();
    std::atomic<bool> stop{false};
    network.bench().options.stop = &stop;
    network.bench().options.channel_capacity = 1 + seed % 4;
    network.bench().options.threads = 2;
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(seed * 400));
      stop = true;
    });
    const RunRecord record = network.bench().run();
    other.join();
    // A network may end by itself if nobody reads its sources to the end.
    ASSERT_NE(record.end, RunRecord::End::kFailed) << "seed " << seed << ": " << record.sentence;
  }
}

}  // namespace
}  // namespace stope::toy
