#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "framework/compare/statistics/verdict.hpp"

/// What a comparison gave, whole or so far: plain data that knows of no file and no plan. `stope
/// compare` fills it, framework/compare/comparison_json writes and reads it, and the report is
/// drawn from it alone, so that a report can be made again without running anything.
///
/// Arms, recordings and seeds span a table; a ComparedCell is one run in it. Cells name them by
/// their place in these lists.
namespace stope {

/// One variant of the pipeline.
struct ComparedArm {
  std::string name;                    ///< a file name: letters, digits, `-`, `_`, `.`, `=`, `+`
  std::vector<std::string> overrides;  ///< as `--set` would take them: `roads.use=topology/voronoi`
  /// What the experiment makes of the pipeline in this arm, a line a stage, for people:
  /// `roads = topology/voronoi(in: scans.truth_grid; min_clearance: 3 m)`. As planned for the first
  /// recording it has.
  std::vector<std::string> plan;
  /// The first earlier arm that does the very same in every recording (equal keys), or empty. Such
  /// an arm was not run a second time; its cells are copies.
  std::string same_as;
};

/// One recording: what the statistics count.
struct ComparedRecording {
  std::string name;                    ///< a file name, as an arm's
  std::vector<std::string> overrides;  ///< as an arm's; the run's seed, if it sets one, as `seed=7`
  /// The first earlier recording that this is under another name (note_equal_recordings()), or
  /// empty. The statistics count them as one.
  std::string same_as;
};

/// One measure that arms are judged by.
struct ComparedMetric {
  std::string name;     ///< as the experiment calls it: `apls`
  std::string stage;    ///< whose Measures are read: `score` or `score.measures`
  std::string measure;  ///< the name of the figure in them
  Direction direction = Direction::kHigher;
  double smallest_that_matters = 0;  ///< delta, in `unit`
  std::string unit;                  ///< as the stage gave it, SI; empty: a plain number
};

/// What became of a stage in a run.
enum class StageFate : int {
  kRan,       ///< it was executed in this cell's graph, for this cell alone
  kShared,    ///< it was executed once for this cell and others
  kStored,    ///< its outputs came from the store
  kNotNeeded  ///< nobody asked for what it would have given
};

/// One stage of one cell.
struct CellStage {
  std::string name;  ///< as in the arm's pipeline: `roads`; exports: `outputs/roads.geojson`
  std::string use;   ///< `topology/voronoi`
  StageFate fate = StageFate::kRan;
  /// What it took, without waiting for others: of a map, summed over its items. Also of a stored
  /// one if it was computed earlier in this comparison; negative: not known.
  double seconds = -1;
  std::uint64_t items = 0;  ///< written
};

/// A file that a cell left.
struct CellArtefact {
  enum class Kind : int {
    kPicture,   ///< .png: to be laid side by side
    kGeojson,   ///< .geojson: a road graph, a path, … in metres of the map frame: to be overlaid
    kMeasures,  ///< .json
    kOther
  };
  std::string output;  ///< the entry under `outputs:` it belongs to: `roads.geojson`
  std::string
      path;  ///< relative to Comparison::folder: `arms/voronoi/pit_1/0/outputs/roads.geojson`
  std::string sha256;
  std::uint64_t bytes = 0;
  Kind kind = Kind::kOther;
  bool companion = false;  ///< comes along with the file that was asked for: map.pgm of map.yaml
};

enum class CellStatus : int {
  kPending,  ///< not run yet: the comparison was stopped or goes on
  kDone,
  kFailed,   ///< a stage of it failed
  kExcluded  ///< cannot be run: the arm lacks this recording
};

/// One arm on one recording with one seed.
struct ComparedCell {
  std::size_t arm = 0, recording = 0, seed = 0;  ///< places in the lists of Comparison
  std::uint64_t run_seed = 0;  ///< the recording's own if it sets one, else that of the list
  CellStatus status = CellStatus::kPending;
  std::string sentence;      ///< why it failed or was excluded
  std::string failed_stage;  ///< of a failed one, as in the arm's pipeline; may be empty
  std::string key;     ///< of everything it makes; equal keys, equal bytes. Empty if never planned
  std::string folder;  ///< relative: `arms/voronoi/pit_1/0`; its run.json tells how it was made
  /// By metric, as Comparison::metrics. NaN where there is none, with the reason in
  /// Comparison::exclusions.
  std::vector<double> measures;
  std::vector<CellArtefact> artefacts;  ///< in the order of the pipeline's outputs
  std::vector<CellStage> stages;        ///< in the order of the arm's plan
};

/// Something that is left out of the statistics, and why. Every cell that is failed or excluded is
/// here too (with no metric), so that the number of these is the number of things left out.
struct Exclusion {
  std::string arm, recording;
  std::uint64_t seed = 0;  ///< of the run, itself and not its place
  std::string metric;      ///< empty: all of the cell
  std::string sentence;
};

/// How long an arm's own stages took next to the baseline's: without the store, in turns, so that a
/// machine that slows down slows both.
struct TimedPair {
  std::size_t arm = 0, recording = 0, seed = 0;
  std::vector<double> baseline_seconds, arm_seconds;  ///< one of each a pair, in the order run
  std::string key;  ///< of all that both arms do, and of the threads: equal keys, equal work
};

/// A comparison.
struct Comparison {
  std::string name;
  std::filesystem::path file;    ///< the experiment
  std::filesystem::path base;    ///< the pipeline that arms vary
  std::filesystem::path folder;  ///< what it leaves behind: arms/, comparison.json, report.html
  std::string id;                ///< of this folder's comparison, made when it was begun
  std::string version;           ///< of Stope
  std::string started, ended;    ///< UTC, `2026-11-22T18:12:31.250Z`; `ended` empty: it goes on
  int threads = 0;
  bool complete = false;         ///< no cell is pending
  std::size_t baseline = 0;      ///< place in `arms`
  std::vector<std::string> set;  ///< what all arms change, as `--set` takes it
  std::vector<ComparedArm> arms;
  std::vector<ComparedRecording> recordings;
  std::vector<std::uint64_t> seeds;
  std::vector<ComparedMetric> metrics;
  std::vector<ComparedCell>
      cells;  ///< all of them: for each recording, for each seed, for each arm
  std::vector<Exclusion> exclusions;
  std::vector<TimedPair> timings;     ///< empty unless the experiment asks for them
  std::vector<std::string> warnings;  ///< such as of arms that are equal

  /// Of a cell, in `cells`.
  std::size_t place(std::size_t arm, std::size_t recording, std::size_t seed) const {
    return (recording * seeds.size() + seed) * arms.size() + arm;
  }
  const ComparedCell& cell(std::size_t arm, std::size_t recording, std::size_t seed) const {
    return cells[place(arm, recording, seed)];
  }
  ComparedCell& cell(std::size_t arm, std::size_t recording, std::size_t seed) {
    return cells[place(arm, recording, seed)];
  }
};

/// A table of pending cells for the arms, recordings and seeds of a comparison.
std::vector<ComparedCell> empty_cells(const Comparison& comparison);

/// Whether two cells left the same files and the same figures, bit for bit.
bool same_outputs(const ComparedCell& a, const ComparedCell& b);

/// The recordings, each with all it is called by: places in the list, the first name first.
std::vector<std::vector<std::size_t>> distinct_recordings(const Comparison& comparison);

/// Whether two arms left the same bytes and the same measures in every cell that both have done, of
/// which there must be one.
bool outputs_identical(const Comparison& comparison, std::size_t arm, std::size_t other);

/// What the statistics are made of: for each metric the distinct recordings that both the baseline
/// and the arm have, each the mean over the seeds, and over the names it has, that both have done
/// with a finite figure.
std::vector<MeasuredPairs> measured_pairs(const Comparison& comparison, std::size_t arm);

}  // namespace stope
