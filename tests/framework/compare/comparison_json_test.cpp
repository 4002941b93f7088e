#include "framework/compare/comparison_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stope/error.hpp"

namespace stope {
namespace {

Comparison sample() {
  Comparison made;
  made.name = "watershed-vs-voronoi";
  made.file = "pipelines/compare/e.yaml";
  made.id = "0123";
  made.baseline = 1;
  made.arms = {{"new", {"roads.use=topology/voronoi"}, {"roads = topology/voronoi()"}, "old"},
               {"old", {}, {}, ""}};
  made.recordings = {{"pit", {"seed=7"}, {}}};
  made.seeds = {0, 5};
  made.metrics = {{"apls", "score", "apls", Direction::kLower, 0.01, "m"}};
  made.cells = empty_cells(made);
  ComparedCell& done = made.cell(0, 0, 1);
  done.status = CellStatus::kDone;
  done.key = "abc";
  done.folder = "arms/new/pit/5";
  done.measures = {std::numeric_limits<double>::quiet_NaN()};
  done.artefacts = {{"roads.png", "arms/new/pit/5/outputs/roads.png", "f00d", 12,
                     CellArtefact::Kind::kPicture, true}};
  done.stages = {{"roads", "topology/voronoi", StageFate::kShared, 0.25, 1},
                 {"scans", "source/kitti", StageFate::kNotNeeded, -1, 0}};
  ComparedCell& failed = made.cell(1, 0, 0);
  failed.status = CellStatus::kFailed;
  failed.sentence = "it broke \xff";
  failed.failed_stage = "roads";
  made.exclusions = {{"new", "pit", 5, "apls", "it is nan"}};
  made.timings = {{0, 0, 1, {1.5, 2}, {0.1, 1e-9}, "cafe"}};
  made.warnings = {"a warning"};
  return made;
}

TEST(ComparisonJson, ReadsBackWhatItWrote) {
  const Comparison read = read_comparison_json(comparison_json(sample()));
  EXPECT_EQ(comparison_json(read), comparison_json(sample()));
  EXPECT_EQ(read.baseline, 1U);
  EXPECT_TRUE(std::isnan(read.cell(0, 0, 1).measures[0]));
  EXPECT_EQ(read.cell(0, 0, 1).stages[1].seconds, -1);
  EXPECT_EQ(read.cell(0, 0, 1).artefacts[0].kind, CellArtefact::Kind::kPicture);
  EXPECT_EQ(read.cell(1, 0, 0).status, CellStatus::kFailed);
  EXPECT_EQ(read.metrics[0].direction, Direction::kLower);
  EXPECT_EQ(read.timings[0].arm_seconds[1], 1e-9);
}

TEST(ComparisonJson, RefusesWhatItDidNotWrite) {
  const std::string whole = comparison_json(sample());
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[1]"), whole.substr(0, whole.size() / 2)})
    EXPECT_THROW(read_comparison_json(text), Error) << text;
  std::string other = whole;
  other.replace(other.find("\"format\": 1"), 11, "\"format\": 9");
  EXPECT_THROW(read_comparison_json(other), Error);
  std::string fewer = whole;
  fewer.replace(fewer.find("\"seeds\": ["), 10, "\"seeds\": [3,");
  EXPECT_THROW(read_comparison_json(fewer), Error);
}

}  // namespace
}  // namespace stope
