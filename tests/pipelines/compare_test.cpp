// The command itself: shipped experiments are right, exit codes are as promised, and a comparison
// that was killed is gone on with and leaves the same bytes.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "stope_process.hpp"

namespace stope::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExperiment = R"(stope_experiment: 1
name: small
base: @/pipelines/measure/true_grid.yaml
set: {scans.size: 250, scans.scans: 1}
arms:
  watershed: {roads.use: topology/watershed}
  voronoi: {roads.use: topology/voronoi}
recordings:
  cross: {seed: [1, 2, 3]}
metrics:
  apls: {from: apls, better: higher, matters: 0.01}
)";

std::string experiment() {
  std::string text = kExperiment;
  return text.replace(text.find('@'), 1, shipped(""));
}

std::map<std::string, std::string> artefacts(const fs::path& out) {
  std::map<std::string, std::string> files;
  const auto comparison = nlohmann::json::parse(read_file(out / "comparison.json"));
  for (const auto& cell : comparison.at("cells"))
    for (const auto& file : cell.at("artefacts")) files[file.at("path")] = file.at("sha256");
  return files;
}

class Compare : public ::testing::Test {
 protected:
  std::vector<std::string> command(const std::string& out) {
    write_file(folder_.path() / "e.yaml", experiment());
    return {"compare",   (folder_.path() / "e.yaml").string(),
            "--out",     path(out),
            "--cache",   path(out + "_store"),
            "--threads", "2"};
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  TemporaryFolder folder_;
};

TEST_F(Compare, RunsAllArmsAndSaysWhatMayBeSaid) {
  const auto result = stope(command("out"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("small: 6 runs done, 0 failed, 0 excluded."), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("voronoi beside watershed:"), std::string::npos) << result.out;
  const auto of_one = output_digests(folder_.path() / "out/arms/voronoi/seed=1/1");
  EXPECT_FALSE(of_one.empty());
  EXPECT_EQ(artefacts(folder_.path() / "out").size(), 6 * of_one.size());
}

TEST_F(Compare, AnArmLeavesTheBytesOfStopeRun) {
  ASSERT_EQ(stope(command("out")).exit_code, 0);
  ASSERT_EQ(stope({"run", shipped("pipelines/measure/true_grid.yaml"), "--set", "scans.size=250",
                   "--set", "scans.scans=1", "--set", "roads.use=topology/voronoi", "--seed", "2",
                   "--out", path("alone"), "--cache", path("other_store")})
                .exit_code,
            0);
  EXPECT_EQ(output_digests(folder_.path() / "out/arms/voronoi/seed=2/2"),
            output_digests(folder_.path() / "alone"));
}

TEST_F(Compare, KilledItGoesOnAndLeavesTheSameBytes) {
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(stope(command("whole")).exit_code, 0);
  const auto took = std::chrono::steady_clock::now() - begin;
  const auto wanted = artefacts(folder_.path() / "whole");
  for (const double share : {0.3, 0.6, 0.9}) {
    const std::string name = "killed" + std::to_string(share);
    {
      StopeProcess process(command(name));
      std::this_thread::sleep_for(took * share);
      process.send_signal(SIGKILL);
      process.wait();
    }
    EXPECT_EQ(stope(command(name)).exit_code, 0);
    EXPECT_EQ(artefacts(folder_.path() / name), wanted) << "killed at " << share;
  }
}

TEST_F(Compare, WhatIsWrongIsAnExitCodeOfTwo) {
  write_file(folder_.path() / "bad.yaml",
             "stope_experiment: 1\nbase: gone.yaml\narms: {a: , b: }\n"
             "metrics: {apls: {from: apls, better: higher, matters: 0.01}}\n");
  const auto result = stope({"compare", path("bad.yaml"), "--out", path("out")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("bad.yaml:2:7: error[P001]"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(Compare, AMisspeltFigureStopsItBeforeTheSecondRecording) {
  auto words = command("out");
  std::string text = experiment();
  text += "  detour: {from: detour, measure: detuor_p95, better: lower, matters: 0.02}\n";
  write_file(folder_.path() / "e.yaml", text);
  const auto result = stope(words);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_NE(result.err.find("e.yaml:12:35: error[X010]: Stage 'detour' gave no figure "
                            "'detuor_p95'. Did you mean 'detour_p95'?"),
            std::string::npos)
      << result.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "out/arms/voronoi/seed=2/2/run.json"));
  // Corrected, it goes on, and only what measures was perhaps stopped.
  text.replace(text.find("detuor"), 6, "detour");
  write_file(folder_.path() / "e.yaml", text);
  EXPECT_EQ(stope(words).exit_code, 0);
}

TEST_F(Compare, AFailedArmIsAnExitCodeOfOne) {
  std::string text = experiment();
  text.insert(text.find("recordings"),
              "  crowded: {scans.dead_ends: 400, scans.road_width: 40 m}\n");
  auto words = command("out");
  write_file(folder_.path() / "e.yaml", text);
  const auto result = stope(words);
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_NE(result.out.find("6 runs done, 3 failed"), std::string::npos) << result.out;
}

TEST(ShippedExperiments, AreRight) {
  for (const auto& entry : fs::directory_iterator(shipped("pipelines/compare"))) {
    const auto result =
        stope({"check", entry.path().string()}, {{"STOPE_DATA", data_folder().string()}});
    EXPECT_EQ(result.exit_code, 0) << entry.path() << result.err;
  }
}

}  // namespace
}  // namespace stope::testing
