#include "framework/report/page/page.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <regex>
#include <sstream>

#include "framework/report/draw/sketches.hpp"
#include "framework/report/page/figure.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/page/outputs.hpp"
#include "framework/report/run_report.hpp"
#include "stope/payloads.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

constexpr const char* kNasty = "<script>alert('x')</script> & \"quoted\" \xff";

// A run of a map, its roads and a path, whose every text tries to break out of the page.
std::string page_of_a_run(RunRecord::End end = RunRecord::End::kDone) {
  const made::Folder folder;
  made::PlanMaker maker(kNasty);
  const std::size_t grid =
      maker.stage("grid", "map_source/any", {}, {{"grid", std::string(OccupancyGrid::kType)}});
  const std::size_t roads = maker.stage(kNasty, "topology/any", {{kNasty, {grid, 0}}},
                                        {{kNasty, std::string(RoadGraph::kType)}});
  const std::size_t plan = maker.stage("plan", "planner/any", {{"roads", {roads, 0}}},
                                       {{"path", std::string(Path::kType)}});
  maker.output("plan & go.geojson", {plan, 0});
  maker.plan.vars[kNasty] = kNasty;
  const made::AnyCatalogue catalogue;
  RunFacts facts = made::facts();
  facts.command.push_back(kNasty);
  Diagnostic& warning = facts.warnings.emplace_back();
  warning.place.file = warning.sentence = warning.hint = kNasty;
  RunReport report(maker.plan, catalogue, facts, folder.path);
  report.log(LogLevel::kWarning, kNasty, kNasty);
  auto sinks = report.sinks();

  OccupancyGrid map;
  map.frame.width = 40;
  map.frame.height = 30;
  map.cells.assign(map.frame.size(), 0);
  RoadGraph graph;
  graph.nodes = {{0, 2, 2, 0}, {0, 30, 20, 0}};
  graph.vertices = {{2, 2, 0, 3}, {30, 20, 0, 3}};
  RoadEdge edge;
  edge.to = 1;
  edge.vertex_count = 2;
  graph.edges = {edge};
  canonicalize(graph);
  Path path;
  path.points = {{2, 2}, {30, 20}};
  const auto give = [&](const std::string& name, const AnyItem& item) {
    Sink& sink = made::sink(sinks, name);
    sink.consume(item);
    sink.finish();
  };
  give("report: grid.grid", made::item(map));
  give(std::string("report: ") + kNasty + "." + kNasty, made::item(graph));
  give("report: plan.path", made::item(path));
  give("write plan & go.geojson", made::item(made::artefact({{"geojson", "{}"}})));

  RunRecord record = made::ended(end, end == RunRecord::End::kDone ? "" : kNasty);
  ProcessRecord process;
  process.name = kNasty;
  process.end = process.run = record.wall;
  process.spans = {{Activity::kRun, 0, record.wall, record.wall, 1}};
  record.processes = {process};
  record.channels = {{kNasty, kNasty, 3, 16, 1}};
  report.finish(record);
  return made::text_of(folder.path / "report.html");
}

TEST(ReportPage, IsWellFormed) {
  for (const auto end : {RunRecord::End::kDone, RunRecord::End::kFailed}) {
    std::istringstream stream(page_of_a_run(end));
    boost::property_tree::ptree tree;
    EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree));
    EXPECT_TRUE(tree.get_child_optional("html.body.main"));
  }
}

TEST(ReportPage, LoadsNothingAndRunsNothing) {
  const std::string page = page_of_a_run();
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
  // Every address is data of its own or a file beside the page.
  const std::regex address(R"rx((href|src)="([^"]*)")rx");
  for (std::sregex_iterator match(page.begin(), page.end(), address), none; match != none;
       ++match) {
    const std::string target = (*match)[2];
    EXPECT_TRUE(target.starts_with("data:image/png;base64,") ||
                target.find(':') == std::string::npos)
        << target;
  }
  // The SVG namespace is a name, not an address.
  const std::regex outside(R"(https?://(?!www\.w3\.org/2000/svg))");
  EXPECT_FALSE(std::regex_search(page, outside));
}

TEST(ReportPage, DrawsRoadsAndPathOverTheMapTheyCameFrom) {
  const std::string page = page_of_a_run();
  const auto count = [&page](const std::string& text) {
    std::size_t times = 0;
    for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1))
      ++times;
    return times;
  };
  EXPECT_EQ(count("<figure"), 3U);
  EXPECT_EQ(count("data:image/png;base64,"), 3U);
  EXPECT_EQ(count("<g class=\"faint\">"), 1U);
  EXPECT_EQ(count("<path class=\"path\""), 2U);  // one of them in the legend
  EXPECT_NE(page.find("2 nodes, 1 edge"), std::string::npos);
}

TEST(ReportPage, SaysWhyARunFailed) {
  const std::string page = page_of_a_run(RunRecord::End::kFailed);
  EXPECT_NE(page.find("<b>Failed</b> after 1.50 s"), std::string::npos);
  EXPECT_NE(page.find("The run did not end well, so it left no outputs."), std::string::npos);
}

TEST(Figure, PutsAPointWhereItLiesOnATurnedGrid) {
  // A grid turned by 90 degrees about its corner at (10, 0): its x axis points north.
  OccupancyGrid map;
  map.frame = {100, 50, 1.0, {10, 0, 1.5707963267948966}};
  map.cells.assign(map.frame.size(), 0);
  const Sketch ground = sketch_of(map);
  Sketch sketch;
  sketch.kind = "Path";
  // 20 m along the grid's x, 10 m along its y, which points west.
  sketch.marks.push_back({"start", {0, 20}, ""});
  FigureParts parts;
  parts.sketch = &sketch;
  parts.ground = &ground;
  parts.wide = true;
  const std::string html = figure_html(parts);
  // 1000 units for 100 cells: 20 cells are 200 units; from the top, 50 - 10 cells are 400.
  EXPECT_NE(html.find("cx=\"200.0\" cy=\"400.0\""), std::string::npos) << html;
  EXPECT_NE(html.find("rotate(90.0deg)"), std::string::npos);
}

TEST(Figure, ScaleBarsAreRound) {
  EXPECT_DOUBLE_EQ(scale_bar_length(2108), 500);
  EXPECT_DOUBLE_EQ(scale_bar_length(400), 100);
  EXPECT_DOUBLE_EQ(scale_bar_length(399), 50);
  EXPECT_DOUBLE_EQ(scale_bar_length(1), 0.2);
}

TEST(Escaped, KeepsTextAndDisarmsTheRest) {
  EXPECT_EQ(escaped("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(escaped("Straße ☃ 𝄞"), "Straße ☃ 𝄞");
  EXPECT_EQ(escaped("a\xff\xc0\xaf\xed\xa0\x80z\x01"),
            "a\ufffd\ufffd\ufffd\ufffd\ufffd\ufffdz\ufffd");
}

TEST(LinkText, EncodesWhatIsNotPlain) {
  EXPECT_EQ(link_text("outputs/a b#c?.png"), "outputs/a%20b%23c%3F.png");
}

}  // namespace
}  // namespace stope::report
