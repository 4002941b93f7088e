#include "framework/compare/statistics/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "framework/compare/statistics/holm.hpp"
#include "framework/compare/statistics/sign_flip.hpp"
#include "stope/random.hpp"

namespace stope {
namespace {

constexpr double kLeastSure = 0.05;

ComparedMeasure measure_differences(const MeasuredPairs& measured, std::uint64_t seed) {
  ComparedMeasure compared;
  compared.measure = measured.measure;
  compared.smallest_that_matters = measured.smallest_that_matters;
  for (const Pair& pair : measured.pairs) {
    if (!std::isfinite(pair.baseline) || !std::isfinite(pair.arm)) {
      compared.excluded.push_back(pair.recording);
      continue;
    }
    compared.recordings.push_back(pair.recording);
    compared.baseline_mean += pair.baseline;
    compared.arm_mean += pair.arm;
    const double difference = pair.arm - pair.baseline;
    // Not -difference: a difference of 0 must not become -0.
    compared.differences.push_back(
        measured.direction == Direction::kHigher ? difference : pair.baseline - pair.arm);
  }
  if (compared.differences.empty()) return compared;
  compared.baseline_mean /= static_cast<double>(compared.differences.size());
  compared.arm_mean /= static_cast<double>(compared.differences.size());
  compared.mean_difference = mean_of(compared.differences);
  BootstrapRules rules;
  rules.seed = mix_seed(seed, 0);
  compared.interval = small_sample_interval(compared.differences, mean_of, rules);
  compared.probability = sign_flip_probability(compared.differences, mix_seed(seed, 1));
  return compared;
}

Verdict verdict_of(const ComparedMeasure& compared, const MeasuredPairs& measured) {
  if (measured.outputs_identical) return Verdict::kIdentical;
  if (compared.differences.size() < kLeastRecordings) return Verdict::kTooFew;
  const double delta = measured.smallest_that_matters;
  if (compared.interval.excludes(0) && compared.adjusted < kLeastSure)
    return compared.mean_difference > 0 ? Verdict::kBetter : Verdict::kWorse;
  if (delta > 0 && compared.interval.inside(-delta, delta)) return Verdict::kSame;
  return Verdict::kNoDifferenceShown;
}

Weight weight_of(const Interval& interval, double delta) {
  if (delta > 0 && (interval.low > delta || interval.high < -delta)) return Weight::kMatters;
  if (delta > 0 && interval.inside(-delta, delta)) return Weight::kNegligible;
  return Weight::kUnclear;
}

std::string weighed(const std::string& word, const ComparedMeasure& compared) {
  if (compared.smallest_that_matters <= 0) return word;
  switch (compared.weight) {
    case Weight::kMatters:
      return word + ", and it matters";
    case Weight::kNegligible:
      return word + ", but by too little to matter";
    case Weight::kUnclear:
      break;
  }
  return word + ", perhaps by too little to matter";
}

bool enough(std::size_t recordings, std::size_t tests) {
  return recordings >= kLeastRecordings &&
         static_cast<double>(tests) * least_probability(recordings) < kLeastSure;
}

}  // namespace

bool ComparedMeasure::all_equal() const {
  return differences.size() > 1 && std::all_of(differences.begin(), differences.end(),
                                               [&](double d) { return d == differences.front(); });
}

bool ComparedMeasure::can_show() const { return enough(differences.size(), tests); }

std::size_t recordings_needed(std::size_t tests) {
  std::size_t recordings = kLeastRecordings;
  // Past 500 tests no number of them would do: the chances are not counted that finely.
  while (recordings < 20 && !enough(recordings, tests)) ++recordings;
  return recordings;
}

std::vector<ComparedMeasure> compare(const std::vector<MeasuredPairs>& measures,
                                     std::uint64_t seed) {
  std::vector<ComparedMeasure> result;
  std::vector<double> probabilities;
  std::vector<std::size_t> tested;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    result.push_back(measure_differences(measures[i], seed));
    // What is not tested is no occasion for a false alarm.
    if (measures[i].outputs_identical || result[i].differences.size() < kLeastRecordings) continue;
    tested.push_back(i);
    probabilities.push_back(result[i].probability);
  }
  const std::vector<double> adjusted = holm(probabilities);
  for (std::size_t i = 0; i < tested.size(); ++i) {
    result[tested[i]].adjusted = adjusted[i];
    result[tested[i]].tests = tested.size();
  }
  for (std::size_t i = 0; i < measures.size(); ++i) {
    result[i].verdict = verdict_of(result[i], measures[i]);
    result[i].weight = weight_of(result[i].interval, measures[i].smallest_that_matters);
  }
  return result;
}

std::string text_of(const ComparedMeasure& compared) {
  switch (compared.verdict) {
    case Verdict::kIdentical:
      return "identical outputs";
    case Verdict::kTooFew:
      return "too few recordings to say";
    case Verdict::kBetter:
      return weighed("better", compared);
    case Verdict::kWorse:
      return weighed("worse", compared);
    case Verdict::kSame:
      return "the same";
    case Verdict::kNoDifferenceShown:
      return "no difference shown";
    case Verdict::kNoFigure:
      return "no usable figure on any recording";
  }
  return "";
}

}  // namespace stope
