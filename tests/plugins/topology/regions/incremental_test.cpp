#include <gtest/gtest.h>

#include "plugins/topology/regions/segment_by_growth.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

/// Changes a random window of the grid and tells of it.
void change(OccupancyGrid& grid, Random& random, std::uint64_t since) {
  ChangedWindow window;
  window.width = 1 + static_cast<std::int32_t>(random.below(25));
  window.height = 1 + static_cast<std::int32_t>(random.below(25));
  const auto room = [&](std::int32_t whole, std::int32_t part) {
    return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(whole - part)));
  };
  window.column = room(grid.frame.width, window.width);
  window.row = room(grid.frame.height, window.height);
  window.since = since;
  const double free = random.uniform(0.3, 1.0);
  const int block = 1 + static_cast<int>(random.below(5));
  for (std::int32_t y = 0; y < window.height; ++y)
    for (std::int32_t x = 0; x < window.width; ++x)
      grid.cells[grid.frame.place({window.column + x, window.row + y})] =
          Random(mix_seed(since, static_cast<std::uint64_t>(x / block * 100 + y / block)))
                      .uniform() < free
              ? OccupancyGrid::kFree
              : OccupancyGrid::kOccupied;
  grid.changed = window;
}

TEST(RegionGrowing, WithAMemoryOfTheGridBeforeGivesTheSame) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    OccupancyGrid grid = random_grid(180, 140, 0.9, 9, seed);
    grid.frame.resolution = 0.1;
    Trajectory trajectory;
    for (int i = 0; i < 40; ++i) {
      trajectory.poses.push_back({i, {}});
      trajectory.poses.back().T_map_lidar.translation = {0.4 * i, 5 + 0.1 * i, 0};
    }
    const auto stage_for = [&] {
      StageHarness stage = for_rooms(stope_stage_RegionGrowing());
      stage.set("allow_empty", true).set("max_radius", 2.0);
      if (seed % 2 == 0) stage.input("trajectory", trajectory);
      return stage;
    };
    StageHarness remembering = stage_for();
    for (std::uint64_t item = 0; item < 12; ++item) {
      if (item > 0) change(grid, random, item - 1);
      remembering.context().item = item;
      remembering.input("grid", grid);
      const auto map = remembering.apply<RegionMap>(1);
      OccupancyGrid alone = grid;
      alone.changed.reset();
      StageHarness forgetting = stage_for();
      forgetting.input("grid", alone);
      const auto expected = forgetting.apply<RegionMap>(1);
      ASSERT_EQ(map.labels.cells, expected.labels.cells) << "seed " << seed << ", item " << item;
      ASSERT_EQ(digest_of(map).low, digest_of(expected).low);
    }
  }
}

TEST(RegionGrowing, UsesWhatGrewFarFromTheChangeAgain) {
  OccupancyGrid grid = random_grid(400, 300, 0.95, 10, 7);
  grid.frame.resolution = 0.1;
  GrowingParams params{1.2, 2, 1, 0.3, 0.05, 3, 0.8, 30, 0.2, 0.95, false};
  ExtractionParams extraction;
  extraction.min_obstacle_area = 0.5;
  GrowthMemory memory;
  const auto segment = [&] {
    return segment_by_growth(std::make_unique<Ground>(grid, extraction), {}, params, {}, Random(1),
                             never_stop, &memory);
  };
  segment();
  EXPECT_EQ(memory.reused, 0U);
  for (std::int32_t y = 100; y < 120; ++y)
    for (std::int32_t x = 50; x < 70; ++x)
      grid.cells[grid.frame.place({x, y})] = OccupancyGrid::kOccupied;
  segment();
  EXPECT_GT(memory.reused, memory.regions.size() * 7 / 10);
  EXPECT_LT(memory.reused, memory.regions.size());
}

}  // namespace
}  // namespace stope::topology
