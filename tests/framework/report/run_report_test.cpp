#include "framework/report/run_report.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "stope/digest.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;
using made::text_of;

Plan one_map_plan() {
  made::PlanMaker maker("one map");
  const std::size_t grid =
      maker.stage("grid", "map_source/any", {}, {{"grid", std::string(OccupancyGrid::kType)}});
  maker.output("map.yaml", {grid, 0});
  return maker.plan;
}

// Runs a plan with one output the way the executor would, up to the end given.
void run_once(const Plan& plan, const fs::path& folder, const std::string& text,
              RunRecord::End end = RunRecord::End::kDone) {
  const made::AnyCatalogue catalogue;
  RunReport report(plan, catalogue, made::facts(), folder);
  auto sinks = report.sinks();
  Sink& sink = made::sink(sinks, "write map.yaml");
  sink.consume(made::item(made::artefact({{"yaml", text}, {"pgm", "pixels of " + text}})));
  if (end == RunRecord::End::kDone) sink.finish();
  report.finish(made::ended(end, end == RunRecord::End::kDone ? "" : "grid: no."));
}

nlohmann::json json_of(const fs::path& folder) {
  return nlohmann::json::parse(text_of(folder / "run.json"));
}

TEST(RunReport, LeavesOutputsAndFourFilesAndNothingElse) {
  const made::Folder folder;
  run_once(one_map_plan(), folder.path / "out", "abc");
  EXPECT_EQ(made::files_below(folder.path / "out"),
            (std::vector<std::string>{"log.txt", "outputs/map.pgm", "outputs/map.yaml",
                                      "report.html", "run.json", "trace.json"}));
  EXPECT_EQ(text_of(folder.path / "out/outputs/map.yaml"), "abc");
  EXPECT_FALSE(fs::exists(folder.path / "out/.scratch.stope-part"));
}

TEST(RunReport, ListsEachFileWithItsSha256) {
  const made::Folder folder;
  run_once(one_map_plan(), folder.path, "abc");
  const auto outputs = json_of(folder.path)["outputs"];
  ASSERT_EQ(outputs.size(), 2U);
  EXPECT_EQ(outputs[0]["name"], "map.yaml");
  EXPECT_EQ(outputs[0]["path"], "outputs/map.yaml");
  EXPECT_EQ(outputs[0]["bytes"], 3);
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(outputs[0]["sha256"],
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(outputs[0]["made_of"][0]["port"], "grid.grid");
  EXPECT_EQ(outputs[1]["path"], "outputs/map.pgm");
  EXPECT_EQ(outputs[1]["companion"], true);
}

TEST(RunReport, GivesTheDigestOfThePayloadAnOutputWasMadeOf) {
  const made::Folder folder;
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  OccupancyGrid grid;
  grid.frame.width = grid.frame.height = 2;
  grid.cells = {0, 254, 255, 0};
  RunReport report(plan, catalogue, made::facts(), folder.path);
  auto sinks = report.sinks();
  made::sink(sinks, "write map.yaml").consume(made::item(made::artefact({{"yaml", "a"}})));
  made::sink(sinks, "write map.yaml").finish();
  made::sink(sinks, "report: grid.grid").consume(made::item(grid));
  made::sink(sinks, "report: grid.grid").finish();
  report.finish(made::ended(RunRecord::End::kDone));
  EXPECT_EQ(json_of(folder.path)["outputs"][0]["made_of"][0]["digest"], digest_of(grid).text());
}

TEST(RunReport, TellsEveryStageWithItsParametersInSiUnits) {
  const made::Folder folder;
  Plan plan = one_map_plan();
  plan.vars = {{"width", "8 m"}};
  made::put_text(folder.path / "p.yaml", "abc");
  plan.files_read = {folder.path / "p.yaml", folder.path / "gone.yaml"};
  const auto parameter = [&plan](const char* name, const char* unit, ParameterValue value) {
    ParameterInfo info;
    info.name = name;
    info.unit = unit;
    plan.stages[0].info.parameters.push_back(info);
    plan.stages[0].parameters.push_back(std::move(value));
  };
  parameter("width", "m", 8.0);
  parameter("start", "m", std::vector<double>{1.5, -2});
  parameter("goal", "m", std::monostate{});
  parameter("count", "", std::int64_t{7});
  parameter("mode", "", std::string("\xff"));  // not UTF-8
  run_once(plan, folder.path / "out", "abc");
  const auto json = json_of(folder.path / "out");
  const auto& stage = json["stages"][0];
  EXPECT_EQ(stage["name"], "grid");
  EXPECT_EQ(stage["use"], "map_source/any");
  EXPECT_EQ(stage["plugin"]["build_id"], "0123456789abcdef");
  EXPECT_EQ(stage["parameters"]["width"], 8.0);
  EXPECT_EQ(stage["parameters"]["start"], nlohmann::json({1.5, -2.0}));
  EXPECT_TRUE(stage["parameters"]["goal"].is_null());
  EXPECT_EQ(stage["parameters"]["count"], 7);
  EXPECT_EQ(stage["units"], nlohmann::json({{"width", "m"}, {"start", "m"}, {"goal", "m"}}));
  EXPECT_EQ(json["stages"][1]["inputs"]["payload"], "grid.grid");
  EXPECT_EQ(json["pipeline"]["vars"]["width"], "8 m");
  EXPECT_EQ(json["pipeline"]["files"][0]["sha256"],
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_TRUE(json["pipeline"]["files"][1]["sha256"].is_null());
  EXPECT_EQ(json["run"]["seed"], 7);
  EXPECT_EQ(json["machine"]["cores"].get<int>() > 0, true);
}

TEST(RunReport, SaysWhichStagesMayGiveOtherBytesTheNextTime) {
  const made::Folder folder;
  Plan plan = one_map_plan();
  run_once(plan, folder.path / "out", "abc");
  EXPECT_FALSE(json_of(folder.path / "out")["stages"][0].contains("deterministic"));
  EXPECT_EQ(made::text_of(folder.path / "out" / "report.html").find("not deterministic"),
            std::string::npos);
  plan.stages[0].info.deterministic = false;
  run_once(plan, folder.path / "out", "abc");
  EXPECT_EQ(json_of(folder.path / "out")["stages"][0]["deterministic"], false);
  EXPECT_NE(made::text_of(folder.path / "out" / "report.html").find("not deterministic"),
            std::string::npos);
}

TEST(RunReport, TellsWhereTheOutputsOfAStageThatDidNotRunCameFrom) {
  const made::Folder folder;
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  RunReport report(plan, catalogue, made::facts(), folder.path);
  EXPECT_EQ(report.needed(), (std::vector<PlannedSource>{{1, 0}}));  // the artefact
  EXPECT_EQ(report.welcome(), (std::vector<PlannedSource>{{0, 0}}));
  auto sinks = report.sinks([](const PlannedSource&) { return false; });
  ASSERT_EQ(sinks.size(), 1U);
  made::sink(sinks, "write map.yaml").consume(made::item(made::artefact({{"yaml", "a"}})));
  made::sink(sinks, "write map.yaml").finish();
  report::Sketch seen;
  seen.kind = "A grid seen before";
  seen.marks.push_back({"start", {1, 2}, "a mark"});
  report.know({{0, 0}, 1, std::string(32, 'f'), {seen}});
  StageReuse grid, map;
  grid.from = StageReuse::From::kNotNeeded;
  grid.key = std::string(32, 'a');
  grid.parts = {{"seed", "1"}};
  map.from = StageReuse::From::kStore;
  report.set_reuse({grid, map});
  report.finish(made::ended(RunRecord::End::kDone));
  const auto json = json_of(folder.path);
  EXPECT_EQ(json["stages"][0]["from"], "not needed");
  EXPECT_EQ(json["stages"][0]["key"]["digest"], grid.key);
  EXPECT_EQ(json["stages"][0]["key"]["parts"][0], nlohmann::json({"seed", "1"}));
  EXPECT_EQ(json["stages"][1]["from"], "store");
  EXPECT_EQ(json["outputs"][0]["made_of"][0]["digest"], std::string(32, 'f'));
  const std::string page = text_of(folder.path / "report.html");
  EXPECT_NE(page.find("A grid seen before"), std::string::npos);
  EXPECT_NE(page.find("0 ran, 0 from the store, 1 not needed"), std::string::npos);
}

TEST(RunReport, BeginsAnewWhenItsSinksAreMadeAgain) {
  const made::Folder folder;
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  RunReport report(plan, catalogue, made::facts(), folder.path);
  for (const char* text : {"void", "valid"}) {
    auto sinks = report.sinks();
    made::sink(sinks, "write map.yaml").consume(made::item(made::artefact({{"yaml", text}})));
    made::sink(sinks, "write map.yaml").finish();
  }
  report.finish(made::ended(RunRecord::End::kDone));
  EXPECT_EQ(text_of(folder.path / "outputs/map.yaml"), "valid");
  EXPECT_EQ(json_of(folder.path)["outputs"].size(), 1U);
}

TEST(RunReport, ReplacesAnEarlierRunAndKeepsForeignFiles) {
  const made::Folder folder;
  made::put_text(folder.path / "notes.txt", "mine");
  made::put_text(folder.path / "outputs/sketch.svg", "mine too");
  run_once(one_map_plan(), folder.path, "first");
  run_once(one_map_plan(), folder.path, "second");
  EXPECT_EQ(text_of(folder.path / "notes.txt"), "mine");
  EXPECT_EQ(text_of(folder.path / "outputs/sketch.svg"), "mine too");
  EXPECT_EQ(text_of(folder.path / "outputs/map.yaml"), "second");
}

TEST(RunReport, KeepsEarlierOutputsWhenTheRunFailsOrIsCancelled) {
  for (const auto end : {RunRecord::End::kFailed, RunRecord::End::kCancelled}) {
    const made::Folder folder;
    run_once(one_map_plan(), folder.path, "first");
    run_once(one_map_plan(), folder.path, "second", end);
    EXPECT_EQ(text_of(folder.path / "outputs/map.yaml"), "first");
    EXPECT_EQ(text_of(folder.path / "outputs/map.pgm"), "pixels of first");
    const auto json = json_of(folder.path);
    EXPECT_EQ(json["run"]["end"], end == RunRecord::End::kFailed ? "failed" : "cancelled");
    EXPECT_EQ(json["run"]["sentence"], "grid: no.");
    EXPECT_TRUE(json["outputs"].empty());
    EXPECT_EQ(json["outputs_kept_from_earlier"][0], "outputs/map.yaml");
    EXPECT_EQ(made::files_below(folder.path).size(), 6U);
  }
}

TEST(RunReport, LeavesNothingWithoutFinish) {
  const made::Folder folder;
  {
    const Plan plan = one_map_plan();
    const made::AnyCatalogue catalogue;
    RunReport report(plan, catalogue, made::facts(), folder.path);
    auto sinks = report.sinks();
    made::sink(sinks, "write map.yaml").consume(made::item(made::artefact({{"yaml", "a"}})));
    report.log(LogLevel::kInfo, "grid", "halfway");
  }
  EXPECT_TRUE(made::files_below(folder.path).empty());
}

TEST(RunReport, RemovesWhatAKilledRunLeft) {
  const made::Folder folder;
  made::put_text(folder.path / "outputs/deep/.map.yaml.stope-part", "half");
  made::put_text(folder.path / ".run.json.stope-part", "half");
  run_once(one_map_plan(), folder.path, "abc");
  EXPECT_EQ(made::files_below(folder.path).size(), 6U);
}

TEST(RunReport, RefusesAFolderThatAnotherRunUses) {
  const made::Folder folder;
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  const RunReport first(plan, catalogue, made::facts(), folder.path);
  try {
    const RunReport second(plan, catalogue, made::facts(), folder.path);
    FAIL() << "two runs share a folder";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("another run is writing into"), std::string::npos);
  }
}

TEST(RunReport, LeavesTheFolderOfAComparisonAlone) {
  const made::Folder folder;
  made::put_text(folder.path / "comparison.json", "{}");
  made::put_text(folder.path / "report.html", "the verdict");
  EXPECT_THROW(run_once(one_map_plan(), folder.path, "abc"), Error);
  EXPECT_EQ(made::files_below(folder.path),
            (std::vector<std::string>{"comparison.json", "report.html"}));
  EXPECT_EQ(text_of(folder.path / "report.html"), "the verdict");
}

TEST(RunReport, RefusesAFileInPlaceOfTheFolder) {
  const made::Folder folder;
  made::put_text(folder.path / "out", "a file");
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  EXPECT_THROW(RunReport(plan, catalogue, made::facts(), folder.path / "out"), Error);
  EXPECT_EQ(text_of(folder.path / "out"), "a file");
}

std::string refusal_of(const fs::path& folder) {
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  try {
    const RunReport report(plan, catalogue, made::facts(), folder);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(RunReport, RefusesOutputsThatAreASymbolicLink) {
  for (const char* target : {"elsewhere", "gone"}) {
    const made::Folder folder;
    made::put_text(folder.path / "elsewhere/map.yaml", "not ours");
    fs::create_directory(folder.path / "out");
    fs::create_directory_symlink(folder.path / target, folder.path / "out/outputs");
    const std::string sentence = refusal_of(folder.path / "out");
    EXPECT_NE(sentence.find((folder.path / "out/outputs").string() + " is a symbolic link"),
              std::string::npos)
        << sentence;
    EXPECT_EQ(text_of(folder.path / "elsewhere/map.yaml"), "not ours");
    EXPECT_FALSE(fs::exists(folder.path / "gone"));
  }
}

TEST(RunReport, RefusesAFolderInPlaceOfOneOfItsFiles) {
  for (const char* name : {"run.json", "report.html", "log.txt", "trace.json"}) {
    const made::Folder folder;
    made::put_text(folder.path / name / "notes.txt", "mine");
    const std::string sentence = refusal_of(folder.path);
    EXPECT_NE(sentence.find((folder.path / name).string() + " is a folder"), std::string::npos)
        << sentence;
    EXPECT_EQ(made::files_below(folder.path),
              std::vector<std::string>{name + std::string("/notes.txt")});
  }
}

TEST(RunReport, NamesWhatElseIsInOutputs) {
  const made::Folder folder;
  run_once(one_map_plan(), folder.path, "first");
  const std::string before = text_of(folder.path / "report.html");
  EXPECT_EQ(before.find("not written by this run"), std::string::npos);
  made::put_text(folder.path / "outputs/old & grey.png", "of an earlier pipeline");
  made::put_text(folder.path / "outputs/live/000000.png", "of an earlier stream");
  run_once(one_map_plan(), folder.path, "second");
  const std::string few = text_of(folder.path / "report.html");
  EXPECT_NE(few.find("not written by this run: <code>live/</code>, "
                     "<code>old &amp; grey.png</code>.</p>"),
            std::string::npos);
  for (int i = 10; i < 20; ++i)
    made::put_text(folder.path / ("outputs/a" + std::to_string(i) + ".svg"), "more");
  run_once(one_map_plan(), folder.path, "third");
  const std::string many = text_of(folder.path / "report.html");
  EXPECT_NE(many.find("<code>a10.svg</code>"), std::string::npos);
  EXPECT_NE(many.find("<code>a19.svg</code> and 2 more.</p>"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path / "outputs/old & grey.png"));
}

// In a process of its own, whose files may not grow beyond `limit` bytes: the system refuses to
// write more, as it does when a disk is full. Returns the exit code and fills `sentence`.
int run_with_small_disk(const fs::path& folder, rlim_t limit, std::size_t size) {
  const pid_t child = ::fork();
  if (child != 0) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  ::signal(SIGXFSZ, SIG_IGN);
  const Plan plan = one_map_plan();
  const made::AnyCatalogue catalogue;
  int code = 0;
  try {
    RunReport report(plan, catalogue, made::facts(), folder);
    const rlimit bound{limit, limit};
    ::setrlimit(RLIMIT_FSIZE, &bound);
    try {
      auto sinks = report.sinks();
      Sink& sink = made::sink(sinks, "write map.yaml");
      sink.consume(made::item(made::artefact({{"yaml", "new"}, {"pgm", std::string(size, 'x')}})));
      sink.finish();
      report.finish(made::ended(RunRecord::End::kDone));
    } catch (const Error& error) {
      code = std::string(error.what()).find("cannot write") != std::string::npos ? 10 : 12;
      report.finish(made::ended(RunRecord::End::kFailed, error.what()));
    }
  } catch (const Error&) {
    code += 1;
  }
  ::_exit(code);
}

TEST(RunReport, SaysThatTheDiskIsFullAndKeepsWhatWasThere) {
  const made::Folder folder;
  run_once(one_map_plan(), folder.path, "first");
  // Room for everything but the output: the run fails with a sentence, and run.json tells of it.
  EXPECT_EQ(run_with_small_disk(folder.path, 1 << 20, 2 << 20), 10);
  EXPECT_EQ(text_of(folder.path / "outputs/map.yaml"), "first");
  EXPECT_EQ(text_of(folder.path / "outputs/map.pgm"), "pixels of first");
  EXPECT_EQ(json_of(folder.path)["run"]["end"], "failed");
  EXPECT_EQ(made::files_below(folder.path).size(), 6U);
}

TEST(RunReport, KeepsEverythingWhenNotEvenTheReportFits) {
  const made::Folder folder;
  run_once(one_map_plan(), folder.path, "first");
  const std::string json = text_of(folder.path / "run.json");
  EXPECT_EQ(run_with_small_disk(folder.path, 100, 50), 11);
  EXPECT_EQ(text_of(folder.path / "outputs/map.yaml"), "first");
  EXPECT_EQ(text_of(folder.path / "run.json"), json);
  EXPECT_EQ(made::files_below(folder.path).size(), 6U);
}

}  // namespace
}  // namespace stope
