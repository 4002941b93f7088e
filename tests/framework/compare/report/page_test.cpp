#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "framework/compare/report/comparison_page.hpp"
#include "framework/compare/report/difference_plot.hpp"
#include "made_comparison.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

constexpr const char* kNasty = "</script><script>alert('x')</script> & \"quoted\" <!-- \xff";

// The page without what XML cannot hold: the doctype, and the text of style and script elements.
std::string markup_of(const std::string& page) {
  std::string rest = page.substr(page.find("<html")), markup;
  for (;;) {
    const std::size_t style = rest.find("<style"), script = rest.find("<script");
    const std::size_t begin = std::min(style, script);
    if (begin == std::string::npos) return markup + rest;
    const std::size_t text = rest.find('>', begin) + 1;
    const std::size_t end = rest.find(style < script ? "</style>" : "</script>", text);
    markup += rest.substr(0, text);
    rest = rest.substr(end);
    // Past the end tag, so that the next search does not find this element again.
    markup += rest.substr(0, 8);
    rest = rest.substr(8);
  }
}

// What the viewer's script is given.
nlohmann::json viewer_data_of(const std::string& page) {
  const std::size_t begin = page.find('>', page.find("id=\"viewer-data\"")) + 1;
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ComparisonPage, IsWellFormedWhateverNamesSay) {
  const made::Folder folder;
  Comparison comparison = made::comparison_in(folder.path, {3, 8, 2, 0.3, kNasty, true});
  comparison.arms[1].name = comparison.recordings[2].name = comparison.metrics[0].name = kNasty;
  comparison.arms[1].overrides = comparison.arms[1].plan = {kNasty};
  comparison.metrics[1].unit = kNasty;
  comparison.exclusions = {{kNasty, kNasty, 3, kNasty, kNasty}, {"a", "b", 0, "", kNasty}};
  comparison.warnings = {kNasty};
  comparison.cells[3].status = CellStatus::kFailed;
  comparison.cells[3].sentence = comparison.cells[4].artefacts[0].output = kNasty;
  comparison.cells[5].stages[1].name = comparison.cells[5].stages[1].use = kNasty;
  comparison.timings = {{1, 0, 0, {1, 2}, {2, 3}, {}}};
  const std::string page = comparison_page(comparison);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  std::istringstream stream(markup_of(page));
  boost::property_tree::ptree tree;
  EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree));
}

TEST(ComparisonPage, NeedsNothingFromOutside) {
  const made::Folder folder;
  const std::string page = comparison_page(made::comparison_in(folder.path));
  const std::regex address("(?:src|href)=\"([^\"]{0,40})");
  for (std::sregex_iterator match(page.begin(), page.end(), address), end; match != end; ++match)
    EXPECT_TRUE((*match)[1].str().rfind("data:", 0) == 0) << (*match)[1];
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
}

TEST(ComparisonPage, HoldsAPictureOnceHoweverManyCellsShareIt) {
  const made::Folder folder;
  Comparison comparison = made::comparison_in(folder.path, {2, 8, 1, 0.3, "n", true});
  EXPECT_EQ(viewer_data_of(comparison_page(comparison))["pictures"].size(), 16U);
  for (ComparedCell& cell : comparison.cells) cell.artefacts[0] = comparison.cells[0].artefacts[0];
  const auto data = viewer_data_of(comparison_page(comparison));
  EXPECT_EQ(data["pictures"].size(), 1U);
  EXPECT_EQ(data["cells"].size(), 16U);
}

TEST(ComparisonPage, IsDrawnOfWhatIsThereSoFar) {
  const made::Folder folder;
  Comparison comparison = made::comparison_in(folder.path, {2, 8, 1, 0.3, "half", true});
  comparison.complete = false;
  for (std::size_t i = 6; i < comparison.cells.size(); ++i) {
    ComparedCell none;
    none.arm = comparison.cells[i].arm;
    none.recording = comparison.cells[i].recording;
    comparison.cells[i] = none;
  }
  std::filesystem::remove(folder.path / comparison.cells[0].artefacts[0].path);
  std::filesystem::remove(folder.path / comparison.cells[1].artefacts[1].path);
  const std::string page = comparison_page(comparison);
  EXPECT_NE(page.find("So far: 6 of 16 runs are done."), std::string::npos);
  EXPECT_NE(page.find("7 recordings are needed to say anything"), std::string::npos);
}

TEST(ComparisonPage, SaysWhereAnArmFailedAndThatRecordingsAreOne) {
  Comparison comparison = made::comparison_in("", {2, 9, 1, 0.3, "n", false});
  comparison.cell(1, 3, 0).status = CellStatus::kFailed;
  comparison.recordings[8].same_as = "pit-0";
  const std::string page = comparison_page(comparison);
  EXPECT_NE(page.find("<small>of 8; voronoi failed on 1</small>"), std::string::npos);
  EXPECT_NE(page.find("under 9 names"), std::string::npos);
  EXPECT_NE(page.find("the same as pit-0"), std::string::npos);
}

TEST(ComparisonPage, DrawsNoIntervalOfFewerThanSix) {
  const std::string few = comparison_page(made::comparison_in("", {2, 5, 1, 0.3, "n", false}));
  const std::string enough = comparison_page(made::comparison_in("", {2, 6, 1, 0.3, "n", false}));
  EXPECT_EQ(few.find("<line class=\"interval\""), std::string::npos);
  EXPECT_NE(few.find("[–]"), std::string::npos);
  EXPECT_NE(enough.find("<line class=\"interval\""), std::string::npos);
}

TEST(ComparisonPage, OfNothingIsStillAPage) {
  Comparison comparison;
  comparison.arms = {{"only", {}, {}, {}}};
  EXPECT_NE(comparison_page(comparison).find("</html>"), std::string::npos);
}

TEST(ComparisonPage, IsTheSameBytesAgain) {
  const made::Folder folder;
  const Comparison comparison = made::comparison_in(folder.path);
  EXPECT_EQ(comparison_page(comparison), comparison_page(comparison));
}

TEST(ComparisonPage, StandsInTheFolderBesideItsTables) {
  const made::Folder folder;
  write_comparison_report(made::comparison_in(folder.path, {2, 6, 1, 0.3, "n", false}));
  EXPECT_EQ(made::files_below(folder.path),
            (std::vector<std::string>{"measures.csv", "report.html", "stage_times.csv",
                                      "verdicts.csv", "verdicts.json"}));
}

TEST(Ticks, AreRoundAndInside) {
  EXPECT_EQ(ticks(-7, 12), (std::vector<double>{-5, 0, 5, 10}));
  const std::vector<double> small = ticks(-0.1, 0.55);
  ASSERT_EQ(small.size(), 3U);
  EXPECT_NEAR(small[2], 0.4, 1e-12);
}

}  // namespace
}  // namespace stope::report
