#include "plugins/metric/region_scores.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plugins/metric/labelled_rooms.hpp"
#include "stope/stope.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_RegionSegmentation();

namespace stope::metric {
namespace {

using Labels = std::vector<std::int32_t>;
using stope::testing::error_of;
using stope::testing::StageHarness;

TEST(RegionScores, OfTheRoomsThemselvesAreOne) {
  const Labels rooms{1, 1, 1, 2, 2, 0, 3};
  const RegionScores s = score_regions(rooms, rooms);
  EXPECT_EQ(s.rooms, 3U);
  EXPECT_EQ(s.regions, 3U);
  for (const double value : {s.recall, s.precision, s.mcc, s.mcc_mean, s.mcc_pairs})
    EXPECT_DOUBLE_EQ(value, 1);
}

TEST(RegionScores, WorkedOutByHand) {
  // Room 1 has 4 cells, room 2 has 6; region 7 holds 3 of room 1, region 8 the other and 5 of room
  // 2, whose last cell has none. The cell without a room is not counted.
  const Labels rooms{1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 0};
  const Labels regions{7, 7, 7, 8, 8, 8, 8, 8, 8, 0, 7};
  const RegionScores s = score_regions(rooms, regions);
  EXPECT_EQ(s.cells, 10U);
  EXPECT_DOUBLE_EQ(s.recall, (3.0 / 4 + 5.0 / 6) / 2);
  EXPECT_DOUBLE_EQ(s.precision, (3.0 / 3 + 5.0 / 6) / 2);
  // Room 1 and region 7: TP 3, FP 0, FN 1, TN 6; room 2 and region 8: TP 5, FP 1, FN 1, TN 3.
  const double first = 18 / std::sqrt(3.0 * 4 * 6 * 7),
               second = (15 - 1) / std::sqrt(6.0 * 6 * 4 * 4);
  EXPECT_NEAR(s.mcc_mean, (first + second) / 2, 1e-12);
  EXPECT_NEAR(s.mcc, (8 * 9 - 1 * 2) / std::sqrt(9.0 * 10 * 10 * 11), 1e-12);
}

TEST(RegionScores, OfPairsEqualACountOfAllPairs) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    Labels rooms, regions;
    for (int i = 0; i < 60; ++i) {
      rooms.push_back(static_cast<std::int32_t>(random.below(4)));
      regions.push_back(static_cast<std::int32_t>(random.below(5)));
    }
    double tp = 0, fp = 0, fn = 0, tn = 0;
    for (std::size_t i = 0; i < 60; ++i)
      for (std::size_t j = i + 1; j < 60; ++j) {
        if (rooms[i] == 0 || rooms[j] == 0) continue;
        const bool room = rooms[i] == rooms[j];
        const bool region = regions[i] != 0 && regions[i] == regions[j];
        (room ? region ? tp : fn : region ? fp : tn) += 1;
      }
    EXPECT_NEAR(score_regions(rooms, regions).mcc_pairs,
                (tp * tn - fp * fn) / std::sqrt((tp + fp) * (tp + fn) * (tn + fp) * (tn + fn)),
                1e-12);
  }
}

TEST(RegionScores, WithoutRoomsOrOfAnotherMapAreRefused) {
  EXPECT_NE(error_of([] {
              score_regions(Labels{0, 0}, Labels{1, 1});
            }).find("no true room"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              score_regions(Labels{1}, Labels{1, 1});
            }).find("same map"),
            std::string::npos);
}

TEST(LabelledRooms, AreTheWhitePartsWithoutSpecks) {
  const std::vector<std::uint8_t> grey{255, 255, 0,   255,  // lowest row
                                       255, 0,   255, 0,    //
                                       0,   255, 255, 255};
  const LabelledRooms rooms = label_rooms(4, 3, grey, 250, 2);
  EXPECT_EQ(rooms.rooms, 2);
  EXPECT_EQ(rooms.cells, (Labels{1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 2, 2}));
}

RegionMap map_of(std::int32_t width, std::int32_t height, Labels labels) {
  RegionMap map;
  map.labels.frame.width = width;
  map.labels.frame.height = height;
  map.labels.cells = std::move(labels);
  return map;
}

TEST(RegionSegmentation, AgainstAnotherRegionMap) {
  StageHarness stage(stope_stage_RegionSegmentation());
  stage.input("regions", map_of(4, 1, {1, 1, 2, 2})).input("truth", map_of(4, 1, {5, 5, 5, 3}));
  const auto measures = stage.apply<Measures>();
  ASSERT_GE(measures.names.size(), 5U);
  EXPECT_EQ(measures.names[0], "region_recall");
  EXPECT_DOUBLE_EQ(measures.values[0], (2.0 / 3 + 1) / 2);
  EXPECT_EQ(measures.names[1], "region_precision");
  EXPECT_DOUBLE_EQ(measures.values[1], (1 + 0.5) / 2);
  stage.input("truth", map_of(2, 2, {1, 1, 2, 2}));
  EXPECT_NE(error_of([&] { stage.apply<Measures>(); }).find("2 x 2"), std::string::npos);
}

TEST(RegionSegmentation, NeedsOneTruth) {
  StageHarness stage(stope_stage_RegionSegmentation());
  stage.input("regions", map_of(2, 1, {1, 2}));
  EXPECT_NE(error_of([&] { stage.apply<Measures>(); }).find("picture"), std::string::npos);
  stage.set("picture", std::string("/nowhere/rooms.png"));
  EXPECT_NE(error_of([&] { stage.apply<Measures>(); }).find("/nowhere/rooms.png"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::metric
