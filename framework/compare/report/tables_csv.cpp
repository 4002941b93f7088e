#include <fmt/format.h>

#include <cmath>

#include "framework/compare/report/downloads.hpp"
#include "framework/compare/words.hpp"

namespace stope::report {
namespace {

class Csv {
 public:
  explicit Csv(const char* head) : text_(head) { text_ += "\r\n"; }

  Csv& add(const std::string& text) {
    separate();
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
      text_ += text;
    } else {
      text_ += '"';
      for (const char c : text) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
      text_ += '"';
    }
    return *this;
  }
  Csv& add(double value) { return add(std::isfinite(value) ? fmt::format("{}", value) : ""); }
  Csv& add(std::uint64_t count) { return add(std::to_string(count)); }
  void end_line() {
    text_ += "\r\n";
    first_ = true;
  }
  std::string text() && { return std::move(text_); }

 private:
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  std::string text_;
  bool first_ = true;
};

Csv& add_cell(Csv& csv, const Comparison& comparison, const ComparedCell& cell) {
  return csv.add(comparison.recordings[cell.recording].name)
      .add(std::uint64_t{cell.run_seed})
      .add(comparison.arms[cell.arm].name)
      .add(std::string(words::word_for(cell.status, words::kStatuses)));
}

const char* weight_name(const ComparedMeasure& measure) {
  const bool shown = measure.verdict == Verdict::kBetter || measure.verdict == Verdict::kWorse;
  if (!shown || measure.smallest_that_matters <= 0) return "";
  return measure.matters() ? "matters"
                           : (measure.weight == Weight::kNegligible ? "negligible" : "unclear");
}

}  // namespace

std::string verdicts_csv(const Comparison& comparison, const std::vector<ArmVerdicts>& verdicts) {
  Csv csv(
      "arm,baseline,metric,unit,direction,delta,verdict,weight,difference,low,high,baseline_mean,"
      "arm_mean,p,p_adjusted,tests,recordings,excluded");
  for (const ArmVerdicts& arm : verdicts)
    for (std::size_t i = 0; i < arm.measures.size(); ++i) {
      const ComparedMetric& metric = comparison.metrics[i];
      const ComparedMeasure& measure = arm.measures[i];
      const double none = std::nan("");
      const bool any = !measure.differences.empty(), tested = measure.tests > 0;
      csv.add(comparison.arms[arm.arm].name)
          .add(comparison.arms[comparison.baseline].name)
          .add(metric.name)
          .add(metric.unit)
          .add(std::string(metric.direction == Direction::kHigher ? "higher" : "lower"))
          .add(metric.smallest_that_matters)
          .add(std::string(words::word_for(measure.verdict, words::kVerdicts)))
          .add(std::string(weight_name(measure)))
          .add(any ? measure.mean_difference : none)
          .add(measure.has_interval() ? measure.interval.low : none)
          .add(measure.has_interval() ? measure.interval.high : none)
          .add(any ? measure.baseline_mean : none)
          .add(any ? measure.arm_mean : none)
          .add(tested ? measure.probability : none)
          .add(tested ? measure.adjusted : none)
          .add(std::uint64_t{measure.tests})
          .add(std::uint64_t{measure.differences.size()})
          .add(std::uint64_t{measure.excluded.size()})
          .end_line();
    }
  return std::move(csv).text();
}

std::string measures_csv(const Comparison& comparison) {
  Csv csv("recording,seed,arm,status,metric,unit,value");
  for (const ComparedCell& cell : comparison.cells)
    for (std::size_t i = 0; i < comparison.metrics.size(); ++i)
      add_cell(csv, comparison, cell)
          .add(comparison.metrics[i].name)
          .add(comparison.metrics[i].unit)
          .add(i < cell.measures.size() ? cell.measures[i] : std::nan(""))
          .end_line();
  return std::move(csv).text();
}

std::string stage_times_csv(const Comparison& comparison) {
  Csv csv("recording,seed,arm,status,stage,use,fate,seconds,items");
  for (const ComparedCell& cell : comparison.cells)
    for (const CellStage& stage : cell.stages)
      add_cell(csv, comparison, cell)
          .add(stage.name)
          .add(stage.use)
          .add(std::string(words::word_for(stage.fate, words::kFates)))
          .add(stage.seconds < 0 ? std::nan("") : stage.seconds)
          .add(std::uint64_t{stage.items})
          .end_line();
  return std::move(csv).text();
}

std::string timings_csv(const Comparison& comparison) {
  Csv csv("recording,seed,arm,pair,baseline_seconds,arm_seconds");
  for (const TimedPair& timed : comparison.timings)
    for (std::size_t i = 0; i < timed.arm_seconds.size() && i < timed.baseline_seconds.size(); ++i)
      csv.add(comparison.recordings[timed.recording].name)
          .add(std::uint64_t{comparison.cell(timed.arm, timed.recording, timed.seed).run_seed})
          .add(comparison.arms[timed.arm].name)
          .add(std::uint64_t{i})
          .add(timed.baseline_seconds[i])
          .add(timed.arm_seconds[i])
          .end_line();
  return std::move(csv).text();
}

std::vector<Download> downloads_of(const Comparison& comparison,
                                   const std::vector<ArmVerdicts>& verdicts) {
  std::vector<Download> downloads{
      {"verdicts.csv", "text/csv", "a line an arm and metric", verdicts_csv(comparison, verdicts)},
      {"measures.csv", "text/csv", "a line a run and metric", measures_csv(comparison)},
      {"stage_times.csv", "text/csv", "a line a run and stage", stage_times_csv(comparison)}};
  if (!comparison.timings.empty())
    downloads.push_back(
        {"timings.csv", "text/csv", "a line a pair taken in turns", timings_csv(comparison)});
  downloads.push_back({"verdicts.json", "application/json",
                       "what was found, and the figures it was found from",
                       verdicts_json(comparison, verdicts)});
  return downloads;
}

}  // namespace stope::report
