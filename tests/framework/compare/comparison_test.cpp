#include "framework/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "framework/compare/equal_recordings.hpp"

namespace stope {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Two arms, `old` and `new`, on the recordings named; by one metric. All pending.
Comparison table(const std::vector<std::string>& recordings,
                 const std::vector<std::uint64_t>& seeds) {
  Comparison made;
  made.arms = {{"old", {}, {}, {}}, {"new", {}, {}, {}}};
  for (const std::string& name : recordings) made.recordings.push_back({name, {}, {}});
  made.seeds = seeds;
  made.metrics = {{"apls", "score", "apls", Direction::kHigher, 0.01, ""}};
  made.cells = empty_cells(made);
  return made;
}

void finish(ComparedCell& cell, double measure, const std::string& sha256 = "") {
  cell.status = CellStatus::kDone;
  cell.measures = {measure};
  cell.artefacts = {{"roads.geojson", "", sha256, 0, CellArtefact::Kind::kGeojson, false}};
}

TEST(Comparison, PlacesOfCellsGoByRecordingThenSeedThenArm) {
  const Comparison made = table({"a", "b", "c"}, {4, 5});
  for (const ComparedCell& cell : made.cells)
    EXPECT_EQ(&made.cell(cell.arm, cell.recording, cell.seed), &cell);
}

TEST(MeasuredPairs, AreMeansOverTheSeedsThatBothArmsHave) {
  Comparison made = table({"pit"}, {1, 2, 3});
  finish(made.cell(0, 0, 0), 0.5);
  finish(made.cell(1, 0, 0), 0.6);
  finish(made.cell(0, 0, 1), 0.7);
  finish(made.cell(1, 0, 1), 0.9);
  finish(made.cell(0, 0, 2), 99);  // the other arm failed on this seed
  made.cell(1, 0, 2).status = CellStatus::kFailed;
  const auto measured = measured_pairs(made, 1);
  ASSERT_EQ(measured.size(), 1U);
  ASSERT_EQ(measured[0].pairs.size(), 1U);
  EXPECT_DOUBLE_EQ(measured[0].pairs[0].baseline, 0.6);
  EXPECT_DOUBLE_EQ(measured[0].pairs[0].arm, 0.75);
  EXPECT_EQ(measured[0].smallest_that_matters, 0.01);
}

TEST(MeasuredPairs, LeaveOutRecordingsWithoutAFiniteFigureOnBothArms) {
  Comparison made = table({"a", "b"}, {0});
  finish(made.cell(0, 0, 0), 0.5);
  finish(made.cell(1, 0, 0), kNothing);
  finish(made.cell(0, 1, 0), 0.5);
  finish(made.cell(1, 1, 0), 0.6);
  const auto measured = measured_pairs(made, 1);
  ASSERT_EQ(measured[0].pairs.size(), 1U);
  EXPECT_EQ(measured[0].pairs[0].recording, "b");
}

TEST(NoteEqualRecordings, AreFoundByTheirSourcesOrByAllThatTheyLeft) {
  Comparison made = table({"a", "b", "c", "d"}, {0});
  note_equal_recordings(made, {"1", "2", "1", "2", "3", "4", "5", ""});
  EXPECT_EQ(made.recordings[1].same_as, "a");
  EXPECT_EQ(made.recordings[2].same_as, "");
  EXPECT_EQ(made.recordings[3].same_as, "") << "one of its sources may give other bytes each time";
  for (std::size_t recording : {0U, 1U, 2U, 3U})
    for (std::size_t arm : {0U, 1U})
      finish(made.cell(arm, recording, 0), 0.5, recording == 2 ? "other" : "f00d");
  const SourceKeys unlike{"1", "2", "1", "2", "3", "4", "5", "6"};
  note_equal_recordings(made, unlike);
  EXPECT_EQ(made.recordings[2].same_as, "") << "equal figures alone say nothing";
  EXPECT_EQ(made.recordings[3].same_as, "a");
  EXPECT_EQ(made.warnings.size(), 2U);
  EXPECT_EQ(distinct_recordings(made), (std::vector<std::vector<std::size_t>>{{0, 1, 3}, {2}}));
  note_equal_recordings(made, unlike);
  EXPECT_EQ(made.warnings.size(), 2U) << "said once";
}

TEST(NoteEqualRecordings, AreNotThoseOfWhichOnlyMeasuresAreKeptOrOneFailed) {
  Comparison made = table({"a", "b"}, {0});
  for (ComparedCell& cell : made.cells) {
    finish(cell, 0.5, "f00d");
    cell.artefacts[0].kind = CellArtefact::Kind::kMeasures;
  }
  const SourceKeys unlike{"1", "2", "3", "4"};
  note_equal_recordings(made, unlike);
  EXPECT_EQ(made.recordings[1].same_as, "");
  for (ComparedCell& cell : made.cells) finish(cell, 0.5, "f00d");
  made.cell(1, 1, 0).status = CellStatus::kFailed;
  note_equal_recordings(made, unlike);
  EXPECT_EQ(made.recordings[1].same_as, "");
}

TEST(OutputsIdentical, NeedsTheSameFilesAndMeasuresInAllCells) {
  Comparison made = table({"a", "b"}, {0});
  EXPECT_FALSE(outputs_identical(made, 0, 1)) << "nothing was run";
  for (std::size_t recording : {0U, 1U})
    for (std::size_t arm : {0U, 1U}) finish(made.cell(arm, recording, 0), kNothing, "f00d");
  EXPECT_TRUE(outputs_identical(made, 0, 1));
  EXPECT_TRUE(measured_pairs(made, 1)[0].outputs_identical);
  made.cell(1, 1, 0).artefacts[0].sha256 = "beef";
  EXPECT_FALSE(outputs_identical(made, 0, 1));
  made.cell(1, 1, 0).artefacts[0].sha256 = "f00d";
  made.cell(1, 1, 0).measures[0] = 0;
  EXPECT_FALSE(outputs_identical(made, 0, 1));
}

}  // namespace
}  // namespace stope
