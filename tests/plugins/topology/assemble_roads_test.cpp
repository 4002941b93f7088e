#include "plugins/topology/assemble_roads.hpp"

#include <gtest/gtest.h>

#include "plugins/topology/extraction_method.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

using Kind = ExtractionMethod::Kind;

/// The graph as if nothing had been measured, named or put in order: turned round edge by edge, the
/// last node first.
RoadGraph made_raw(const RoadGraph& graph) {
  RoadGraph raw;
  for (auto node = graph.nodes.rbegin(); node != graph.nodes.rend(); ++node)
    raw.nodes.push_back({0, node->x, node->y, node->z});
  const auto last = static_cast<std::uint32_t>(graph.nodes.size()) - 1;
  for (auto old = graph.edges.rbegin(); old != graph.edges.rend(); ++old) {
    RoadEdge edge;
    edge.from = last - old->to, edge.to = last - old->from;
    edge.width = old->width;
    edge.first_vertex = static_cast<std::uint32_t>(raw.vertices.size());
    edge.vertex_count = old->vertex_count;
    const auto line = graph.polyline(*old);
    raw.vertices.insert(raw.vertices.end(), line.rbegin(), line.rend());
    raw.edges.push_back(edge);
  }
  return raw;
}

void expect_canonical(const OccupancyGrid& grid, const ExtractionMethod& method) {
  const RoadGraph graph = extract_roads(grid, method);
  RoadGraph raw = made_raw(graph);
  canonicalize(raw);
  EXPECT_EQ(digest_of(graph), digest_of(raw));
}

TEST(AssembleRoads, GivesWhatCanonicalizeDoes) {
  for (const Kind kind : {Kind::kVoronoi, Kind::kWatershed, Kind::kSkeleton}) {
    ExtractionMethod method;
    method.kind = kind;
    method.params.min_clearance = 0;
    method.params.min_obstacle_area = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U})
      expect_canonical(random_grid(90, 70, 0.7, 4, seed), method);
  }
}

// Two ways round an island, which only their vertices tell apart, a ring with one node round a lone
// pillar, and a yard without a road.
TEST(AssembleRoads, GivesWhatCanonicalizeDoesOfRingsTwinsAndLoneNodes) {
  expect_canonical(grid_where(200, 60, 1.0,
                              [](double x, double y) {
                                const bool road = std::abs(y - 30) < 6 && x > 10 && x < 90;
                                const double island = std::hypot(x - 50, y - 30);
                                const bool ring = std::abs(std::hypot(x - 120, y - 30) - 14) < 6;
                                const bool yard = std::hypot(x - 165, y - 30) < 18;
                                return (road && island > 8) || (island > 8 && island < 22) ||
                                       ring || yard;
                              }),
                   {});
}

}  // namespace
}  // namespace stope::topology
