#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Graphml();

namespace stope::exports {
namespace {

using Tree = boost::property_tree::ptree;

std::map<std::string, std::string> data_of(const Tree& element) {
  std::map<std::string, std::string> data;
  for (const auto& [name, child] : element) {
    if (name == "data") data[child.get<std::string>("<xmlattr>.key")] = child.data();
  }
  return data;
}

void expect_same(double a, double b) {
  if (std::isnan(a)) {
    EXPECT_TRUE(std::isnan(b));
  } else {
    EXPECT_EQ(a, b);
  }
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

TEST(Graphml, ReadsBackToTheLastBit) {
  RoadGraph graph = sample_roads();
  graph.nodes[1].x = 1.0 / 3;
  graph.edges[0].grade = 0.125;
  graph.edges[0].curvature = 1.0 / 7;
  graph.edges[1].min_clearance = std::numeric_limits<double>::infinity();
  std::istringstream text(text_of(
      stope::testing::StageHarness(stope_stage_Graphml()).input("roads", graph).apply<Artefact>(),
      "graphml"));
  Tree tree;
  boost::property_tree::read_xml(text, tree);
  std::map<std::string, std::string> types;
  for (const auto& [name, key] : tree.get_child("graphml")) {
    if (name == "key") types[key.get<std::string>("<xmlattr>.id")] = "declared";
  }
  std::size_t nodes = 0, edges = 0;
  for (const auto& [name, element] : tree.get_child("graphml.graph")) {
    auto data = data_of(element);
    for (const auto& [key, value] : data) EXPECT_EQ(types[key], "declared") << key;
    if (name == "node") {
      const RoadNode& node = graph.nodes.at(nodes++);
      EXPECT_EQ(std::stoull(data["id"]), node.id);
      expect_same(node.x, number(data["x"]));
      expect_same(node.z, number(data["z"]));
    } else if (name == "edge") {
      const RoadEdge& edge = graph.edges.at(edges++);
      EXPECT_EQ(element.get<std::string>("<xmlattr>.source"), "n" + std::to_string(edge.from));
      EXPECT_EQ(element.get<std::string>("<xmlattr>.target"), "n" + std::to_string(edge.to));
      EXPECT_EQ(std::stoull(data["id"]), edge.id);
      expect_same(edge.length, number(data["length"]));
      expect_same(edge.speed_limit, number(data["speed_limit"]));
      expect_same(edge.lane_width, number(data["lane_width"]));
      expect_same(edge.width, number(data["width"]));
      expect_same(edge.grade, number(data["grade"]));
      expect_same(edge.curvature, number(data["curvature"]));
      expect_same(edge.min_clearance, number(data["min_clearance"]));
      expect_same(edge.mean_clearance, number(data["mean_clearance"]));
      EXPECT_EQ(data["closed"], edge.closed != 0 ? "true" : "false");
      EXPECT_EQ(data["direction"], edge.direction == RoadDirection::kForward ? "forward" : "both");
      std::istringstream vertices(data["vertices"]);
      std::string vertex;
      for (const RoadVertex& expected : graph.polyline(edge)) {
        ASSERT_TRUE(vertices >> vertex);
        std::replace(vertex.begin(), vertex.end(), ',', ' ');
        std::istringstream numbers(vertex);
        std::string x, y, z, clearance;
        ASSERT_TRUE(numbers >> x >> y >> z >> clearance);
        expect_same(expected.x, number(x));
        expect_same(expected.y, number(y));
        expect_same(expected.z, number(z));
        expect_same(expected.clearance, number(clearance));
      }
      EXPECT_FALSE(vertices >> vertex);
    }
  }
  EXPECT_EQ(nodes, graph.nodes.size());
  EXPECT_EQ(edges, graph.edges.size());
}

}  // namespace
}  // namespace stope::exports
