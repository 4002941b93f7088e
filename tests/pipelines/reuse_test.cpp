// The command with a store: what runs again, what the store's own commands say, and replays.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "small_map.hpp"
#include "stope_process.hpp"

namespace stope::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class ReuseTest : public ::testing::Test {
 protected:
  ReuseTest() : map_(write_ring_map(folder_.path())) { write_pipeline("5 m", "grid"); }

  /// A map's roads, two outputs.
  void write_pipeline(const std::string& clearance, const std::string& grid) {
    write_file(pipeline(),
               "stope: 1\nname: ring\nstages:\n  grid: {use: map_source/map_server, "
               "params: {map: " +
                   map_.string() + "}}\n  roads: {use: topology/voronoi, in: " + grid +
                   ", params: {min_clearance: " + clearance +
                   "}}\noutputs: {roads.geojson: roads, map.yaml: grid}\n");
  }
  fs::path pipeline() const { return folder_.path() / "pipeline.yaml"; }
  fs::path out() const { return folder_.path() / "run"; }

  ProcessResult call(std::vector<std::string> arguments) const {
    return stope(arguments, {{"STOPE_CACHE", (folder_.path() / "store").string()}});
  }
  /// Runs the pipeline and gives what it printed.
  json run(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"run", pipeline().string(), "--out", out().string(),
                                       "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = call(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
    return json::parse(result.out, nullptr, false);
  }
  static int ran(const json& printed) { return printed.at("stages").at("run").get<int>(); }
  json from() const {
    const json record = json::parse(read_file(out() / "run.json"));
    json from;
    for (const json& stage : record.at("stages"))
      from[stage.at("name").get<std::string>()] = stage.at("from");
    return from;
  }
  void flip_a_bit_in_each_object() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "store/objects")) {
      if (!entry.is_regular_file()) continue;
      std::string bytes = read_file(entry.path());
      bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
      write_file(entry.path(), bytes);
    }
  }

  TemporaryFolder folder_;
  fs::path map_;
};

TEST_F(ReuseTest, AnUnchangedRunExecutesNothingAndLeavesTheSameFolder) {
  EXPECT_EQ(ran(run()), 4);
  const auto digests = output_digests(out());
  const std::string page = read_file(out() / "report.html");
  fs::remove_all(out());
  const json again = run();
  EXPECT_EQ(again.at("stages"),
            (json{{"run", 0}, {"reopened", 0}, {"store", 2}, {"not_needed", 2}}));
  EXPECT_EQ(output_digests(out()), digests);
  EXPECT_EQ(from().at("grid"), "not needed");
  // The pictures of what did not run are there all the same.
  const auto pictures = [](const std::string& html) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = html.find("<figure", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_GT(pictures(page), 0U);
  EXPECT_EQ(pictures(read_file(out() / "report.html")), pictures(page));
}

TEST_F(ReuseTest, AnEditedPictureIsNoticedThoughOnlyTheYamlNamesIt) {
  run();
  const auto digests = output_digests(out());
  const fs::path picture = fs::path(map_).replace_extension(".pgm");
  std::string bytes = read_file(picture);
  for (std::size_t i = bytes.size() - 120 * 15; i < bytes.size() - 120 * 12; ++i)
    bytes[i] = static_cast<char>(bytes[i] ^ 0x7f);
  write_file(picture, bytes);
  const json printed = run({"--why"});
  EXPECT_EQ(ran(printed), 4);
  EXPECT_NE(printed.at("why").at("grid").get<std::string>().find("further file 1 was ring.pgm"),
            std::string::npos)
      << printed;
  EXPECT_NE(output_digests(out()), digests);
}

TEST_F(ReuseTest, WhySaysWhichPartHasChanged) {
  run();
  const json printed = run({"--why", "--set", "roads.min_clearance=4 m"});
  EXPECT_EQ(ran(printed), 2);
  EXPECT_EQ(printed.at("why").at("roads"), "parameter min_clearance was 5, is 4");
  EXPECT_FALSE(printed.at("why").contains("grid"));
}

TEST_F(ReuseTest, WithoutTheStoreAllRunsAndNothingIsKept) {
  EXPECT_EQ(ran(run({"--no-cache"})), 4);
  EXPECT_FALSE(fs::exists(folder_.path() / "store"));
  EXPECT_EQ(ran(run({"--keep", "none"})), 4);
  EXPECT_EQ(ran(run()), 4);
  EXPECT_EQ(ran(run()), 0);
  EXPECT_EQ(ran(run({"--no-cache"})), 4);
  const auto refused = call({"run", pipeline().string(), "--no-cache", "--resume"});
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
}

TEST_F(ReuseTest, DamageInTheStoreIsFoundAndMended) {
  run();
  const auto digests = output_digests(out());
  flip_a_bit_in_each_object();
  EXPECT_EQ(ran(run()), 4);
  EXPECT_EQ(output_digests(out()), digests);
  EXPECT_EQ(ran(run()), 0);
}

TEST_F(ReuseTest, TheStoreCanBeLookedAtCheckedAndEmptied) {
  run();
  const json list = json::parse(call({"cache", "ls", "--json"}).out);
  EXPECT_GE(list.at("stages").size(), 4U);
  EXPECT_EQ(call({"cache", "verify"}).exit_code, 0);
  flip_a_bit_in_each_object();
  const auto damaged = call({"cache", "verify", "--json"});
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_EQ(json::parse(damaged.out).at("damaged"), list.at("objects"));
  EXPECT_EQ(json::parse(call({"cache", "ls", "--json"}).out).at("stages").size(), 0U);
  EXPECT_EQ(ran(run()), 4);
  const json left = json::parse(call({"cache", "gc", "--cache-limit", "1MiB", "--json"}).out);
  EXPECT_LE(left.at("bytes").get<std::uint64_t>(), 1U << 20);
  EXPECT_NE(call({"cache", "ls"}).out.find("roads (roads)"), std::string::npos);
}

TEST_F(ReuseTest, DamagedRecordsAreFoundByVerify) {
  run();
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "store/stages"))
    if (entry.is_regular_file()) write_file(entry.path(), "garbage");
  const auto damaged = call({"cache", "verify"});
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_NE(damaged.out.find("Damaged, and removed from"), std::string::npos) << damaged.out;
  const auto sound = call({"cache", "verify"});
  EXPECT_EQ(sound.exit_code, 0);
  EXPECT_NE(sound.out.find("Nothing is damaged in"), std::string::npos) << sound.out;
  EXPECT_EQ(ran(run()), 4);
}

TEST_F(ReuseTest, CommandsOfTheStoreMakeNone) {
  for (const char* command : {"ls", "gc", "verify"}) {
    const auto result = call({"cache", command});
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_NE(result.err.find("there is no store in"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "store")) << command;
  }
}

TEST_F(ReuseTest, AFolderOfSomethingElseIsNotUsedAsAStore) {
  const fs::path scans = folder_.path() / "scans";
  fs::create_directory(scans);
  write_file(scans / "000000.bin", "a scan");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"cache", "ls"},
        {"cache", "gc"},
        {"cache", "verify"},
        {"run", pipeline().string(), "--out", out().string()}}) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--cache", scans.string()});
    const auto result = call(all);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_NE(result.err.find("is not empty and is no store"), std::string::npos) << result.err;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(scans), fs::directory_iterator()), 1);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(ReuseTest, AMapUnpackedOverAnotherIsNoticedThoughItLooksTheSame) {
  run();
  const auto digests = output_digests(out());
  const fs::path picture = fs::path(map_).replace_extension(".pgm");
  // As tar does: another content of the same length, and the time that the archive gives.
  const auto time = fs::last_write_time(picture);
  std::string bytes = read_file(picture);
  for (std::size_t i = bytes.size() - 120 * 15; i < bytes.size() - 120 * 12; ++i)
    bytes[i] = static_cast<char>(bytes[i] ^ 0x7f);
  write_file(picture, bytes);
  fs::last_write_time(picture, time);
  EXPECT_EQ(ran(run()), 4);
  EXPECT_NE(output_digests(out()), digests);
}

TEST_F(ReuseTest, AReplayGivesTheSameBytes) {
  run({"--set", "roads.min_clearance=4 m", "--seed", "3"});
  const auto replay = call({"replay", out().string()});
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_NE(replay.out.find("The same: 3 files, bit for bit."), std::string::npos) << replay.out;
}

TEST_F(ReuseTest, AReplayNamesTheParameterThatChangedBeforeItRuns) {
  run();
  write_pipeline("4 m", "grid");
  const auto replay = call({"replay", (out() / "run.json").string()});
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_NE(replay.out.find("first thing that differs: stage \"roads\": parameter min_clearance "
                            "was 5, is 4"),
            std::string::npos)
      << replay.out;
}

TEST_F(ReuseTest, AReplayNamesTheInputThatChanged) {
  run();
  write_file(fs::path(map_).replace_extension(".pgm"), "another picture");
  const auto replay = call({"replay", out().string()});
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_NE(replay.out.find("stage \"grid\": further file 1 was ring.pgm"), std::string::npos)
      << replay.out;
}

TEST_F(ReuseTest, AReplayNamesTheArtefactThatDiffers) {
  run();
  // As if the recorded run had been made by a machine that rounds otherwise.
  json record = json::parse(read_file(out() / "run.json"));
  record["outputs"][0]["sha256"] = std::string(64, '0');
  record["machine"]["features"] = {"imaginary"};
  write_file(out() / "run.json", record.dump());
  const auto replay = call({"replay", out().string()});
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_NE(replay.out.find("outputs/roads.geojson, whose SHA-256 was 0000"), std::string::npos)
      << replay.out;
  EXPECT_NE(replay.out.find("features were imaginary"), std::string::npos) << replay.out;
}

TEST_F(ReuseTest, AReplayNoticesAnArtefactThatWasEditedOrRemoved) {
  run();
  const fs::path roads = out() / "outputs/roads.geojson";
  write_file(roads, read_file(roads) + " ");
  const auto edited = call({"replay", out().string()});
  EXPECT_EQ(edited.exit_code, 1);
  EXPECT_NE(edited.out.find("outputs/roads.geojson was edited or replaced after the recorded run"),
            std::string::npos)
      << edited.out;
  fs::remove(roads);
  const auto removed = call({"replay", out().string()});
  EXPECT_EQ(removed.exit_code, 1);
  EXPECT_NE(removed.out.find("outputs/roads.geojson is not in the recorded run's folder any more"),
            std::string::npos)
      << removed.out;
}

TEST_F(ReuseTest, AReplayOfNothingIsRefused) {
  EXPECT_NE(call({"replay", (folder_.path() / "no").string()}).err.find("give the run.json"),
            std::string::npos);
}

TEST_F(ReuseTest, TwoRunsAtOnceShareAStore) {
  const std::map<std::string, std::string> environment{
      {"STOPE_CACHE", (folder_.path() / "store").string()}};
  for (int round = 0; round < 3; ++round) {
    const std::string clearance = "roads.min_clearance=" + std::to_string(3 + round) + " m";
    StopeProcess a(
        {"run", pipeline().string(), "--out", (folder_.path() / "a").string(), "--set", clearance},
        environment);
    StopeProcess b(
        {"run", pipeline().string(), "--out", (folder_.path() / "b").string(), "--set", clearance},
        environment);
    EXPECT_EQ(a.wait().exit_code, 0);
    EXPECT_EQ(b.wait().exit_code, 0);
    EXPECT_EQ(output_digests(folder_.path() / "a"), output_digests(folder_.path() / "b"));
  }
  EXPECT_EQ(call({"cache", "verify"}).exit_code, 0);
}

}  // namespace
}  // namespace stope::testing
