#include <gmock/gmock.h>

#include <atomic>
#include <vector>

#include "plugins/source/synthetic_pit/truth.hpp"
#include "stope/digest.hpp"
#include "stope/payloads.hpp"
#include "tests/plugins/source/pit_worlds.hpp"
#include "tests/plugins/source/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_SyntheticPit();

namespace stope::source {
namespace {

struct Recorded {
  explicit Recorded(std::int64_t scan_count) {
    harness.set("size", 440.0).set("benches", std::int64_t{2}).set("dead_ends", std::int64_t{5});
    harness.set("scans", scan_count).set("azimuths", std::int64_t{360});
    harness.keep("scans", scans).keep("poses", poses).keep("trajectory", trajectory);
    harness.keep("truth_grid", grid).keep("truth_roads", roads).keep("truth_elevation", elevation);
  }
  StageHarness harness{stope_stage_SyntheticPit()};
  testing::MemoryOutput<LidarScan> scans;
  testing::MemoryOutput<StampedPose> poses;
  testing::MemoryOutput<Trajectory> trajectory;
  testing::MemoryOutput<OccupancyGrid> grid;
  testing::MemoryOutput<RoadGraph> roads;
  testing::MemoryOutput<ElevationGrid> elevation;
};

TEST(SyntheticPit, GivesScansMotionAndTruth) {
  Recorded recorded(4);
  const Outcome outcome = recorded.harness.run();
  ASSERT_TRUE(outcome) << outcome.sentence;
  ASSERT_EQ(recorded.scans.items.size(), 4u);
  ASSERT_EQ(recorded.poses.items.size(), 4u);
  ASSERT_EQ(recorded.trajectory.items.size(), 1u);
  const Trajectory& path = *recorded.trajectory.items[0].value;
  EXPECT_EQ(path.poses.back().stamp, recorded.scans.items[3].stamp);
  EXPECT_LE(path.poses.front().stamp,
            recorded.scans.items[0].stamp + recorded.scans.items[0].value->time_offset[0]);
  EXPECT_EQ(recorded.grid.items[0].value->frame, recorded.elevation.items[0].value->frame);
  EXPECT_FALSE(recorded.roads.items[0].value->edges.empty());
  for (const std::uint8_t cell : recorded.grid.items[0].value->cells)
    ASSERT_TRUE(cell == OccupancyGrid::kFree || cell == OccupancyGrid::kOccupied);
}

TEST(SyntheticPit, RefusesASensorThatDoesNotExist) {
  Recorded recorded(1);
  const Outcome outcome = recorded.harness.set("rings", std::int64_t{20}).run();
  EXPECT_THAT(outcome.sentence, ::testing::HasSubstr("rings is 20"));
}

TEST(SyntheticPit, SaysWhenThereIsNoRoomForARamp) {
  Recorded recorded(1);
  const Outcome outcome =
      recorded.harness.set("benches", std::int64_t{30}).set("bench_height", 20.0).run();
  EXPECT_EQ(outcome.kind, Outcome::Kind::kFailed);
  EXPECT_THAT(outcome.sentence, ::testing::HasSubstr("use a larger size"));
}

TEST(SyntheticPit, EndsAsCancelledWithoutOutputs) {
  Recorded recorded(4);
  recorded.harness.context.cancel = true;
  const Outcome outcome = recorded.harness.run();
  EXPECT_EQ(outcome.kind, Outcome::Kind::kCancelled);
  EXPECT_TRUE(recorded.scans.items.empty());
  EXPECT_TRUE(recorded.poses.items.empty());
  EXPECT_TRUE(recorded.trajectory.items.empty());
  EXPECT_TRUE(recorded.grid.items.empty());
  EXPECT_TRUE(recorded.roads.items.empty());
  EXPECT_TRUE(recorded.elevation.items.empty());
}

TEST(SyntheticPit, CanBeGivenUpWhereverItIs) {
  std::atomic<std::int64_t> asked = 0;
  const World whole(small_pit(), 7, [&] { ++asked; });
  const std::int64_t all = asked;
  ASSERT_GT(all, 1000);
  for (const std::int64_t last : {all / 50, all / 10, all / 4, all / 2, all - 1}) {
    asked = 0;
    EXPECT_THROW(World(small_pit(), 7,
                       [&] {
                         if (++asked > last) throw Cancelled();
                       }),
                 Cancelled)
        << last << " of " << all;
  }
}

TEST(SyntheticPit, IsAFunctionOfItsSeed) {
  const World first(small_pit(), 7), again(small_pit(), 7), other(small_pit(), 8);
  const auto roads = [](const World& world) {
    return digest_of(true_roads(world.graph, world.terrain));
  };
  EXPECT_EQ(roads(first), roads(again));
  EXPECT_NE(roads(first), roads(other));
  EXPECT_EQ(digest_of(first.terrain.height), digest_of(again.terrain.height));
  // In any order, any number of times.
  const std::vector<std::size_t> order{5, 1, 9, 5};
  std::vector<Digest> digests;
  for (const std::size_t k : order) digests.push_back(digest_of(again.scan(k)));
  EXPECT_EQ(digests[0], digests[3]);
  EXPECT_EQ(digest_of(first.scan(1)), digests[1]);
  EXPECT_EQ(digest_of(first.scan(5)), digests[0]);
  EXPECT_NE(digest_of(other.scan(5)), digests[0]);
}

TEST(SyntheticPit, EverySeedIsAMine) {
  PitParameters parameters = small_pit();
  parameters.size = 600;
  parameters.benches = 3;
  parameters.resolution = 2;  // the plan does not depend on it
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const Layout layout = plan_layout(parameters, seed);
    const NetworkGraph graph = cut_at_junctions(layout.network);
    EXPECT_GE(graph.edges.size(), graph.nodes.size() + 1) << seed;  // two cycles or more
    EXPECT_GE(layout.network.dead_ends.size(), 3u) << seed;
  }
}

}  // namespace
}  // namespace stope::source
