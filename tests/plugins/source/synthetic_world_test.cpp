#include <gtest/gtest.h>

#include <cmath>

#include "plugins/source/synthetic_pit/truth.hpp"
#include "plugins/source/synthetic_pit/world.hpp"
#include "stope/digest.hpp"
#include "stope/payloads/point_label.hpp"

namespace stope::source {
namespace {

PitParameters small_pit() {
  PitParameters parameters;
  parameters.size = 400;
  parameters.benches = 2;
  parameters.dead_ends = 4;
  parameters.connectors = 1;
  parameters.azimuths = 180;
  return parameters;
}

const World& shared_world() {
  static const World world(small_pit(), 7);
  return world;
}

TEST(SyntheticWorld, HasALoopAndDeadEnds) {
  const NetworkGraph& graph = shared_world().graph;
  EXPECT_GE(graph.edges.size(), graph.nodes.size());  // connected: at least one independent cycle
  EXPECT_GE(shared_world().layout.network.dead_ends.size(), 2u);
}

TEST(SyntheticWorld, EveryGroundPointLiesOnTheTerrain) {
  const World& world = shared_world();
  for (const std::size_t k : {std::size_t{0}, world.sweeps.count / 2, world.sweeps.count - 1}) {
    const LidarScan scan = world.scan(k);
    ASSERT_GT(scan.points.size(), 500u);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (scan.label[i] == static_cast<std::uint8_t>(PointLabel::kObject)) continue;
      const Pose pose = pose_at(world.trajectory, world.sweeps.end(k) + scan.time_offset[i]);
      const Vector3 beam(scan.points[i].x, scan.points[i].y, scan.points[i].z);
      const Vector3 point = pose * beam;
      // Range noise moves a point along its beam; the steepest wall turns that into height.
      EXPECT_NEAR(point.z(), world.terrain.height_at(point.x(), point.y()), 0.5);
    }
  }
}

TEST(SyntheticWorld, IsAFunctionOfItsSeed) {
  const World again(small_pit(), 7), other(small_pit(), 8);
  const World& first = shared_world();
  EXPECT_EQ(digest_of(again.scan(5)), digest_of(first.scan(5)));
  EXPECT_EQ(digest_of(true_roads(again.graph, again.terrain)),
            digest_of(true_roads(first.graph, first.terrain)));
  EXPECT_NE(digest_of(other.scan(5)), digest_of(first.scan(5)));
}

}  // namespace
}  // namespace stope::source
