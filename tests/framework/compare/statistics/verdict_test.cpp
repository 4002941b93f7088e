#include "framework/compare/statistics/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
  EXPECT_EQ(compared.weight, Weight::kNegligible);
  EXPECT_EQ(text_of(compared), "better, but by too little to matter");
  const ComparedMeasure unclear = compare({pairs(10, 0.5, 0.1, 3, 0.5)}, 1)[0];
  EXPECT_EQ(text_of(unclear), "better, perhaps by too little to matter");
}

TEST(Verdict, SaysNothingOfWeightWhereNoDeltaIsStated) {
  EXPECT_EQ(text_of(compare({pairs(10, 1, 0.1, 3, 0)}, 1)[0]), "better");
  EXPECT_FALSE(compare({pairs(10, 1, 0.1, 3, 0)}, 1)[0].matters());
  EXPECT_EQ(compare({pairs(10, 0, 0, 3, 0)}, 1)[0].verdict, Verdict::kNoDifferenceShown);
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
  const ComparedMeasure beside = compare({clear, noise}, 1)[0];
  EXPECT_EQ(beside.verdict, Verdict::kNoDifferenceShown);
  EXPECT_FALSE(beside.can_show());
  EXPECT_EQ(recordings_needed(beside.tests), 7U);
  EXPECT_EQ(compare({pairs(7, 1, 0.1, 3), pairs(7, 0, 1, 9)}, 1)[0].verdict, Verdict::kBetter);
}

TEST(Verdict, RecordingsNeededAreThoseOfUnanimousSigns) {
  const std::vector<std::pair<std::size_t, std::size_t>> needed{
      {1, 6}, {2, 7}, {3, 7}, {4, 8}, {6, 8}, {7, 9}, {25, 10}, {26, 11}, {102, 12}};
  for (const auto& [tests, recordings] : needed)
    EXPECT_EQ(recordings_needed(tests), recordings) << tests;
}

TEST(Verdict, DoesNotDependOnThePlaceAmongOthers) {
  const MeasuredPairs one = pairs(10, 0.3, 0.4, 3), other = pairs(10, 0, 1, 9);
  const ComparedMeasure first = compare({one, other}, 1)[0], last = compare({other, one}, 1)[1];
  EXPECT_EQ(first.interval.low, last.interval.low);
  EXPECT_EQ(first.interval.high, last.interval.high);
  EXPECT_EQ(first.adjusted, last.adjusted);
}

// Comparisons of equal arms that call any of their measures different.
int false_alarms(int recordings, int measures, double (*noise)(Random&)) {
  int alarms = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    Random random(mix_seed(100, trial));
    std::vector<MeasuredPairs> all;
    for (int measure = 0; measure < measures; ++measure) {
      all.push_back({"measure", Direction::kHigher, 0.1, {}, false});
      for (int i = 0; i < recordings; ++i) {
        const double truth = random.uniform(5, 15);
        const double baseline = truth + noise(random), arm = truth + noise(random);
        all.back().pairs.push_back({"pit-" + std::to_string(i), baseline, arm});
      }
    }
    const std::vector<ComparedMeasure> compared = compare(all, trial);
    alarms += std::any_of(compared.begin(), compared.end(), [](const ComparedMeasure& one) {
      return one.verdict == Verdict::kBetter || one.verdict == Verdict::kWorse;
    });
  }
  return alarms;
}

TEST(Verdict, EqualArmsAreSeldomCalledDifferent) {
  const auto normal = [](Random& random) { return random.normal(); };
  const auto skewed = [](Random& random) { return std::exp(random.normal()); };
  EXPECT_LE(false_alarms(6, 1, normal), 17);
  EXPECT_LE(false_alarms(10, 1, normal), 17);
  EXPECT_LE(false_alarms(10, 4, normal), 17);
  EXPECT_LE(false_alarms(8, 3, skewed), 17);
}

TEST(Verdict, APlantedDifferenceOfTwiceDeltaIsFound) {
  int found = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial)
    found += compare({pairs(12, 0.2, 0.2, 500 + trial)}, trial)[0].verdict == Verdict::kBetter;
  EXPECT_GE(found, 160);
}

}  // namespace
}  // namespace stope
