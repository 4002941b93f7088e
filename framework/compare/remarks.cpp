#include "framework/compare/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

/// The best that became of an arm on a recording, under any of its names and with any seed.
CellStatus fate_of(const Comparison& comparison, std::size_t arm,
                   const std::vector<std::size_t>& names) {
  CellStatus best = CellStatus::kExcluded;
  const auto rank = [](CellStatus status) {
    switch (status) {
      case CellStatus::kDone:
        return 3;
      case CellStatus::kPending:
        return 2;
      case CellStatus::kFailed:
        return 1;
      case CellStatus::kExcluded:
        break;
    }
    return 0;
  };
  for (const std::size_t recording : names)
    for (std::size_t seed = 0; seed < comparison.seeds.size(); ++seed) {
      const CellStatus status = comparison.cell(arm, recording, seed).status;
      if (rank(status) > rank(best)) best = status;
    }
  return best;
}

void count(CellStatus fate, std::size_t& failed, std::size_t& lacks) {
  failed += fate == CellStatus::kFailed ? 1 : 0;
  lacks += fate == CellStatus::kExcluded ? 1 : 0;
}

std::string equal_text(const std::vector<std::string>& names, std::size_t recordings) {
  return fmt::format(
      "All {} differences in {} are equal to the last bit, which different recordings hardly give, "
      "unless the metric counts in steps: look whether they are one recording under several names.",
      recordings, quoted_list(names));
}

}  // namespace

Losses losses_of(const Comparison& comparison, std::size_t arm) {
  Losses losses;
  for (const std::vector<std::size_t>& names : distinct_recordings(comparison)) {
    ++losses.recordings;
    if (comparison.cells.empty()) continue;
    count(fate_of(comparison, arm, names), losses.arm_failed, losses.arm_lacks);
    count(fate_of(comparison, comparison.baseline, names), losses.baseline_failed,
          losses.baseline_lacks);
  }
  return losses;
}

std::string losses_text(const Comparison& comparison, std::size_t arm) {
  const Losses losses = losses_of(comparison, arm);
  std::string text;
  const auto add = [&](std::size_t place, const char* what, std::size_t count) {
    if (count > 0)
      text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", comparison.arms[place].name, what,
                          count);
  };
  add(arm, "failed on", losses.arm_failed);
  add(arm, "lacks", losses.arm_lacks);
  add(comparison.baseline, "failed on", losses.baseline_failed);
  add(comparison.baseline, "lacks", losses.baseline_lacks);
  return text;
}

std::string too_few_text(std::size_t recordings, std::size_t tests) {
  ComparedMeasure asked;
  asked.differences.resize(recordings);
  asked.tests = tests;
  if (tests == 0 || asked.can_show()) return {};
  const std::size_t needed = recordings_needed(tests);
  return fmt::format("{} cannot show any difference beside {}, however clear: {}.",
                     recordings == 1 ? "One recording" : fmt::format("{} recordings", recordings),
                     tests == 1 ? "one test" : fmt::format("{} tests", tests),
                     needed > recordings ? fmt::format("it takes {}", needed)
                                         : "no number of them can, judge by fewer metrics");
}

std::vector<std::string> remarks_of(const Comparison& comparison, const ArmVerdicts& verdicts) {
  std::vector<std::string> remarks;
  if (verdicts.twin)
    remarks.push_back(fmt::format(
        "{} and {} left the very same files and figures in every run: they are counted once.",
        comparison.arms[verdicts.arm].name, comparison.arms[*verdicts.twin].name));
  std::vector<std::string> equal;
  std::size_t recordings = 0;
  bool said = false;
  for (const ComparedMeasure& measure : verdicts.measures) {
    if (measure.tests > 0 && !measure.can_show() && !said) {
      remarks.push_back(too_few_text(measure.differences.size(), measure.tests));
      said = true;
    }
    // That they are all 0 is said with the verdict.
    if (measure.tests == 0 || !measure.all_equal() || measure.differences.front() == 0) continue;
    equal.push_back(measure.measure);
    recordings = std::max(recordings, measure.differences.size());
  }
  if (!equal.empty()) remarks.push_back(equal_text(equal, recordings));
  return remarks;
}

std::string expected_remark(std::size_t recordings, std::size_t arms, std::size_t metrics) {
  const std::size_t beside = arms > 0 ? arms - 1 : 0;
  std::string text = too_few_text(recordings, beside * metrics);
  if (!text.empty())
    text += fmt::format(" There {} {} beside the baseline and {}.", beside == 1 ? "is" : "are",
                        beside == 1 ? "one arm" : fmt::format("{} arms", beside),
                        metrics == 1 ? "one metric" : fmt::format("{} metrics", metrics));
  return text;
}

std::string expected_remark(const Comparison& comparison) {
  std::size_t arms = 0, recordings = 0;
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
    arms += comparison.arms[arm].same_as.empty() ? 1 : 0;
    if (arm == comparison.baseline) continue;
    std::size_t common = 0;
    for (const std::vector<std::size_t>& names : distinct_recordings(comparison))
      if (fate_of(comparison, arm, names) != CellStatus::kExcluded &&
          fate_of(comparison, comparison.baseline, names) != CellStatus::kExcluded)
        ++common;
    recordings = std::max(recordings, common);
  }
  return expected_remark(recordings, arms, comparison.metrics.size());
}

}  // namespace stope
