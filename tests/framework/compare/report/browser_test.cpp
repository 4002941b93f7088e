// The comparison page in a real browser: looked at, dragged, clicked. With STOPE_SCREENSHOTS set to
// a folder it leaves pictures of what it saw there.
#include "tests/browser/browser.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "framework/compare/report/comparison_page.hpp"
#include "made_comparison.hpp"
#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

using testing::Browser;
using testing::View;
using testing::WindowPoint;

/// A comparison's page, and one browser for all tests of it: starting one takes seconds.
struct Opened {
  made::Folder report, folder;
  Browser browser{folder.path};

  Opened() {
    Comparison comparison = made::comparison_in(report.path, {3, 8, 2, 0.3, "extractors", true});
    comparison.timings = {{1, 0, 0, {1, 2, 4}, {0.5, 1, 1}, {}}};
    comparison.cell(2, 7, 1).status = CellStatus::kFailed;
    comparison.cell(2, 7, 1).sentence = "roads: the grid has no free cell";
    comparison.cell(2, 7, 1).artefacts.clear();
    comparison.exclusions = {{"skeleton", "pit-7", 1, "", "roads: the grid has no free cell"}};
    write_comparison_report(comparison);
  }
};

class ComparisonInBrowser : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { opened_ = std::make_unique<Opened>(); }
  static void TearDownTestSuite() { opened_.reset(); }

  void open(const View& view = {}) { browser_.open(report_ / "report.html", view); }
  void picture(const std::string& name) {
    if (const char* folder = std::getenv("STOPE_SCREENSHOTS"))
      browser_.screenshot(std::filesystem::path(folder) / (name + ".png"));
  }
  /// Where the first slider cuts, in per cent of its width.
  double cut() {
    return browser_.evaluate(
        "parseFloat(getComputedStyle(document.querySelector('.slider')).getPropertyValue('--cut')"
        ")");
  }

  static inline std::unique_ptr<Opened> opened_;
  Browser& browser_ = opened_->browser;
  const std::filesystem::path& report_ = opened_->report.path;
};

TEST_F(ComparisonInBrowser, OpensWithoutAComplaintInLightAndDarkWideAndNarrow) {
  for (const View& view : {View{1280, 900, false}, {1280, 900, true}, {390, 844, false}}) {
    open(view);
    EXPECT_TRUE(browser_.complaints().empty()) << browser_.complaints().front();
    EXPECT_LE(browser_.evaluate("document.documentElement.scrollWidth"), view.width)
        << "the page itself must not scroll sideways";
    picture(std::to_string(view.width) + (view.dark ? "-dark" : "-light"));
  }
}

TEST_F(ComparisonInBrowser, SaysTheFindingAtTheTop) {
  open();
  const std::string finding = browser_.evaluate("document.querySelector('.finding').textContent");
  EXPECT_EQ(finding.rfind("voronoi is better than watershed in apls by 0.2", 0), 0U) << finding;
  EXPECT_NE(finding.find("on 8 recordings, and it matters"), std::string::npos) << finding;
}

TEST_F(ComparisonInBrowser, DarkIsDark) {
  open({1280, 900, true});
  EXPECT_EQ(browser_.evaluate("getComputedStyle(document.body).backgroundColor"),
            "rgb(19, 21, 24)");
}

TEST_F(ComparisonInBrowser, TheSliderFollowsTheMouseAndTheKeys) {
  open();
  const WindowPoint middle = browser_.middle_of(".slider");
  const double width = browser_.evaluate("document.querySelector('.slider').clientWidth");
  EXPECT_NEAR(cut(), 50, 0.1);
  browser_.drag(middle, {middle.x + 0.3 * width, middle.y});
  EXPECT_NEAR(cut(), 80, 4);
  browser_.drag({middle.x + 0.3 * width, middle.y}, {middle.x - 0.4 * width, middle.y});
  EXPECT_NEAR(cut(), 10, 4);
  const double before = cut();
  for (int i = 0; i < 20; ++i) browser_.press("ArrowRight");
  EXPECT_GT(cut(), before + 1);
  // The upper picture is cut off where the slider stands.
  EXPECT_NE(browser_.evaluate("getComputedStyle(document.querySelector('.slider .over')).clipPath")
                .get<std::string>()
                .find("inset(0"),
            std::string::npos);
  EXPECT_EQ(browser_.evaluate("[...document.querySelectorAll('.slider img')].every((image) => "
                              "image.complete && image.naturalWidth === 320)"),
            true);
}

TEST_F(ComparisonInBrowser, ShowsTheLinesThatDiffer) {
  open();
  EXPECT_EQ(browser_.evaluate("document.querySelectorAll('.sheet .only-left').length"), 0);
  EXPECT_EQ(browser_.evaluate("document.querySelectorAll('.sheet .common').length"), 1);
  // The dead end that voronoi has and watershed lacks: 70 m of it.
  const double length =
      browser_.evaluate("document.querySelector('.sheet .only-right').getTotalLength()");
  const double all = browser_.evaluate("document.querySelector('.sheet .common').getTotalLength()");
  EXPECT_NEAR(length / all, 69.5 / (2 * (400 + 300) + 28.3), 0.002);
}

TEST_F(ComparisonInBrowser, ShowsTheMapUnderTheLines) {
  open();
  EXPECT_EQ(browser_.evaluate("document.querySelector('.sheet svg').firstChild.tagName"), "image");
  EXPECT_EQ(browser_.evaluate("document.querySelectorAll('.sheet svg image').length"), 1);
  // The map is 400 by 300 m from the ring's lower left corner, which is 20 m from the lines' own.
  const auto box = [&](const std::string& what) {
    return browser_.evaluate(
        "(({x, y, width, height}) => [x, y, width, height])(document."
        "querySelector('.sheet " +
        what + "').getBBox())");
  };
  const auto map = box("image"), ring = box(".common");
  const double units = ring[2].get<double>() / 420;
  EXPECT_NEAR(map[0], ring[0].get<double>() + 20 * units, 0.2);
  EXPECT_NEAR(map[1], ring[1].get<double>(), 0.2);
  EXPECT_NEAR(map[2], 400 * units, 0.2);
  EXPECT_NEAR(map[3], 300 * units, 0.2);
  EXPECT_TRUE(browser_.complaints().empty());
}

TEST_F(ComparisonInBrowser, ShowsTheRecordingSeedAndArmThatAreChosen) {
  open();
  const auto right = [&] {
    return browser_.evaluate("document.querySelector('.slider .over').src").get<std::string>();
  };
  const std::string first = right();
  browser_.choose("#recording", "pit-1");
  EXPECT_NE(right(), first);
  browser_.choose("#arm", "skeleton");
  EXPECT_EQ(browser_.evaluate("document.querySelector('.tab.right').textContent"), "skeleton");
  browser_.choose("#recording", "pit-7");
  browser_.choose("#seed", "1");
  EXPECT_EQ(browser_.evaluate("document.querySelector('.absent p').textContent"),
            "skeleton: roads: the grid has no free cell");
  EXPECT_TRUE(browser_.complaints().empty());
}

TEST_F(ComparisonInBrowser, GivesItsTablesAsFiles) {
  open();
  for (const char* name :
       {"verdicts.csv", "measures.csv", "stage_times.csv", "timings.csv", "verdicts.json"}) {
    browser_.click(browser_.middle_of("a[download='" + std::string(name) + "']"));
    EXPECT_EQ(made::text_of(browser_.downloaded(name)), made::text_of(report_ / name)) << name;
  }
  EXPECT_TRUE(browser_.complaints().empty());
}

}  // namespace
}  // namespace stope::report
