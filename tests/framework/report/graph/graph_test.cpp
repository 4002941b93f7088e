#include "framework/report/graph/graph.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "stope/payloads.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope {
namespace {

Plan small_plan() {
  made::PlanMaker maker("a \"b\" <c> & d");
  const std::size_t scans = maker.stage(
      "scans", "source/any", {},
      {{"scans", std::string(LidarScan::kType), true}, {"poses", "stope/Trajectory@1"}});
  const std::size_t cloud =
      maker.stage("cloud", "map/any", {{"scans", {scans, 0}}, {"trajectory", {scans, 1}}},
                  {{"cloud", std::string(PointCloud::kType)}});
  maker.output("cloud.pcd", {cloud, 0});
  return maker.plan;
}

TEST(GraphDot, NamesStagesPortsAndOutputs) {
  const std::string dot = graph_dot(small_plan());
  EXPECT_TRUE(dot.starts_with("digraph \"a \\\"b\\\" <c> & d\" {\n")) << dot;
  EXPECT_NE(dot.find("n0 [label=\"scans\\nsource/any\"]"), std::string::npos) << dot;
  EXPECT_NE(dot.find("n0 -> n1 [label=\"scans\", tooltip=\"LidarScan\", penwidth=2]"),
            std::string::npos)
      << dot;
  EXPECT_NE(dot.find("label=\"poses → trajectory\""), std::string::npos) << dot;
  EXPECT_NE(dot.find("n2 [label=\"cloud.pcd\\nexport/any\""), std::string::npos) << dot;
}

TEST(GraphMermaid, NamesStagesPortsAndOutputs) {
  const std::string mermaid = graph_mermaid(small_plan());
  EXPECT_TRUE(mermaid.starts_with("flowchart LR\n"));
  EXPECT_NE(mermaid.find("n0[\"scans<br/><small>source/any</small>\"]"), std::string::npos)
      << mermaid;
  EXPECT_NE(mermaid.find("n0 ==>|\"scans\"| n1"), std::string::npos) << mermaid;
  EXPECT_NE(mermaid.find("n1 -->|\"cloud\"| n2"), std::string::npos) << mermaid;
}

TEST(GraphSvg, IsWellFormedAndHoldsEveryName) {
  const std::string svg = graph_svg(small_plan());
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(stream, tree)) << svg;
  for (const char* text : {">scans<", ">cloud<", ">cloud.pcd<", ">trajectory<", ">source/any<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace stope
