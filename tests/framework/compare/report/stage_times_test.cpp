#include "framework/compare/report/stage_times.hpp"

#include <gtest/gtest.h>

#include "made_comparison.hpp"

namespace stope::report {
namespace {

TEST(Spread, IsLeastMedianMost) {
  const Spread odd = spread_of({3, 1, 2}), even = spread_of({4, 1, 2, 3});
  EXPECT_EQ(odd.least, 1);
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(odd.greatest, 3);
  EXPECT_EQ(even.median, 2.5);
  EXPECT_EQ(spread_of({}).count, 0U);
}

TEST(StageTimes, AreTakenOverTheCellsOfAnArm) {
  const auto rows = stage_times(made::comparison_in("", {3, 5, 2, 0.3, "times", false}));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].name, "roads");
  EXPECT_EQ(rows[1].arms[2]->use, "topology/skeleton");
  EXPECT_EQ(rows[1].arms[2]->seconds.count, 10U);
  EXPECT_NEAR(rows[1].arms[2]->seconds.median, 0.155, 0.01);
  EXPECT_EQ(rows[0].arms[0]->shared, 10U);
  EXPECT_EQ(rows[0].arms[0]->ran, 0U);
}

TEST(StageTimes, PutWhatOnlyOneArmHasWhereItStandsThere) {
  Comparison comparison = made::comparison_in("", {2, 1, 1, 0.3, "times", false});
  auto& stages = comparison.cell(1, 0, 0).stages;
  stages.insert(stages.begin() + 1, CellStage{"smooth", "map/smooth", StageFate::kRan, -1, 0});
  const auto rows = stage_times(comparison);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].name, "smooth");
  EXPECT_FALSE(rows[1].arms[0].has_value());
  EXPECT_EQ(rows[1].arms[1]->seconds.count, 0U) << "its time is not known";
}

TEST(StageTimes, TimingsTakenInTurnsShowTheRatioOfPairs) {
  Comparison comparison = made::comparison_in("", {2, 1, 1, 0.3, "times", false});
  comparison.timings = {{1, 0, 0, {1.0, 2.0, 4.0}, {0.5, 1.0, 1.0}, {}}};
  const std::string html = stage_times_html(comparison);
  EXPECT_NE(html.find("Taken in turns"), std::string::npos);
  EXPECT_NE(html.find("0.50 <small>0.25 – 0.50</small>"), std::string::npos);
}

}  // namespace
}  // namespace stope::report
