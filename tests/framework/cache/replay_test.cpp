#include "framework/cache/replay.hpp"

#include <gtest/gtest.h>

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
    recorded_.outputs = {{"roads.geojson", "outputs/roads.geojson", 9, "5555"}};
    recorded_.features = {"avx2", "fma"};
    recorded_.libraries = "glibc 1";
  }
  std::vector<std::string> before() const {
    return compare_before(recorded_, plan_, keys_, "1").differences;
  }

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
  ReplayVerdict verdict;
  compare_after(recorded_, now, keys_, plan_, verdict);
  EXPECT_EQ(verdict.differences,
            (Sentences{"outputs/roads.geojson, whose SHA-256 was 5555 (9 bytes), is 6666 (9 "
                       "bytes)"}));
  ASSERT_EQ(verdict.remarks.size(), 3U);
  EXPECT_NE(verdict.remarks[0].find("does not promise the same bytes"), std::string::npos);
  EXPECT_NE(verdict.remarks[1].find("features were avx2, fma, are avx2"), std::string::npos);
  EXPECT_NE(verdict.remarks[2].find("glibc 1, is glibc 2"), std::string::npos);
}

TEST_F(ReplayTest, FilesThatAreMissingOrNewDiffer) {
  EarlierRun now = recorded_;
  now.outputs[0].path = "outputs/paths.geojson";
  ReplayVerdict verdict;
  compare_after(recorded_, now, keys_, plan_, verdict);
  EXPECT_EQ(verdict.differences, (Sentences{"outputs/roads.geojson was not written this time",
                                            "outputs/paths.geojson is new"}));
}

}  // namespace
}  // namespace stope
