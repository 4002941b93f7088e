#include "framework/compare/report/finding.hpp"

#include <gtest/gtest.h>

#include "made_comparison.hpp"

namespace stope::report {
namespace {

/// A comparison by apls alone whose verdict on the second arm is given.
struct Said {
  Comparison comparison;
  ArmVerdicts arm;

  Said(std::initializer_list<ComparedMeasure> measures, std::size_t recordings = 10)
      : comparison(made::comparison_in("", {2, recordings, 1, 0.3, "one", false})),
        arm{1, measures, {}} {
    comparison.metrics.resize(measures.size(), comparison.metrics.front());
    for (std::size_t i = 0; i < measures.size(); ++i)
      comparison.metrics[i].name = arm.measures[i].measure;
  }
  std::string text() const { return finding_text(comparison, arm); }
};

ComparedMeasure measure(const std::string& name, Verdict verdict, Weight weight, double mean,
                        Interval interval, std::size_t recordings = 10) {
  ComparedMeasure made;
  made.measure = name;
  made.verdict = verdict;
  made.weight = weight;
  made.smallest_that_matters = 0.02;
  made.mean_difference = mean;
  made.interval = interval;
  made.differences.assign(recordings, mean);
  made.differences.front() += 0.001;
  made.tests = 1;
  return made;
}

TEST(Finding, SaysABetterArmByHowMuchAndOnWhat) {
  EXPECT_EQ(
      Said({measure("apls", Verdict::kBetter, Weight::kMatters, 0.344, {0.281, 0.407})}).text(),
      "voronoi is better than watershed in apls by 0.34 [0.28, 0.41] on 10 recordings, and it "
      "matters.");
}

TEST(Finding, SaysAWorseArmByADistance) {
  EXPECT_EQ(
      Said({measure("apls", Verdict::kWorse, Weight::kUnclear, -0.34, {-0.41, -0.28})}).text(),
      "voronoi is worse than watershed in apls by 0.34 [0.28, 0.41] on 10 recordings, perhaps by "
      "too "
      "little to matter.");
}

TEST(Finding, BeginsWithWhatMattersAndJoinsWhatIsSaidAlike) {
  EXPECT_EQ(
      Said({measure("a", Verdict::kNoDifferenceShown, {}, 0.1, {-1, 1}),
            measure("b", Verdict::kSame, {}, 0, {-0.01, 0.01}),
            measure("c", Verdict::kBetter, Weight::kMatters, 4.2, {3, 5}),
            measure("d", Verdict::kNoDifferenceShown, {}, 0.1, {-1, 1}, 8)})
          .text(),
      "voronoi is better than watershed in c by 4.2 [3.0, 5.0] on 8 to 10 of 10 recordings, and it "
      "matters; the same in b (within 0.02 m); no difference shown in a and d.");
}

TEST(Finding, SaysWhenNothingCouldHaveBeenShown) {
  ComparedMeasure one = measure("a", Verdict::kNoDifferenceShown, {}, 0.1, {0.05, 0.15}, 6);
  one.tests = 3;
  EXPECT_EQ(Said({one}, 6).text(),
            "No difference shown between voronoi and watershed in a on 6 recordings. 6 recordings "
            "cannot show any difference beside 3 tests, however clear: it takes 7.");
}

TEST(Finding, SaysOfTooFewAndOfIdenticalWhatTheyAre) {
  ComparedMeasure few = measure("a", Verdict::kTooFew, {}, 0.1, {0, 1}, 4);
  few.tests = 0;
  EXPECT_EQ(Said({few}, 4).text(),
            "6 recordings are needed to say anything of voronoi and watershed in a: there are 4 "
            "recordings.");
  ComparedMeasure single = measure("a", Verdict::kTooFew, {}, 0.1, {0, 1}, 1);
  single.tests = 0;
  EXPECT_EQ(Said({single}, 1).text(),
            "6 recordings are needed to say anything of voronoi and watershed in a: there is 1 "
            "recording.");
  EXPECT_EQ(Said({measure("a", Verdict::kIdentical, {}, 0, {0, 0})}).text(),
            "voronoi and watershed left the same bytes wherever both were run: there is nothing to "
            "compare.");
}

TEST(Finding, DoesNotHideThatTheWinnerFailed) {
  Said said({measure("apls", Verdict::kBetter, Weight::kMatters, 0.46, {0.41, 0.52}, 6)});
  for (const std::size_t recording : {1U, 4U, 5U, 9U})
    said.comparison.cell(1, recording, 0).status = CellStatus::kFailed;
  EXPECT_EQ(said.text(),
            "voronoi is better than watershed in apls by 0.46 [0.41, 0.52] on 6 of 10 recordings, "
            "and it matters; voronoi failed on 4.");
}

TEST(Finding, HasAWordForNoFigureAtAll) {
  ComparedMeasure none = measure("apls", Verdict::kNoFigure, {}, 0, {0, 0});
  none.differences.clear();
  none.tests = 0;
  EXPECT_EQ(Said({none}).text(),
            "There is no usable figure of voronoi beside watershed in apls on any of 10 "
            "recordings.");
}

TEST(Finding, SaysOfFiguresThatAreEqualThatTheyAre) {
  ComparedMeasure equal = measure("apls", Verdict::kSame, {}, 0, {0, 0});
  equal.differences.assign(10, 0.0);
  EXPECT_EQ(Said({equal}).text(),
            "voronoi and watershed are the same in apls (equal to the last bit) on 10 recordings.");
}

TEST(Finding, GivesNoIntervalOfFewerThanSix) {
  EXPECT_EQ(difference_text(measure("a", Verdict::kTooFew, {}, -0.468, {-0.468, -0.468}, 1)),
            "−0.468 [–]");
  EXPECT_EQ(difference_text(measure("a", Verdict::kBetter, {}, 0.344, {0.281, 0.407}, 6)),
            "0.34 [0.28, 0.41]");
}

TEST(Finding, WritesAsManyPlacesAsTheIntervalIsWorth) {
  EXPECT_EQ(to_width(0.34567, 0.13), "0.35");
  EXPECT_EQ(to_width(1234.4, 210), "1234");
  EXPECT_EQ(to_width(-0.0001, 0.02), "0.000");
  EXPECT_EQ(to_width(2.5, 0), "2.5");
  EXPECT_EQ(chance_text(0.00098), "< 0.001");
  EXPECT_EQ(chance_text(0.0469), "0.047");
}

}  // namespace
}  // namespace stope::report
