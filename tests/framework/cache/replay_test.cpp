#include "framework/cache/replay.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "framework/report/sha256.hpp"
#include "stope/error.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

StageKey key(std::vector<KeyPart> parts, bool only_this_run = false) {
  StageKey key;
  std::string all;
  for (const KeyPart& part : parts) all += part.name + "=" + part.value + ";";
  key.digest = digest_of(all);
  key.parts = std::move(parts);
  key.only_this_run = only_this_run;
  return key;
}

/// grid -> roads, recorded and found again.
class ReplayTest : public ::testing::Test {
 protected:
  ReplayTest() {
    plan_.stages.resize(2);
    plan_.stages[0].name = "grid";
    plan_.stages[1].name = "roads";
    plan_.stages[1].inputs = {PlannedSource{0, 0}};
    keys_ = {key({{"plugin build", "aa"}, {"parameter map", "content 11"}}),
             key({{"plugin build", "bb"}, {"parameter least", "3"}, {"input grid", "aa11"}})};
    recorded_.version = "1";
    recorded_.stages = {{"grid", {"map_source/any", keys_[0]}},
                        {"roads", {"topology/any", keys_[1]}}};
    write("outputs/roads.geojson", "roads");
    recorded_.outputs = {{"roads.geojson", "outputs/roads.geojson", 5, sha256_of_roads()}};
    recorded_.features = {"avx2", "fma"};
    recorded_.libraries = "glibc 1";
  }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  std::string sha256_of_roads() const {
    return report::sha256_of_file(folder_ / "outputs/roads.geojson").value_or("");
  }
  ReplayVerdict after(const EarlierRun& now) const {
    ReplayVerdict verdict;
    compare_after(recorded_, folder_, now, keys_, plan_, verdict);
    return verdict;
  }
  std::vector<std::string> before() const {
    return compare_before(recorded_, plan_, keys_, "1").differences;
  }

  testing::MemoryContext context_;
  std::filesystem::path folder_ = context_.temporary_folder();
  Plan plan_;
  std::vector<StageKey> keys_;
  EarlierRun recorded_;
};

using Sentences = std::vector<std::string>;

TEST_F(ReplayTest, NothingDiffersIfNothingHasChanged) { EXPECT_EQ(before(), Sentences{}); }

TEST_F(ReplayTest, NamesTheStageWhosePartChangedAndNotWhatIsBelow) {
  keys_[0] = key({{"plugin build", "aa"}, {"parameter map", "content 12"}});
  keys_[1] = key({{"plugin build", "bb"}, {"parameter least", "3"}, {"input grid", "aa12"}});
  EXPECT_EQ(before(), (Sentences{"stage \"grid\": parameter map was content 11, is content 12"}));
}

TEST_F(ReplayTest, NamesTheFirstOfSeveral) {
  keys_[0] = key({{"plugin build", "ab"}, {"parameter map", "content 11"}});
  keys_[1] = key({{"plugin build", "bb"}, {"parameter least", "4"}, {"input grid", "ab11"}});
  EXPECT_EQ(before(), (Sentences{"stage \"grid\": plugin build was aa, is ab",
                                 "stage \"roads\": parameter least was 3, is 4"}));
}

TEST_F(ReplayTest, NamesStagesThatCameAndWent) {
  plan_.stages[1].name = "paths";
  EXPECT_EQ(before(), (Sentences{"there was no stage \"paths\" when it was recorded",
                                 "stage \"roads\" is gone"}));
}

TEST_F(ReplayTest, NoticesOtherWires) {
  keys_[1] = key({{"plugin build", "bb"}, {"parameter least", "3"}, {"input grid", "cc"}});
  EXPECT_EQ(before(), (Sentences{"stage \"roads\" reads its inputs from other stages or ports"}));
}

TEST_F(ReplayTest, TheRunsNameIsNoDifference) {
  keys_[1] = key(
      {{"plugin build", "bb"}, {"parameter least", "3"}, {"input grid", "aa11"}, {"run", "second"}},
      true);
  recorded_.stages["roads"].key = key(
      {{"plugin build", "bb"}, {"parameter least", "3"}, {"input grid", "aa11"}, {"run", "first"}},
      true);
  EXPECT_EQ(before(), Sentences{});
}

TEST_F(ReplayTest, SaysWhichFileDiffersAndWhatMayBeBehindIt) {
  EarlierRun now = recorded_;
  now.outputs[0].sha256 = "6666";
  now.features = {"avx2"};
  now.libraries = "glibc 2";
  plan_.stages[1].info.deterministic = false;
  plan_.stages[1].info.id = "topology/any";
  const ReplayVerdict verdict = after(now);
  EXPECT_EQ(verdict.differences, (Sentences{"outputs/roads.geojson, whose SHA-256 was " +
                                            sha256_of_roads() + " (5 bytes), is 6666 (5 bytes)"}));
  ASSERT_EQ(verdict.remarks.size(), 3U);
  EXPECT_NE(verdict.remarks[0].find("does not promise the same bytes"), std::string::npos);
  EXPECT_NE(verdict.remarks[1].find("features were avx2, fma, are avx2"), std::string::npos);
  EXPECT_NE(verdict.remarks[2].find("glibc 1, is glibc 2"), std::string::npos);
}

TEST_F(ReplayTest, FilesThatAreMissingOrNewDiffer) {
  EarlierRun now = recorded_;
  now.outputs[0].path = "outputs/paths.geojson";
  EXPECT_EQ(after(now).differences, (Sentences{"outputs/roads.geojson was not written this time",
                                               "outputs/paths.geojson is new"}));
}

TEST_F(ReplayTest, AFileThatWasEditedAfterTheRunDiffers) {
  EXPECT_TRUE(after(recorded_).same());
  write("outputs/roads.geojson", "edited");
  const ReplayVerdict edited = after(recorded_);
  EXPECT_EQ(edited.differences,
            (Sentences{"outputs/roads.geojson was edited or replaced after the recorded run: its "
                       "SHA-256 was " +
                       recorded_.outputs[0].sha256 + ", which the second run gives again, and is " +
                       sha256_of_roads()}));
  std::filesystem::remove(folder_ / "outputs/roads.geojson");
  EXPECT_EQ(after(recorded_).differences,
            (Sentences{"outputs/roads.geojson is not in the recorded run's folder any more"}));
}

TEST_F(ReplayTest, ARecordThatWasEditedDiffers) {
  const EarlierRun now = recorded_;
  recorded_.outputs[0].sha256 = "5555";
  EXPECT_EQ(after(now).differences,
            (Sentences{"outputs/roads.geojson, whose SHA-256 was 5555 (5 bytes), is " +
                       sha256_of_roads() +
                       " (5 bytes), as is the file in the recorded run's folder: run.json was "
                       "edited, or the file replaced"}));
}

TEST_F(ReplayTest, ARecordThatIsDamagedOrOfAnotherFormatIsRefusedInASentence) {
  const auto complaint = [&](const std::string& text) -> std::string {
    write("run.json", text);
    try {
      read_earlier_run(folder_ / "run.json");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto expect = [&](const std::string& text, const std::string& what) {
    const std::string sentence = complaint(text);
    EXPECT_NE(sentence.find("run.json cannot be used: it "), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(what), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("json.exception"), std::string::npos) << sentence;
  };
  expect(R"({"format": 1, "stope")", "it is not whole JSON: it goes wrong at byte 22");
  expect(R"({"format": 2})", "it has format 2, and this Stope reads 1");
  expect(R"({"stope": "1"})", "it lacks the entry \"format\"");
  expect(R"({"format": 1, "stope": "1"})", "it lacks the entry \"run\"");
}

TEST_F(ReplayTest, AnEntryOfAnotherKindIsRefusedInASentence) {
  for (const char* text : {R"([])", R"("a text")", R"({"format": 1, "stope": 7})",
                           R"({"format": 1, "stope": "1", "run": []})"}) {
    write("run.json", text);
    try {
      read_earlier_run(folder_ / "run.json");
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      const std::string sentence = error.what();
      EXPECT_NE(sentence.find("one of its entries"), std::string::npos) << sentence;
      EXPECT_EQ(sentence.find("json.exception"), std::string::npos) << sentence;
    }
  }
}

}  // namespace
}  // namespace stope
