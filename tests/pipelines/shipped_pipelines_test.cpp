// Every shipped pipeline is checked, and checked again with each of its stages swapped for every
// member that is said to be interchangeable; the quickstart is also run so. The promise: changing
// one word after `use:` is all it takes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "small_map.hpp"
#include "stope_process.hpp"

namespace stope::testing {
namespace {

// A quickstart small enough to run many times.
const std::vector<std::string> kSmall{"--set",          "scans.size=250", "--set",
                                      "scans.scans=40", "--set",          "scans.azimuths=360"};

struct Shipped {
  std::string file;
  std::vector<std::string> arguments;  // so that its check needs no data
};

std::vector<Shipped> pipelines(const TemporaryFolder& folder) {
  const auto recording = folder.path() / "recording";
  write_file(recording / "poses_velo_in_odom.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  write_file(recording / "scans_third/000000.bin", std::string(16, '\0'));
  const auto map = write_ring_map(folder.path());
  return {{"pipelines/quickstart.yaml", {}},
          {"pipelines/measure/true_grid.yaml", {}},
          {"pipelines/measure/mapped_grid.yaml", {}},
          {"pipelines/haul_roads/from_map.yaml", {"--set", "vars.map=" + map.string()}},
          {"pipelines/regions/rooms.yaml", {"--set", "vars.map=" + map.string()}},
          {"pipelines/haul_roads/drive.yaml", {"--set", "vars.map=" + map.string()}},
          {"pipelines/haul_roads/prior.yaml", {"--set", "vars.recording=" + recording.string()}}};
}

std::vector<std::string> with(std::vector<std::string> list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

nlohmann::json check(const Shipped& pipeline, const std::vector<std::string>& more = {}) {
  const auto result =
      stope(with(with({"check", shipped(pipeline.file), "--json"}, pipeline.arguments), more));
  EXPECT_EQ(result.exit_code, 0) << pipeline.file << result.out << result.err;
  return nlohmann::json::parse(result.out);
}

struct Swap {
  std::string stage, member;
  std::vector<std::string> arguments() const { return {"--set", stage + ".use=" + member}; }
};

// All swaps that change one `use` of the pipeline.
std::vector<Swap> swaps(const Shipped& pipeline) {
  std::vector<Swap> list;
  const nlohmann::json checked = check(pipeline);
  for (const auto& stage : checked.at("stages")) {
    if (stage.at("name").get<std::string>().starts_with("outputs/")) continue;
    const auto inspected = stope({"inspect", stage.at("use").get<std::string>(), "--json"});
    const nlohmann::json declared = nlohmann::json::parse(inspected.out);
    for (const auto& member : declared.at("interchangeable")) {
      list.push_back({stage.at("name"), member});
    }
  }
  return list;
}

TEST(ShippedPipelines, EveryInterchangeableMemberFits) {
  const TemporaryFolder folder;
  for (const Shipped& pipeline : pipelines(folder)) {
    const std::vector<Swap> list = swaps(pipeline);
    EXPECT_FALSE(list.empty()) << pipeline.file;
    for (const Swap& swap : list) {
      SCOPED_TRACE(pipeline.file + ": " + swap.stage + " -> " + swap.member);
      check(pipeline, swap.arguments());
    }
  }
}

TEST(ShippedPipelines, TheExtractorCanBeSwappedWhereverRoadsAloneAreAskedFor) {
  const TemporaryFolder folder;
  for (const Shipped& pipeline : pipelines(folder)) {
    if (pipeline.file == "pipelines/regions/rooms.yaml") continue;  // asks for regions as well
    check(pipeline, {"--set", "roads.use=topology/voronoi"});
    check(pipeline, {"--set", "roads.use=topology/watershed"});
  }
}

TEST(ShippedPipelines, TheQuickstartRunsWithEveryInterchangeableMember) {
  const TemporaryFolder folder;
  const Shipped quickstart{"pipelines/quickstart.yaml", kSmall};
  int runs = 0;
  for (const Swap& swap : swaps(quickstart)) {
    SCOPED_TRACE(swap.stage + " -> " + swap.member);
    const auto out = folder.path() / std::to_string(runs++);
    const auto result = stope(with(
        with({"run", shipped(quickstart.file), "--out", out.string()}, kSmall), swap.arguments()));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
  }
  EXPECT_GE(runs, 2);
}

TEST(ShippedPipelines, TheQuickstartGivesTheSameBytesOnAnyNumberOfThreads) {
  const TemporaryFolder folder;
  std::map<std::string, std::string> first;
  for (const char* threads : {"1", "2", "4", "8"}) {
    const auto out = folder.path() / threads;
    const auto result = stope(with(
        {"run", shipped("pipelines/quickstart.yaml"), "--out", out.string(), "--threads", threads},
        kSmall));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto digests = output_digests(out);
    EXPECT_GE(digests.size(), 7U);
    if (first.empty()) first = digests;
    EXPECT_EQ(digests, first) << "on " << threads << " threads";
  }
}

}  // namespace
}  // namespace stope::testing
