#include "framework/compare/statistics/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "stope/random.hpp"

namespace stope {
namespace {

/// `count` recordings whose arm differs from the baseline by `difference` and normal noise.
MeasuredPairs pairs(int count, double difference, double noise, std::uint64_t seed,
                    double delta = 0.1) {
  Random random(seed);
  MeasuredPairs measured{"length", Direction::kHigher, delta, {}, false};
  for (int i = 0; i < count; ++i) {
    const double baseline = random.uniform(5, 15);
    measured.pairs.push_back(
        {"pit-" + std::to_string(i), baseline, baseline + difference + noise * random.normal()});
  }
  return measured;
}

TEST(Verdict, ClearDifferencesAreBetterOrWorseByTheMeasuresDirection) {
  MeasuredPairs measured = pairs(10, 1, 0.1, 3);
  EXPECT_EQ(compare({measured}, 1)[0].verdict, Verdict::kBetter);
  EXPECT_EQ(text_of(compare({measured}, 1)[0]), "better, and it matters");
  measured.direction = Direction::kLower;
  EXPECT_EQ(compare({measured}, 1)[0].verdict, Verdict::kWorse);
  EXPECT_NEAR(compare({measured}, 1)[0].mean_difference, -1, 0.1);
}

TEST(Verdict, ASureDifferenceNeedNotMatter) {
  const ComparedMeasure compared = compare({pairs(10, 0.3, 0.05, 3, 0.5)}, 1)[0];
  EXPECT_EQ(compared.verdict, Verdict::kBetter);
  EXPECT_FALSE(compared.matters);
}

TEST(Verdict, FewerThanSixRecordingsAreTooFew) {
  EXPECT_EQ(compare({pairs(5, 1, 0.1, 3)}, 1)[0].verdict, Verdict::kTooFew);
  EXPECT_EQ(compare({pairs(6, 1, 0.1, 3)}, 1)[0].verdict, Verdict::kBetter);
}

TEST(Verdict, SmallNoiseInsideDeltaIsTheSameAndLargeNoiseShowsNothing) {
  EXPECT_EQ(compare({pairs(12, 0, 0.02, 4)}, 1)[0].verdict, Verdict::kSame);
  EXPECT_EQ(compare({pairs(12, 0, 2.0, 4)}, 1)[0].verdict, Verdict::kNoDifferenceShown);
}

TEST(Verdict, IdenticalOutputsAreSaidToBeThat) {
  MeasuredPairs measured = pairs(10, 0, 0, 3);
  measured.outputs_identical = true;
  EXPECT_EQ(text_of(compare({measured}, 1)[0]), "identical outputs");
}

TEST(Verdict, MeasuresThatAreNotNumbersAreLeftOutAndCounted) {
  MeasuredPairs measured = pairs(8, 1, 0.1, 3);
  measured.pairs[2].arm = std::numeric_limits<double>::quiet_NaN();
  measured.pairs[5].baseline = std::numeric_limits<double>::infinity();
  const ComparedMeasure compared = compare({measured}, 1)[0];
  EXPECT_EQ(compared.excluded, (std::vector<std::string>{"pit-2", "pit-5"}));
  EXPECT_EQ(compared.differences.size(), 6U);
  EXPECT_EQ(compared.verdict, Verdict::kBetter);
  for (Pair& pair : measured.pairs) pair.arm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(compare({measured}, 1)[0].verdict, Verdict::kTooFew);
}

TEST(Verdict, SeveralMeasuresMakeEachHarderToBelieve) {
  // With six recordings the smallest chance is 2 / 64: believed alone, not beside a second.
  const MeasuredPairs clear = pairs(6, 1, 0.1, 3), noise = pairs(6, 0, 1, 9);
  EXPECT_EQ(compare({clear}, 1)[0].verdict, Verdict::kBetter);
  EXPECT_EQ(compare({clear, noise}, 1)[0].verdict, Verdict::kNoDifferenceShown);
}

TEST(Verdict, EqualArmsAreSeldomCalledDifferent) {
  int alarms = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    const Verdict verdict = compare({pairs(10, 0, 1, 100 + trial)}, trial)[0].verdict;
    alarms += verdict == Verdict::kBetter || verdict == Verdict::kWorse ? 1 : 0;
  }
  EXPECT_LE(alarms, 17);
}

TEST(Verdict, APlantedDifferenceOfTwiceDeltaIsFound) {
  int found = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial)
    found += compare({pairs(12, 0.2, 0.2, 500 + trial)}, trial)[0].verdict == Verdict::kBetter;
  EXPECT_GE(found, 160);
}

}  // namespace
}  // namespace stope
