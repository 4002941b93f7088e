#include "framework/compare/equal_recordings.hpp"

#include "framework/compare/verdicts.hpp"
#include "tests/framework/compare/comparing.hpp"

namespace stope {
namespace {

using EqualRecordings = testing::ComparingTest;

constexpr const char* kMean = "metrics: {mean: {from: mean, better: higher, matters: 100 mm}}\n";
constexpr const char* kTwoArms = "arms: {one: , two: {change.factor: 2}}\n";

TEST_F(EqualRecordings, OneRecordingUnderSevenNamesCountsOnce) {
  const Comparison made = compare(std::string(kTwoArms) +
                                  "recordings: {a: {seed: 1}, b: {seed: 1}, c: {seed: 1}, d: "
                                  "{seed: 1}, e: {seed: 1}, f: {seed: 1}, g: {seed: 1}}\n" +
                                  kMean);
  EXPECT_EQ(distinct_recordings(made).size(), 1U);
  EXPECT_EQ(made.recordings[0].same_as, "");
  EXPECT_EQ(made.recordings[6].same_as, "a");
  ASSERT_EQ(made.warnings.size(), 1U);
  EXPECT_EQ(made.warnings[0],
            "the recordings 'a', 'b', 'c', 'd', 'e', 'f' and 'g' are one and the same: what their "
            "sources read or make does not differ. They count as one recording");
  EXPECT_NE(log_.text.find(made.warnings[0]), std::string::npos) << "before anything runs";
  EXPECT_EQ(verdicts_of(made)[0].measures[0].verdict, Verdict::kTooFew);
}

TEST_F(EqualRecordings, SeedsThatNobodyReadsMakeNoRecordings) {
  write("map.txt", "1 2 4");
  const std::string rest = std::string(kTwoArms) +
                           "set: {draw.file: map.txt}\n"
                           "recordings: {cross: {seed: [1, 2, 3, 4, 5, 6, 7, 8]}}\n" +
                           kMean;
  const Comparison made = compare(rest);
  EXPECT_EQ(distinct_recordings(made).size(), 1U);
  ASSERT_EQ(made.warnings.size(), 1U);
  EXPECT_NE(made.warnings[0].find("what their sources read or make does not differ"),
            std::string::npos);
  EXPECT_EQ(verdicts_of(made)[0].measures[0].verdict, Verdict::kTooFew);
  EXPECT_EQ(compare(rest).warnings, made.warnings) << "nothing is said twice";
}

// One mine under eight seeds is one mine, though a metric that draws from the seed differs.
TEST_F(EqualRecordings, SeedsThatOnlyAMetricDrawsFromMakeNoRecordings) {
  write("map.txt", "1 2 4");
  const std::string rest = std::string(kTwoArms) +
                           "set: {draw.file: map.txt, mean.use: toy/sample}\n"
                           "recordings: {cross: {seed: [1, 2, 3, 4, 5, 6, 7, 8]}}\n" +
                           kMean;
  const Comparison made = compare(rest);
  EXPECT_NE(made.cell(0, 0, 0).measures, made.cell(0, 1, 0).measures);
  EXPECT_EQ(distinct_recordings(made).size(), 1U);
  EXPECT_EQ(verdicts_of(made)[0].measures[0].verdict, Verdict::kTooFew);
  EXPECT_EQ(compare(rest).warnings, made.warnings) << "gone on with, it says the same";
}

// Without a store nobody knows what sources gave, but all that was left is the same.
TEST_F(EqualRecordings, RecordingsThatLeaveTheSameAreOneWithoutAStore) {
  write("map.txt", "1 2 4");
  store_.clear();
  const Comparison made = compare(std::string(kTwoArms) +
                                  "set: {draw.file: map.txt}\n"
                                  "recordings: {cross: {seed: [1, 2, 3, 4, 5, 6, 7, 8]}}\n" +
                                  kMean);
  EXPECT_EQ(distinct_recordings(made).size(), 1U);
  EXPECT_NE(made.warnings.at(0).find("left the very same files and figures"), std::string::npos);
}

TEST_F(EqualRecordings, RecordingsThatDifferAreNotTakenForOne) {
  const Comparison made = compare(std::string(kTwoArms) +
                                  "recordings: {cross: {seed: [1, 2, 3, 4, 5, 6, 7]}}\n" + kMean);
  EXPECT_EQ(distinct_recordings(made).size(), 7U);
  EXPECT_TRUE(made.warnings.empty());
}

}  // namespace
}  // namespace stope
