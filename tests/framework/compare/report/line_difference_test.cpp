#include "framework/compare/report/line_difference.hpp"

#include <gtest/gtest.h>

#include "framework/compare/report/overlay.hpp"
#include "stope/random.hpp"

namespace stope::report {
namespace {

TEST(LinesOfGeojson, AreThereOnceAndJoinedBetweenJunctions) {
  // A road of two links in both directions, and one that branches off in its middle.
  const Lines lines = lines_of_geojson(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [0, 0]}},
    {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], [5, 0]]}},
    {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[5, 0], [0, 0]]}},
    {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[5, 0], [10, 0, 3]]}},
    {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries":
      [{"type": "LineString", "coordinates": [[10, 0], [10, 9]]}]}},
    {"type": "Feature", "geometry": {"type": "MultiLineString", "coordinates": [[[10, 0], [20, 0]]]}}
  ]})");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_DOUBLE_EQ(length_of(lines), 10 + 9 + 10);
  EXPECT_EQ(lines[0].size(), 3U) << "0, 5 and 10 in one line";
}

TEST(LinesOfGeojson, KeepRings) {
  const Lines lines = lines_of_geojson(
      R"({"type": "LineString", "coordinates": [[0, 0], [4, 0], [4, 3], [0, 0]]})");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_DOUBLE_EQ(length_of(lines), 12);
}

TEST(LinesOfGeojson, OfWhatIsNoneAreNone) {
  for (const char* text :
       {"", "{", "[]", "7", "{\"features\": 3}", "{\"type\": 5}",
        "{\"features\": [null, {\"geometry\": null}]}",
        "{\"type\": \"LineString\", \"coordinates\": [[1, \"x\"], [2]]}",
        "{\"type\": \"GeometryCollection\", \"geometries\": [{\"type\": \"LineString\"}]}"})
    EXPECT_TRUE(lines_of_geojson(text).empty()) << text;
}

TEST(LineDifference, FindsABranchThatOneOfThemHas) {
  const Lines first{{{0, 0}, {100, 0}}}, second{{{0, 0.5}, {100, 0.5}}, {{50, 0}, {50, 40}}};
  const LineDifference difference = line_difference(first, second, 1);
  EXPECT_TRUE(difference.only_first.empty());
  EXPECT_DOUBLE_EQ(length_of(difference.common), 100);
  EXPECT_NEAR(length_of(difference.only_second), 39, 0.5) << "all but the metre beside the other";
}

TEST(LineDifference, CutsALineWhereItLeavesTheOther) {
  const Lines first{{{0, 0}, {60, 0}}}, second{{{0, 0}, {30, 0}, {60, 30}}};
  const LineDifference difference = line_difference(first, second, 2);
  EXPECT_NEAR(length_of(difference.common), 30 + 2 * std::sqrt(2.0), 1);
  EXPECT_NEAR(length_of(difference.common) + length_of(difference.only_first), 60, 1e-9);
}

TEST(LineDifference, IsWhatLookingAtEveryPieceGives) {
  Random random(3);
  const auto scribble = [&] {
    Lines lines(3);
    for (auto& line : lines)
      for (int i = 0; i < 6; ++i) line.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9));
    return lines;
  };
  for (int trial = 0; trial < 30; ++trial) {
    const Lines first = scribble(), second = scribble();
    const double tolerance = random.uniform(0.05, 2);
    const auto distance = [&](const Vector2& point) {
      double least = 1e9;
      for (const auto& line : second)
        for (std::size_t i = 1; i < line.size(); ++i) {
          const Vector2 along = line[i] - line[i - 1];
          const double part =
              std::clamp((point - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
          least = std::min(least, (line[i - 1] + part * along - point).norm());
        }
      return least;
    };
    const LineDifference difference = line_difference(first, second, tolerance);
    // Cuts lie within a quarter of a tolerance of where they should.
    const double slack = tolerance / 4 + 1e-9;
    for (const auto& line : difference.common)
      for (const Vector2& point : line) EXPECT_LE(distance(point), tolerance + slack);
    for (const auto& line : difference.only_first)
      for (const Vector2& point : line) EXPECT_GE(distance(point), tolerance - slack);
    EXPECT_NEAR(length_of(difference.common) + length_of(difference.only_first), length_of(first),
                1e-6);
  }
}

TEST(Sheet, HoldsEverythingWithAMargin) {
  const Sheet sheet = sheet_for({{{{0, 0}, {400, 100}}}, {{{50, -20}, {60, 60}}}});
  EXPECT_LT(sheet.extent.low.x(), 0);
  EXPECT_GT(sheet.extent.high.x(), 400);
  EXPECT_DOUBLE_EQ(sheet.tolerance, 0.5) << "a 500th of 418 m, round";
  EXPECT_TRUE(sheet_for({{}}).extent.empty());
  EXPECT_EQ(overlay_of({{{0, 0}, {400, 0}}}, {{{0, 0}, {400, 0}}}, sheet).only_first, "");
}

}  // namespace
}  // namespace stope::report
