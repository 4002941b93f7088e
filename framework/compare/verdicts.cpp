#include "framework/compare/verdicts.hpp"

#include <algorithm>
#include <iterator>

namespace stope {
namespace {

constexpr std::uint64_t kSeed = 0;

/// The first arm that does what this one does: itself, if no other.
std::size_t original_of(const Comparison& comparison, std::size_t arm) {
  const std::string& name = comparison.arms[arm].same_as;
  if (name.empty()) return arm;
  const auto found = std::find_if(comparison.arms.begin(), comparison.arms.end(),
                                  [&](const ComparedArm& other) { return other.name == name; });
  return found == comparison.arms.end() ? arm
                                        : static_cast<std::size_t>(found - comparison.arms.begin());
}

/// The first earlier arm, the baseline aside, that left the very same in every cell.
std::optional<std::size_t> twin_of(const Comparison& comparison, std::size_t arm) {
  const auto same_fate = [&](std::size_t other) {
    return std::all_of(
        comparison.cells.begin(), comparison.cells.end(), [&](const ComparedCell& cell) {
          return cell.arm != arm ||
                 comparison.cell(other, cell.recording, cell.seed).status == cell.status;
        });
  };
  for (std::size_t other = 0; other < arm; ++other)
    if (other != comparison.baseline && same_fate(other) &&
        outputs_identical(comparison, arm, other))
      return other;
  return std::nullopt;
}

bool any_pending(const Comparison& comparison, std::size_t arm) {
  return std::any_of(comparison.cells.begin(), comparison.cells.end(),
                     [&](const ComparedCell& cell) {
                       return (cell.arm == arm || cell.arm == comparison.baseline) &&
                              cell.status == CellStatus::kPending;
                     });
}

void count_missing(const Comparison& comparison, ComparedMeasure& measure) {
  measure.excluded.clear();
  for (const std::vector<std::size_t>& names : distinct_recordings(comparison)) {
    const std::string& name = comparison.recordings[names.front()].name;
    if (std::find(measure.recordings.begin(), measure.recordings.end(), name) ==
        measure.recordings.end())
      measure.excluded.push_back(name);
  }
}

}  // namespace

std::vector<ArmVerdicts> verdicts_of(const Comparison& comparison) {
  std::vector<ArmVerdicts> all;
  std::vector<MeasuredPairs> family;
  std::vector<std::size_t> begin(comparison.arms.size());  // of each arm's place in the family
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
    if (arm == comparison.baseline) continue;
    all.push_back({arm, {}, {}});
    const std::size_t original = original_of(comparison, arm);
    // A copy of the baseline has no other verdicts to show than that it is one.
    if (original < arm && original != comparison.baseline) {
      begin[arm] = begin[original];
      continue;
    }
    if (original == arm && !outputs_identical(comparison, arm, comparison.baseline))
      all.back().twin = twin_of(comparison, arm);
    if (all.back().twin) {
      begin[arm] = begin[*all.back().twin];
      continue;
    }
    begin[arm] = family.size();
    std::vector<MeasuredPairs> pairs = measured_pairs(comparison, arm);
    std::move(pairs.begin(), pairs.end(), std::back_inserter(family));
  }
  const std::vector<ComparedMeasure> compared = compare(family, kSeed);
  for (ArmVerdicts& verdicts : all)
    for (std::size_t metric = 0; metric < comparison.metrics.size(); ++metric) {
      ComparedMeasure& measure =
          verdicts.measures.emplace_back(compared[begin[verdicts.arm] + metric]);
      count_missing(comparison, measure);
      if (measure.verdict == Verdict::kTooFew && measure.differences.empty() &&
          !any_pending(comparison, verdicts.arm))
        measure.verdict = Verdict::kNoFigure;
    }
  return all;
}

}  // namespace stope
