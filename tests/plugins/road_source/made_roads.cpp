#include "tests/plugins/road_source/made_roads.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Nav2Route();

namespace stope::road_source {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double any(Random& random, double from, double to) { return from + (to - from) * random.uniform(); }
/// A number, or not known.
double perhaps(Random& random, double value) { return random.below(3) == 0 ? kNaN : value; }

}  // namespace

RoadGraph made_roads(std::uint64_t seed, int nodes, int edges) {
  Random random(seed);
  RoadGraph graph;
  for (int i = 0; i < nodes; ++i) {
    RoadNode node{0, any(random, -500, 500), any(random, -500, 500),
                  perhaps(random, any(random, 900, 1400))};
    if (random.below(4) == 0) node.x = std::floor(node.x), node.y = -0.0;
    if (random.below(5) == 0) node.id = 0xfffffffffffffff0ULL - static_cast<std::uint64_t>(i);
    graph.nodes.push_back(node);
  }
  // The last two nodes stay alone.
  const auto pick = [&] {
    return static_cast<std::uint32_t>(random.below(static_cast<std::uint64_t>(nodes - 2)));
  };
  for (int i = 0; i < edges; ++i) {
    RoadEdge edge;
    edge.from = pick();
    edge.to = random.below(10) == 0 ? edge.from : pick();
    const RoadNode &a = graph.nodes[edge.from], &b = graph.nodes[edge.to];
    const auto bends = static_cast<int>(random.below(12)) + (edge.from == edge.to ? 3 : 1);
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = static_cast<std::uint32_t>(bends) + 2;
    const auto clearance = [&] {
      return random.below(20) == 0 ? std::numeric_limits<double>::infinity() : any(random, 0, 30);
    };
    graph.vertices.push_back({a.x, a.y, a.z, clearance()});
    for (int k = 1; k <= bends; ++k) {
      const double t = k / (bends + 1.0);
      graph.vertices.push_back({a.x + t * (b.x - a.x) + any(random, -20, 20),
                                a.y + t * (b.y - a.y) + any(random, -20, 20),
                                perhaps(random, any(random, 900, 1400)), clearance()});
    }
    // Now and then a road's end is not as high as the node it meets.
    graph.vertices.push_back({b.x, b.y, random.below(5) == 0 ? 1000.5 : b.z, clearance()});
    edge.width = any(random, 4, 40);
    edge.grade = perhaps(random, any(random, 0, 0.2));
    edge.curvature = any(random, 0, 0.1);
    edge.lane_width = perhaps(random, 9.0);
    edge.speed_limit = perhaps(random, random.below(2) == 0 ? 8.0 : any(random, 1, 20));
    if (random.below(30) == 0) edge.speed_limit = std::numeric_limits<double>::infinity();
    edge.direction = static_cast<RoadDirection>(random.below(3));
    edge.closed = random.below(6) == 0 ? 1 : 0;
    graph.edges.push_back(edge);
  }
  canonicalize(graph);
  return graph;
}

RoadGraph read_route(const std::string& text, std::vector<std::string>* sentences,
                     double clearance) {
  stope::testing::StageHarness stage(stope_stage_Nav2Route());
  const auto file = stage.context().temporary_folder() / "roads.geojson";
  std::ofstream(file, std::ios::binary) << text;
  stope::testing::MemoryOutput<RoadGraph> roads;
  stage.set("graph", file.string()).set("clearance", clearance).connect_output("roads", roads);
  stage.run();
  if (sentences) *sentences = stage.context().sentences;
  return *roads.items.at(0).value;
}

std::string read_error(const std::string& text) {
  return stope::testing::error_of([&] { read_route(text); });
}

}  // namespace stope::road_source
