#include <gtest/gtest.h>

#include "plugins/topology/regions/room_divider.hpp"
#include "plugins/topology/regions/segment_by_growth.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/topology/random_changes.hpp"
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

TEST(RegionStages, WithAMemoryOfTheGridBeforeGiveTheSame) {
  for (const StageEntry* entry : region_stages()) {
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
        StageHarness stage = for_rooms(entry);
        stage.set("allow_empty", true).set("min_region_area", seed % 3 == 0 ? 0.0 : 1.0);
        if (entry == stope_stage_RegionGrowing()) stage.set("max_radius", 2.0);
        if (seed % 2 == 0) stage.input("trajectory", trajectory);
        return stage;
      };
      // Asked for one output each: whoever is asked twice has forgotten the grid before.
      StageHarness with_map = stage_for(), with_roads = stage_for();
      for (std::uint64_t item = 0; item < 12; ++item) {
        if (item > 0) change(grid, random, item - 1);
        // The first that has a window is computed as a whole; one that refers to another item too.
        if (item == 7) grid.changed->since = 2;
        with_map.input("grid", grid).context().item = item;
        with_roads.input("grid", grid).context().item = item;
        const auto map = with_map.apply<RegionMap>(1);
        const auto roads = with_roads.apply<RoadGraph>(0);
        OccupancyGrid alone = grid;
        alone.changed.reset();
        StageHarness forgetting = stage_for();
        forgetting.input("grid", alone);
        const auto expected = forgetting.apply<RegionMap>(1);
        const auto expected_roads = forgetting.apply<RoadGraph>(0);
        ASSERT_EQ(map.labels.cells.to_vector(), expected.labels.cells.to_vector())
            << "seed " << seed << ", item " << item;
        ASSERT_EQ(digest_of(map), digest_of(expected)) << "seed " << seed << ", item " << item;
        ASSERT_EQ(digest_of(roads), digest_of(expected_roads))
            << "seed " << seed << ", item " << item;
      }
    }
  }
}

/// Walls with doors, heaps and rough faces: maps in which all kinds of changes matter.
OccupancyGrid rooms_with_heaps(std::uint64_t seed) {
  OccupancyGrid grid = random_grid(220, 170, 0.97, 6, seed);
  Random random(seed + 100);
  for (std::int32_t row = 0; row < 170; ++row)
    for (std::int32_t column = 0; column < 220; ++column)
      if ((column % 55 < 3 && row % 44 > 8) || (row % 60 < 3 && column % 50 > 7))
        grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  grid.frame.resolution = 0.1;
  return grid;
}

TEST(RoomDivider, AfterChangesOfAllKindsIsAsIfItHadLookedAtAll) {
  ExtractionParams extraction;
  extraction.min_clearance = 0.1;
  extraction.min_obstacle_area = 0.4;
  extraction.simplify = 0.05;
  const RoomDivider::Rule rule{0.95, 0.85, 0.6, 0.5};
  std::size_t reused = 0, regions = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    OccupancyGrid grid = rooms_with_heaps(seed);
    Random random(seed);
    RoomDivider divider(extraction, rule, {0.1, 0.05, Network::kAll, 1.5});
    divider.full(grid, true);
    for (int i = 0; i < 5 * kChangeKinds; ++i) {
      const CellWindow window =
          change_at_random(grid, 30, static_cast<ChangeKind>(i % kChangeKinds), random);
      const RegionsAndRoads now = divider.update(grid, window);
      reused += divider.reused();
      regions += now.map.regions.size();
      RoomDivider fresh(extraction, rule, {0.1, 0.05, Network::kAll, 1.5});
      const RegionsAndRoads expected = fresh.full(grid, false);
      ASSERT_EQ(now.map.labels.cells.to_vector(), expected.map.labels.cells.to_vector())
          << "seed " << seed << ", " << i;
      ASSERT_EQ(digest_of(now.map), digest_of(expected.map)) << "seed " << seed << ", " << i;
      ASSERT_EQ(digest_of(now.roads), digest_of(expected.roads)) << "seed " << seed << ", " << i;
      ASSERT_EQ(now.dropped, expected.dropped);
      ASSERT_EQ(now.covered, expected.covered);
    }
  }
  // Most of it was remembered, or nothing would have been tested.
  EXPECT_GT(reused, regions / 2);
}

TEST(RegionGrowing, AfterChangesOfAllKindsIsAsIfItHadGrownAll) {
  ExtractionParams extraction;
  extraction.min_clearance = 0.1;
  extraction.min_obstacle_area = 0.4;
  const RegionRoadsRule roads{0.1, 0.05, Network::kAll, 1.5};
  std::size_t reused = 0, grown = 0, remembered = 0, regions = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    // Open places and none, gaps that are left and none, merging and none.
    GrowingParams params{0.8,
                         seed % 2 == 0 ? 1.5 : 4.0,
                         1,
                         0.3,
                         0.05,
                         seed % 5 == 0 ? 0.3 : 3.0,
                         seed % 4 == 1 ? 0.0 : 0.8,
                         30,
                         0.2,
                         0.95,
                         seed % 3 == 0 ? 0.0 : 1.0,
                         false};
    OccupancyGrid grid =
        seed % 3 == 2 ? random_grid(230, 180, 0.995, 3, seed) : rooms_with_heaps(seed);
    grid.frame.resolution = 0.1;
    Random random(seed);
    Ground ground(grid, extraction);
    GrowthMemory memory;
    std::vector<CellIndex> visited;
    segment_by_growth(ground, visited, params, roads, memory);
    for (int i = 0; i < 4 * kChangeKinds; ++i) {
      const CellWindow window =
          change_at_random(grid, 30, static_cast<ChangeKind>(i % kChangeKinds), random);
      if (seed % 4 >= 2) {  // the trajectory grows, and sometimes loses its start
        visited.push_back(ground.index(static_cast<std::int32_t>(random.below(220)),
                                       static_cast<std::int32_t>(random.below(170))));
        if (i % 7 == 6) visited.erase(visited.begin(), visited.begin() + 3);
      }
      GroundChange change(ground.width(), ground.height());
      ASSERT_TRUE(ground.update(grid, window, change));
      const RegionsAndRoads now =
          segment_by_growth(ground, visited, params, roads, memory, &change);
      reused += memory.reused, grown += memory.grown->list.size();
      remembered += memory.memo.reused, regions += now.map.regions.size();
      const RegionsAndRoads expected =
          segment_by_growth(Ground(grid, extraction), visited, params, roads, Random(1));
      ASSERT_EQ(now.map.labels.cells.to_vector(), expected.map.labels.cells.to_vector())
          << "seed " << seed << ", " << i;
      ASSERT_EQ(digest_of(now.map), digest_of(expected.map)) << "seed " << seed << ", " << i;
      ASSERT_EQ(digest_of(now.roads), digest_of(expected.roads)) << "seed " << seed << ", " << i;
      ASSERT_EQ(now.dropped, expected.dropped);
      ASSERT_EQ(now.covered, expected.covered);
    }
  }
  // Most of it was remembered, or nothing would have been tested.
  EXPECT_GT(reused, grown / 2);
  EXPECT_GT(remembered, regions / 2);
}

/// The cell that a cell's way uphill ends at, step by step as Basins says.
CellIndex climb(const Ground& ground, CellIndex cell) {
  while (true) {
    CellIndex best = cell;
    for (const CellIndex step : neighbour_steps(ground.stride())) {
      const CellIndex there = cell + step;
      if (is_uphill(ground, there, cell) &&
          (best == cell || ground.squared(there) > ground.squared(best)))
        best = there;
    }
    if (best == cell) return cell;
    cell = best;
  }
}

TEST(Basins, AreTheCellsFromWhichGoingUphillEndsAtOnePeak) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    ExtractionParams params;
    params.min_obstacle_area = 0;
    const Ground ground(random_grid(90, 150, 0.8, 7, seed), params);
    const Basins basins(ground);
    for (std::int32_t row = 0; row < ground.height(); ++row)
      for (std::int32_t column = 0; column < ground.width(); ++column) {
        const CellIndex cell = ground.index(column, row);
        const std::int32_t basin = basins.cells()[cell];
        ASSERT_EQ(basin != 0, ground.free(cell));
        if (basin != 0) {
          ASSERT_EQ(basins.peaks()[static_cast<std::size_t>(basin)], climb(ground, cell));
        }
      }
  }
}

TEST(RegionGrowing, AChangeInAWideYardIsFeltNearbyOnly) {
  std::size_t reused = 0, grown = 0;
  for (std::int32_t place = 0; place < 6; ++place) {
    OccupancyGrid grid;
    grid.frame.width = grid.frame.height = 400;
    grid.frame.resolution = 0.1;
    grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
    const GrowingParams params{1.0, 2, 1, 0.3, 0.05, 3, 0.8, 30, 0.2, 0.95, 1, false};
    ExtractionParams extraction;
    extraction.min_obstacle_area = 0;
    Ground ground(grid, extraction);
    GrowthMemory memory;
    segment_by_growth(ground, {}, params, {}, memory);
    const CellWindow heap{30 + 50 * place, 40, 6, 6};
    for (std::int32_t y = heap.row; y < heap.row + heap.height; ++y)
      for (std::int32_t x = heap.column; x < heap.column + heap.width; ++x)
        grid.cells[grid.frame.place({x, y})] = OccupancyGrid::kOccupied;
    GroundChange change(ground.width(), ground.height());
    ASSERT_TRUE(ground.update(grid, heap, change));
    segment_by_growth(ground, {}, params, {}, memory, &change);
    reused += memory.reused;
    grown += memory.grown->list.size();
  }
  EXPECT_GT(reused, grown * 8 / 10);
  EXPECT_LT(reused, grown);
}

TEST(RegionGrowing, UsesWhatGrewFarFromTheChangeAgain) {
  OccupancyGrid grid = random_grid(400, 300, 0.95, 10, 7);
  grid.frame.resolution = 0.1;
  GrowingParams params{1.2, 2, 1, 0.3, 0.05, 3, 0.8, 30, 0.2, 0.95, 1, false};
  ExtractionParams extraction;
  extraction.min_obstacle_area = 0.5;
  Ground ground(grid, extraction);
  GrowthMemory memory;
  segment_by_growth(ground, {}, params, {}, memory);
  EXPECT_EQ(memory.reused, 0U);
  for (std::int32_t y = 100; y < 120; ++y)
    for (std::int32_t x = 50; x < 70; ++x)
      grid.cells[grid.frame.place({x, y})] = OccupancyGrid::kOccupied;
  GroundChange change(ground.width(), ground.height());
  ASSERT_TRUE(ground.update(grid, {50, 100, 20, 20}, change));
  const auto result = segment_by_growth(ground, {}, params, {}, memory, &change);
  EXPECT_GT(memory.reused, memory.grown->list.size() * 7 / 10);
  EXPECT_LT(memory.reused, memory.grown->list.size());
  EXPECT_GT(memory.memo.reused, result.map.regions.size() * 7 / 10);
}

}  // namespace
}  // namespace stope::topology
