#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/compare/remarks.hpp"
#include "framework/compare/report/downloads.hpp"
#include "framework/compare/report/finding.hpp"
#include "framework/compare/words.hpp"

namespace stope::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json metric_json(const ComparedMetric& metric) {
  return {{"name", metric.name},
          {"stage", metric.stage},
          {"measure", metric.measure},
          {"unit", metric.unit},
          {"direction", metric.direction == Direction::kHigher ? "higher" : "lower"},
          {"delta", metric.smallest_that_matters}};
}

Json measure_json(const ComparedMeasure& measure) {
  Json json{{"metric", measure.measure},
            {"verdict", words::word_for(measure.verdict, words::kVerdicts)},
            {"text", text_of(measure)},
            {"matters", measure.matters() && (measure.verdict == Verdict::kBetter ||
                                              measure.verdict == Verdict::kWorse)}};
  if (!measure.differences.empty()) {
    json["difference"] = number(measure.mean_difference);
    json["interval"] = measure.has_interval()
                           ? Json{number(measure.interval.low), number(measure.interval.high)}
                           : Json(nullptr);
    json["baseline_mean"] = number(measure.baseline_mean);
    json["arm_mean"] = number(measure.arm_mean);
  }
  if (measure.tests > 0) {
    json["p"] = measure.probability;
    json["p_adjusted"] = measure.adjusted;
    json["tests"] = measure.tests;
    json["can_show"] = measure.can_show();
  }
  Json differences = Json::object();
  for (std::size_t i = 0; i < measure.differences.size(); ++i)
    differences[measure.recordings[i]] = number(measure.differences[i]);
  json["differences"] = differences;
  json["excluded"] = measure.excluded;
  return json;
}

Json losses_json(const Losses& losses) {
  return {{"recordings", losses.recordings},
          {"arm_failed", losses.arm_failed},
          {"arm_lacks", losses.arm_lacks},
          {"baseline_failed", losses.baseline_failed},
          {"baseline_lacks", losses.baseline_lacks}};
}

Json run_json_of(const Comparison& comparison, const ComparedCell& cell) {
  Json measures = Json::object();
  for (std::size_t i = 0; i < cell.measures.size() && i < comparison.metrics.size(); ++i)
    measures[comparison.metrics[i].name] = number(cell.measures[i]);
  return {{"recording", comparison.recordings[cell.recording].name},
          {"seed", cell.run_seed},
          {"arm", comparison.arms[cell.arm].name},
          {"status", words::word_for(cell.status, words::kStatuses)},
          {"measures", measures}};
}

Json timed_json(const Comparison& comparison, const TimedPair& timed) {
  return {{"recording", comparison.recordings[timed.recording].name},
          {"seed", comparison.cell(timed.arm, timed.recording, timed.seed).run_seed},
          {"arm", comparison.arms[timed.arm].name},
          {"baseline_seconds", timed.baseline_seconds},
          {"arm_seconds", timed.arm_seconds}};
}

}  // namespace

std::string verdicts_json(const Comparison& comparison, const std::vector<ArmVerdicts>& verdicts) {
  Json arms = Json::array(), metrics = Json::array(), found = Json::array(),
       exclusions = Json::array(), runs = Json::array(), timings = Json::array();
  for (const ComparedArm& arm : comparison.arms)
    arms.push_back({{"name", arm.name},
                    {"overrides", arm.overrides},
                    {"same_as", arm.same_as.empty() ? Json(nullptr) : Json(arm.same_as)}});
  for (const ComparedMetric& metric : comparison.metrics) metrics.push_back(metric_json(metric));
  for (const ArmVerdicts& arm : verdicts) {
    Json measures = Json::array();
    for (const ComparedMeasure& measure : arm.measures) measures.push_back(measure_json(measure));
    found.push_back(
        {{"arm", comparison.arms[arm.arm].name},
         {"finding", finding_text(comparison, arm)},
         {"same_outputs_as", arm.twin ? Json(comparison.arms[*arm.twin].name) : Json(nullptr)},
         {"lost", losses_json(losses_of(comparison, arm.arm))},
         {"metrics", measures}});
  }
  for (const Exclusion& left_out : comparison.exclusions)
    exclusions.push_back(
        {{"arm", left_out.arm},
         {"recording", left_out.recording},
         {"seed", left_out.seed},
         {"metric", left_out.metric.empty() ? Json(nullptr) : Json(left_out.metric)},
         {"sentence", left_out.sentence}});
  for (const ComparedCell& cell : comparison.cells) runs.push_back(run_json_of(comparison, cell));
  for (const TimedPair& timed : comparison.timings)
    timings.push_back(timed_json(comparison, timed));
  const Json json{{"format", 1},
                  {"stope", comparison.version},
                  {"name", comparison.name},
                  {"file", comparison.file.string()},
                  {"base", comparison.base.string()},
                  {"started", comparison.started},
                  {"ended", comparison.ended},
                  {"complete", comparison.complete},
                  {"baseline", comparison.arms[comparison.baseline].name},
                  {"arms", arms},
                  {"seeds", comparison.seeds},
                  {"metrics", metrics},
                  {"verdicts", found},
                  {"exclusions", exclusions},
                  {"runs", runs},
                  {"timings", timings},
                  {"warnings", comparison.warnings}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stope::report
