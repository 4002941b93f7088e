#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "stope_process.hpp"

namespace stope::testing {
namespace {

TEST(Interrupt, CtrlCEndsARunPromptlyAndLeavesNothingHalfWritten) {
  for (const int milliseconds : {50, 400, 1500}) {
    const TemporaryFolder folder;
    StopeProcess process({"run", shipped("pipelines/quickstart.yaml"), "--out",
                          (folder.path() / "run").string(), "--set", "scans.stride=1"});
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    const auto asked = std::chrono::steady_clock::now();
    process.send_signal(SIGINT);
    const auto result = process.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(20));
    // Before the handler stands, the signal ends the process itself; after, the run says that it
    // was cancelled.
    EXPECT_TRUE(result.exit_code == 1 || result.exit_code == 128 + SIGINT)
        << result.exit_code << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "run/outputs/map.yaml"));
    if (!std::filesystem::exists(folder.path() / "run")) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "run")) {
      EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
    }
  }
}

}  // namespace
}  // namespace stope::testing
