#include "framework/cli/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "framework/compare/remarks.hpp"
#include "framework/compare/timing.hpp"
#include "framework/compare/verdicts.hpp"

namespace stope {
namespace {

constexpr std::size_t kMostExclusions = 10;

std::string measure_line(const ComparedMetric& metric, const ComparedMeasure& compared,
                         std::size_t width) {
  const std::string name = fmt::format("  {:<{}}  ", metric.name, width);
  if (compared.verdict == Verdict::kIdentical || compared.differences.empty())
    return name + text_of(compared) + "\n";
  const std::string unit = metric.unit.empty() ? "" : fmt::format(" {}", metric.unit);
  const std::size_t count = compared.differences.size();
  return fmt::format(
      "{}{:+.4g} {}{} over {}{}: {}\n", name, compared.mean_difference,
      compared.has_interval()
          ? fmt::format("[{:.4g}, {:.4g}]", compared.interval.low, compared.interval.high)
          : "[–]",
      unit, count,
      compared.excluded.empty() ? "" : fmt::format(" of {}", count + compared.excluded.size()),
      text_of(compared));
}

std::string verdicts_text(const Comparison& comparison) {
  std::size_t width = 0;
  for (const ComparedMetric& metric : comparison.metrics)
    width = std::max(width, metric.name.size());
  std::string text;
  std::vector<std::string> remarks = comparison.warnings;
  bool few = false;
  for (const ArmVerdicts& verdicts : verdicts_of(comparison)) {
    const std::string losses = losses_text(comparison, verdicts.arm);
    text += fmt::format("{} beside {}{}:\n", comparison.arms[verdicts.arm].name,
                        comparison.arms[comparison.baseline].name,
                        losses.empty() ? "" : fmt::format(" ({})", losses));
    for (std::size_t i = 0; i < verdicts.measures.size(); ++i) {
      text += measure_line(comparison.metrics[i], verdicts.measures[i], width);
      few = few ||
            (!verdicts.measures[i].has_interval() && !verdicts.measures[i].differences.empty());
    }
    for (std::string& remark : remarks_of(comparison, verdicts))
      if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end())
        remarks.push_back(std::move(remark));
  }
  if (few)
    remarks.push_back(
        fmt::format("[–]: below {} recordings an interval cannot be believed.", kLeastRecordings));
  for (const std::string& remark : remarks) text += fmt::format("Note: {}\n", remark);
  return text;
}

std::string exclusions_text(const Comparison& comparison) {
  if (comparison.exclusions.empty()) return {};
  std::string text = fmt::format("Left out: {}\n", comparison.exclusions.size());
  for (std::size_t i = 0; i < comparison.exclusions.size() && i < kMostExclusions; ++i) {
    const Exclusion& out = comparison.exclusions[i];
    text += fmt::format("  {} on {}{}: {}\n", out.arm, out.recording,
                        out.metric.empty() ? "" : fmt::format(", {}", out.metric), out.sentence);
  }
  if (comparison.exclusions.size() > kMostExclusions)
    text += fmt::format("  and {} more, in comparison.json\n",
                        comparison.exclusions.size() - kMostExclusions);
  return text;
}

std::string count_text(std::ptrdiff_t recordings) {
  return recordings == 1 ? "one recording, [least, most] of its pairs"
                         : fmt::format("{} recordings", recordings);
}

std::string timings_text(const Comparison& comparison) {
  std::string text;
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
    const auto count = std::count_if(comparison.timings.begin(), comparison.timings.end(),
                                     [&](const TimedPair& timed) { return timed.arm == arm; });
    if (count == 0) continue;
    const TimingSummary summary = summary_of(comparison, arm);
    text += fmt::format(
        "  {}: {:.3g} s, {} {:.3g} s, ratio pair by pair {:.3g} [{:.3g}, {:.3g}] over {}\n",
        comparison.arms[arm].name, summary.arm.median, comparison.arms[comparison.baseline].name,
        summary.baseline.median, summary.ratio.median, summary.ratio.least, summary.ratio.most,
        count_text(count));
  }
  if (text.empty()) return text;
  return "Times of the arms' own stages, medians [least, most]; timings.csv has all of them:\n" +
         text;
}

std::size_t count(const Comparison& comparison, CellStatus status) {
  return static_cast<std::size_t>(
      std::count_if(comparison.cells.begin(), comparison.cells.end(),
                    [&](const ComparedCell& cell) { return cell.status == status; }));
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
  std::string text = fmt::format(
      "{}: {} runs done, {} failed, {} excluded{}.\n", comparison.name,
      count(comparison, CellStatus::kDone), count(comparison, CellStatus::kFailed),
      count(comparison, CellStatus::kExcluded),
      comparison.complete ? "" : fmt::format(", {} left", count(comparison, CellStatus::kPending)));
  text += verdicts_text(comparison) + exclusions_text(comparison) + timings_text(comparison);
  return text + fmt::format("Look at {}\n", (comparison.folder / "report.html").string());
}

nlohmann::ordered_json comparison_end_json(const Comparison& comparison) {
  nlohmann::ordered_json verdicts = nlohmann::ordered_json::array();
  for (const ArmVerdicts& of_arm : verdicts_of(comparison))
    for (std::size_t i = 0; i < of_arm.measures.size(); ++i)
      verdicts.push_back({{"arm", comparison.arms[of_arm.arm].name},
                          {"metric", comparison.metrics[i].name},
                          {"verdict", text_of(of_arm.measures[i])}});
  return {{"end", comparison.complete ? "done" : "cancelled"},
          {"runs_done", count(comparison, CellStatus::kDone)},
          {"runs_failed", count(comparison, CellStatus::kFailed)},
          {"runs_excluded", count(comparison, CellStatus::kExcluded)},
          {"left_out", comparison.exclusions.size()},
          {"folder", comparison.folder.string()},
          {"report", (comparison.folder / "report.html").string()},
          {"verdicts", verdicts}};
}

}  // namespace stope
