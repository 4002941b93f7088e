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
};

/// A measure compared. Differences are arm - baseline, turned so that above 0 the arm is better.
struct ComparedMeasure {
  std::string measure;
  Verdict verdict = Verdict::kNoDifferenceShown;
  bool matters = false;  ///< better or worse by more than delta, all of the interval
  double mean_difference = 0;
  Interval interval;                  ///< of the mean difference, 95 %
  double probability = 1;             ///< by sign flips
  double adjusted = 1;                ///< by Holm, over the measures compared together
  std::vector<double> differences;    ///< by recording, of those that count
  std::vector<std::string> excluded;  ///< recordings with a measure that is not finite
};

constexpr std::size_t kLeastRecordings = 6;

/// Compares two arms by several measures at once. Deterministic for a seed.
std::vector<ComparedMeasure> compare(const std::vector<MeasuredPairs>& measures,
                                     std::uint64_t seed);

/// The verdict as a person reads it, such as `better, and it matters`.
std::string text_of(const ComparedMeasure& compared);

}  // namespace stope
