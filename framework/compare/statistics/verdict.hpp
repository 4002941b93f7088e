#pragma once

#include <string>
#include <vector>

#include "framework/compare/statistics/bootstrap.hpp"

namespace stope {

/// Which way a measure is good.
enum class Direction : int { kHigher, kLower };

/// One recording's measure under the two arms, each the mean over its seeds.
struct Pair {
  std::string recording;
  double baseline = 0, arm = 0;
};

/// What two arms gave for one measure.
struct MeasuredPairs {
  std::string measure;
  Direction direction = Direction::kHigher;
  double smallest_that_matters = 0;  ///< delta, in the measure's unit
  std::vector<Pair> pairs;
  bool outputs_identical = false;  ///< bit for bit, on every recording
};

/// What may be said of two arms.
enum class Verdict : int {
  kIdentical,          ///< their outputs are the same bytes: nothing to compare
  kTooFew,             ///< fewer than six recordings
  kBetter,             ///< the interval excludes 0 and the adjusted chance is below 0.05
  kWorse,              ///< the same, the other way
  kSame,               ///< the interval lies within +- delta
  kNoDifferenceShown,  ///< anything else: not that there is none
  kNoFigure,           ///< on no recording do both have one, and none is left to run
};

/// Whether a difference that was shown is large enough to care.
enum class Weight : int {
  kMatters,     ///< all of the interval lies beyond delta
  kUnclear,     ///< some of it
  kNegligible,  ///< none of it: surely there, surely small
};

/// Fewer say nothing: six that agree have a chance of 2 / 64.
constexpr std::size_t kLeastRecordings = 6;

/// A measure compared. Differences are arm - baseline, turned so that above 0 the arm is better.
struct ComparedMeasure {
  std::string measure;
  Verdict verdict = Verdict::kNoDifferenceShown;
  Weight weight = Weight::kUnclear;        ///< of one that is better or worse
  double smallest_that_matters = 0;        ///< delta; 0: not stated, and nothing is said of weight
  double baseline_mean = 0, arm_mean = 0;  ///< over the recordings that count
  double mean_difference = 0;
  Interval interval;                    ///< of the mean difference, 95 %: small_sample_interval
  double probability = 1;               ///< by sign flips
  double adjusted = 1;                  ///< by Holm, over the measures compared together
  std::size_t tests = 0;                ///< how many that were
  std::vector<std::string> recordings;  ///< that count
  std::vector<double> differences;      ///< of each of them
  std::vector<std::string> excluded;    ///< recordings with a measure that is not finite

  bool matters() const { return weight == Weight::kMatters; }
  /// Whether the interval may be believed: resampling fewer than six values says nothing.
  bool has_interval() const { return differences.size() >= kLeastRecordings; }
  /// Whether there are several differences, and all are the same to the last bit.
  bool all_equal() const;
  /// Whether so few recordings can show anything at all beside so many tests.
  bool can_show() const;
};

/// How many recordings it takes before a difference that all of them agree on can be shown beside
/// so many tests: 6 for one, 7 for two or three, 10 for up to 25.
std::size_t recordings_needed(std::size_t tests);

/// Compares by several measures at once, which need not be of the same two arms: all of them are
/// chances of a false alarm, so all are adjusted for together. Deterministic for a seed, and what
/// is found of one does not depend on its place among the others but for the adjustment.
std::vector<ComparedMeasure> compare(const std::vector<MeasuredPairs>& measures,
                                     std::uint64_t seed);

/// The verdict as a person reads it, such as `better, and it matters`.
std::string text_of(const ComparedMeasure& compared);

}  // namespace stope
