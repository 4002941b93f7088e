// Whatever bytes a GeoJSON file has, its reader gives a sound graph or a sentence, and nothing
// else.
#include <gtest/gtest.h>

#include "plugins/export/route_writer.hpp"
#include "tests/plugins/damaged_bytes.hpp"
#include "tests/plugins/road_source/made_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

namespace stope::road_source {
namespace {

const std::string kByOthers = R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"id": 0, "frame": "map"}, "geometry": {"type": "Point", "coordinates": [0, 0.5]}},
{"type": "Feature", "properties": {"id": 1}, "geometry": {"type": "Point", "coordinates": [9, 0.5, 2]}},
{"type": "Feature", "properties": {"id": 2, "startid": 0, "endid": 1, "cost": 3, "metadata": {"abs_speed_limit": 4.5}},
 "geometry": {"type": "MultiLineString", "coordinates": [[[0, 0.5], [4, 1], [9, 0.5]]]}},
{"type": "Feature", "properties": {"id": 3, "startid": 1, "endid": 0}, "geometry": {"type": "LineString", "coordinates": []}}
]})";

TEST(DamagedFiles, RouteGraphs) {
  Random random(5);
  int refused = 0;
  for (const std::string& sound :
       {exports::route_geojson(made_roads(2, 4, 5), {"map", 0}), kByOthers}) {
    for (int i = 0; i < stope::testing::damaged_files(2000); ++i) {
      const std::string text = stope::testing::damaged(sound, random);
      const std::string said = stope::testing::error_of([&] {
        const RoadGraph roads = read_route(text);
        for (const RoadEdge& edge : roads.edges) {
          ASSERT_LT(edge.from, roads.nodes.size());
          ASSERT_LT(edge.to, roads.nodes.size());
          ASSERT_GE(edge.vertex_count, 2U);
          ASSERT_LE(std::size_t{edge.first_vertex} + edge.vertex_count, roads.vertices.size());
        }
      });
      if (said.empty()) continue;
      ++refused;
      EXPECT_EQ(said.find("the road graph "), 0U) << said;
      EXPECT_LT(said.size(), 800U) << said;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace stope::road_source
