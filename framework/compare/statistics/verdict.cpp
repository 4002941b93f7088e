#include "framework/compare/statistics/verdict.hpp"

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
  for (const Pair& pair : measured.pairs) {
    if (!std::isfinite(pair.baseline) || !std::isfinite(pair.arm)) {
      compared.excluded.push_back(pair.recording);
      continue;
    }
    const double difference = pair.arm - pair.baseline;
    // Not -difference: a difference of 0 must not become -0.
    compared.differences.push_back(
        measured.direction == Direction::kHigher ? difference : pair.baseline - pair.arm);
  }
  if (compared.differences.empty()) return compared;
  compared.mean_difference = mean_of(compared.differences);
  BootstrapRules rules;
  rules.seed = mix_seed(seed, 0);
  compared.interval = bca_interval(compared.differences, mean_of, rules);
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

}  // namespace

std::vector<ComparedMeasure> compare(const std::vector<MeasuredPairs>& measures,
                                     std::uint64_t seed) {
  std::vector<ComparedMeasure> result;
  std::vector<double> probabilities;
  std::vector<std::size_t> tested;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    result.push_back(measure_differences(measures[i], mix_seed(seed, i)));
    // What is not tested is no occasion for a false alarm.
    if (measures[i].outputs_identical || result[i].differences.size() < kLeastRecordings) continue;
    tested.push_back(i);
    probabilities.push_back(result[i].probability);
  }
  const std::vector<double> adjusted = holm(probabilities);
  for (std::size_t i = 0; i < tested.size(); ++i) result[tested[i]].adjusted = adjusted[i];
  for (std::size_t i = 0; i < measures.size(); ++i) {
    ComparedMeasure& compared = result[i];
    compared.verdict = verdict_of(compared, measures[i]);
    const double delta = measures[i].smallest_that_matters;
    compared.matters = (compared.verdict == Verdict::kBetter && compared.interval.low > delta) ||
                       (compared.verdict == Verdict::kWorse && compared.interval.high < -delta);
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
      return compared.matters ? "better, and it matters" : "better, perhaps by less than matters";
    case Verdict::kWorse:
      return compared.matters ? "worse, and it matters" : "worse, perhaps by less than matters";
    case Verdict::kSame:
      return "the same";
    case Verdict::kNoDifferenceShown:
      return "no difference shown";
  }
  return "";
}

}  // namespace stope
