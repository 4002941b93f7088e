#include "plugins/topology/road_updater.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "stope/digest.hpp"
#include "stope/error.hpp"
#include "tests/plugins/stage_harness.hpp"
#include "tests/plugins/topology/random_changes.hpp"
#include "tests/plugins/topology/test_grids.hpp"

extern "C" const stope::StageEntry* stope_stage_Watershed();
extern "C" const stope::StageEntry* stope_stage_Voronoi();
extern "C" const stope::StageEntry* stope_stage_Skeleton();

namespace stope::topology {
namespace {

using Kind = ExtractionMethod::Kind;

struct Case {
  const char* name;
  ExtractionMethod method;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* name, Kind kind, double clearance, double area) -> Case& {
    ExtractionMethod method;
    method.kind = kind;
    method.params.min_clearance = clearance;
    method.params.min_obstacle_area = area;
    method.branches.min_branch = 8;
    all.push_back({name, method});
    return all.back();
  };
  add("watershed", Kind::kWatershed, 0, 0);
  add("watershed_of_large_obstacles", Kind::kWatershed, 2, 30);
  add("watershed_of_parts", Kind::kWatershedParts, 1, 10);
  add("voronoi", Kind::kVoronoi, 0, 0);
  add("voronoi_of_large_obstacles", Kind::kVoronoi, 2, 30);
  add("voronoi_of_huge_obstacles", Kind::kVoronoi, 1, 400);
  add("skeleton_by_residual", Kind::kSkeleton, 1, 10).method.params.medial_lines = true;
  add("skeleton_by_lambda", Kind::kSkeleton, 1, 10).method.skeleton = {
      SkeletonParams::Pruning::kLambda, 1.0, 6.0};
  return all;
}

OccupancyGrid noise_grid(std::int32_t side, double limit, std::uint64_t seed) {
  return grid_where(side, side, 1.0, [&](double x, double y) {
    return roughness(x, y, 1.0 / 24, seed) + 0.5 * roughness(x, y, 1.0 / 7, seed + 1) > limit;
  });
}

std::string text_of(const RoadGraph& roads) {
  std::ostringstream text;
  for (const RoadEdge& edge : roads.edges) {
    const auto line = roads.polyline(edge);
    text << '\n' << edge.from << " to " << edge.to << ':';
    for (const RoadVertex& v : {line.front(), line[line.size() / 2], line.back()})
      text << " (" << v.x << ' ' << v.y << ' ' << v.clearance << ')';
  }
  return text.str();
}

class RoadUpdates : public ::testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(AllMethods, RoadUpdates, ::testing::Range<std::size_t>(0, 8),
                         [](const auto& info) { return cases()[info.param].name; });

void expect_equal_after_changes(const ExtractionMethod& method, OccupancyGrid grid, int changes,
                                std::int32_t largest, std::uint64_t seed) {
  Random random(seed);
  RoadUpdater updater(method);
  ASSERT_EQ(digest_of(updater.full(grid)), digest_of(extract_roads(grid, method)));
  for (int i = 0; i < changes; ++i) {
    const auto side = static_cast<std::int32_t>(random.uniform(2.0, largest));
    const auto kind = static_cast<ChangeKind>(random.uniform(0.0, kChangeKinds - 1e-9));
    const CellWindow window = change_at_random(grid, side, kind, random);
    const RoadGraph updated = updater.update(grid, window);
    const RoadGraph whole = extract_roads(grid, method);
    ASSERT_EQ(digest_of(updated), digest_of(whole))
        << "seed " << seed << ", change " << i << " of kind " << static_cast<int>(kind)
        << " at column " << window.column << ", row " << window.row << ", side " << side
        << "\nupdated:" << text_of(updated) << "\nwhole:" << text_of(whole);
  }
}

TEST_P(RoadUpdates, EqualTheWholeOnSmoothMaps) {
  for (const std::uint64_t seed : {1U, 2U, 3U})
    expect_equal_after_changes(cases()[GetParam()].method, noise_grid(160, -0.15, seed), 25, 40,
                               seed);
}

TEST_P(RoadUpdates, EqualTheWholeOnMapsOfBlocks) {
  for (const std::uint64_t seed : {4U, 5U, 6U})
    expect_equal_after_changes(cases()[GetParam()].method,
                               random_grid(120, 90, seed == 4 ? 0.6 : 0.8, 5, seed), 25, 30, seed);
}

TEST_P(RoadUpdates, EqualTheWholeOnMapsOfSpeckles) {
  for (const std::uint64_t seed : {7U, 8U, 9U})
    expect_equal_after_changes(cases()[GetParam()].method, random_grid(60, 80, 0.7, 1, seed), 25,
                               20, seed);
}

/// Free between the turns of a spiral wall: places that face each other are far apart along it.
OccupancyGrid spiral_grid(std::int32_t side, double pitch) {
  return grid_where(side, side, 1.0, [=](double x, double y) {
    const double u = x - side / 2.0, v = y - side / 2.0;
    const double turns = std::hypot(u, v) / pitch - std::atan2(v, u) / 6.283185307179586;
    return turns - std::floor(turns) > 0.25;
  });
}

/// Round yards in rows, some of which touch: outlines without a corner, or with two.
OccupancyGrid yard_grid(std::int32_t side, double radius) {
  return grid_where(side, side, 1.0, [=](double x, double y) {
    const double u = std::fmod(x, 3 * radius) - radius, v = std::fmod(y, 2 * radius - 1) - radius;
    return std::hypot(u, v) < radius;
  });
}

// Where walls are long, a change is felt by places that are far away along them, or by none at all.
TEST_P(RoadUpdates, EqualTheWholeWhereOutlinesAreLong) {
  const ExtractionMethod method = cases()[GetParam()].method;
  expect_equal_after_changes(method, spiral_grid(170, 14), 30, 16, 12);
  expect_equal_after_changes(method, spiral_grid(170, 24), 30, 30, 13);
  expect_equal_after_changes(method, yard_grid(200, 24), 30, 24, 14);
  expect_equal_after_changes(method, yard_grid(260, 60), 30, 24, 15);
}

// A wrong window is its producer's fault: the graph is then of something between both grids.
TEST_P(RoadUpdates, SurviveAWindowThatIsWrong) {
  const ExtractionMethod method = cases()[GetParam()].method;
  Random random(11);
  OccupancyGrid grid = random_grid(70, 50, 0.7, 3, 11);
  RoadUpdater updater(method);
  updater.full(grid);
  for (int i = 0; i < 30; ++i) {
    change_at_random(grid, 20, static_cast<ChangeKind>(i % kChangeKinds), random);
    const auto place = [&] { return static_cast<std::int32_t>(random.uniform(-100.0, 100.0)); };
    updater.update(grid, {place(), place(), place(), i % 5 == 0 ? INT32_MAX : place()});
  }
  EXPECT_EQ(digest_of(updater.full(grid)), digest_of(extract_roads(grid, method)));
}

TEST(RoadUpdater, ComputesAllOfAGridOfAnotherFrame) {
  RoadUpdater updater({});
  updater.full(noise_grid(60, -0.2, 1));
  OccupancyGrid other = noise_grid(61, -0.2, 2);
  EXPECT_EQ(digest_of(updater.update(other, {0, 0, 1, 1})), digest_of(extract_roads(other, {})));
  other.frame.origin.x = 7;
  EXPECT_EQ(digest_of(updater.update(other, {0, 0, 1, 1})), digest_of(extract_roads(other, {})));
}

TEST(RoadUpdater, GoesOnAfterAMapWithoutAFreeCell) {
  OccupancyGrid grid = noise_grid(50, -0.2, 3);
  const OccupancyGrid before = grid;
  RoadUpdater updater({});
  updater.full(grid);
  std::fill(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kOccupied);
  EXPECT_THROW(updater.update(grid, {0, 0, 50, 50}), Error);
  EXPECT_EQ(digest_of(updater.update(before, {0, 0, 50, 50})),
            digest_of(extract_roads(before, {})));
}

TEST(RoadUpdater, IsLeftInOrderWhenItIsStopped) {
  OccupancyGrid grid = noise_grid(80, -0.2, 4);
  RoadUpdater updater({});
  Random random(4);
  updater.full(grid);
  for (int calls = 0; calls < 12; ++calls) {
    const CellWindow window = change_at_random(grid, 20, ChangeKind::kRoadIsCut, random);
    int left = calls;
    try {
      updater.update(grid, window, [&] {
        if (left-- == 0) throw Cancelled();
      });
    } catch (const Cancelled&) {
    }
    EXPECT_EQ(digest_of(updater.update(grid, window)), digest_of(extract_roads(grid, {})));
  }
}

OccupancyGrid with_window(OccupancyGrid grid, const CellWindow& window, std::uint64_t since) {
  grid.changed = ChangedWindow{window.column, window.row, window.width, window.height, since};
  return grid;
}

// What a stage remembers makes it faster, never different: also if items refer to others than the
// last one, or say nothing of what changed.
TEST(RoadStages, RememberWhatDidNotChange) {
  for (const StageEntry* entry :
       {stope_stage_Watershed(), stope_stage_Voronoi(), stope_stage_Skeleton()}) {
    testing::StageHarness stage(entry);
    stage.set("min_branch", 8.0).set("allow_empty", true);
    OccupancyGrid grid = noise_grid(90, -0.2, 5);
    Random random(5);
    for (std::uint64_t item = 0; item < 14; ++item) {
      const auto kind = static_cast<ChangeKind>(item % kChangeKinds);
      const CellWindow window = change_at_random(grid, 25, kind, random);
      OccupancyGrid seen = grid;
      if (item > 0 && item % 5 != 4) seen = with_window(grid, window, item - 1);
      if (item == 7) seen.changed->since = 3, seen.changed->width = 0;  // of an item forgotten
      stage.context().item = item;
      const auto roads = stage.input("grid", seen).apply<RoadGraph>();
      testing::StageHarness fresh(entry);
      fresh.set("min_branch", 8.0).set("allow_empty", true);
      EXPECT_EQ(digest_of(roads), digest_of(fresh.input("grid", grid).apply<RoadGraph>()))
          << stage.info().id << ", item " << item;
    }
  }
}

}  // namespace
}  // namespace stope::topology
