#include "framework/compare/report/verdict_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/compare/remarks.hpp"
#include "framework/compare/report/finding.hpp"
#include "framework/compare/report/marks.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

std::string metric_html(const ComparedMetric& metric) {
  std::string remark =
      metric.direction == Direction::kHigher ? "higher is better" : "lower is better";
  if (metric.smallest_that_matters > 0)
    remark += fmt::format(", δ {}{}{}", number_text(metric.smallest_that_matters),
                          metric.unit.empty() ? "" : " ", metric.unit);
  return fmt::format("<th scope=\"row\" title=\"{} of {}\">{} <small>{}</small></th>",
                     escaped(metric.measure), escaped(metric.stage), escaped(metric.name),
                     escaped(remark));
}

std::string excluded_title(const ComparedMeasure& measure) {
  std::string title;
  for (const std::string& recording : measure.excluded)
    title += (title.empty() ? "left out: " : ", ") + recording;
  return title;
}

std::string row(const ComparedMetric& metric, const ComparedMeasure& measure,
                const std::string& losses) {
  const VerdictMark mark = mark_of(measure);
  const std::size_t count = measure.differences.size();
  const double width = measure.has_interval() ? measure.interval.high - measure.interval.low : 0;
  const auto mean = [&](double value) {
    return count == 0 ? std::string("–") : to_width(value, width);
  };
  const std::string left_out =
      measure.excluded.empty()
          ? ""
          : fmt::format(" <small>of {}{}</small>", count + measure.excluded.size(),
                        losses.empty() ? "" : "; " + escaped(losses));
  return fmt::format(
      "<tr>{}<td class=\"said {}\"><b>{}</b> {}</td><td class=\"n\">{}</td><td "
      "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
      "class=\"n\">{}</td><td class=\"n\" title=\"{}\">{}{}</td></tr>\n",
      metric_html(metric), mark.style, mark.sign, escaped(text_of(measure)),
      count == 0 ? "–" : difference_text(measure), mean(measure.baseline_mean),
      mean(measure.arm_mean), measure.tests == 0 ? "–" : chance_text(measure.probability),
      measure.tests == 0 ? "–" : chance_text(measure.adjusted), escaped(excluded_title(measure)),
      count, left_out);
}

std::string remark_html(const std::vector<ArmVerdicts>& verdicts) {
  std::size_t tests = 0;
  for (const ArmVerdicts& arm : verdicts)
    for (const ComparedMeasure& measure : arm.measures) tests = std::max(tests, measure.tests);
  std::string text =
      "Differences are means over recordings, seeds averaged first, turned so that above 0 the arm "
      "is better; brackets hold the true mean difference with 95 % confidence (BCa bootstrap of "
      "10 000 resamples, widened for few recordings), and are empty below six recordings: "
      "resampling so few values says nothing of others. Chance: that equal arms differ as much "
      "(sign flips)";
  if (tests > 1)
    text += fmt::format(
        "; adjusted: for having looked {} times (Holm, over metrics and arms); {} recordings are "
        "the fewest that can show anything beside so many",
        tests, recordings_needed(tests));
  return "<p class=\"soft\">" + text +
         ". Better or worse: 0 lies outside the brackets and the adjusted chance is below 0.05. It "
         "matters: all of the brackets lies beyond δ. The same: all of it lies within ±δ. No "
         "difference shown does not mean that there is none.</p>\n";
}

std::string is_another(const Comparison& comparison, const ArmVerdicts& arm) {
  const std::string& copied = comparison.arms[arm.arm].same_as;
  if (!copied.empty()) return fmt::format(" is {}", escaped(copied));
  if (!arm.twin) return {};
  return fmt::format(" left the same as {}", escaped(comparison.arms[*arm.twin].name));
}

}  // namespace

std::string verdict_table_html(const Comparison& comparison,
                               const std::vector<ArmVerdicts>& verdicts) {
  if (comparison.metrics.empty() || verdicts.empty()) return {};
  const std::string& baseline = comparison.arms[comparison.baseline].name;
  std::string html =
      "<section id=\"verdicts\"><h2>Verdicts</h2>\n<div class=\"scroll\"><table "
      "class=\"verdicts\">\n";
  for (const ArmVerdicts& arm : verdicts) {
    const ComparedArm& compared = comparison.arms[arm.arm];
    html += fmt::format(
        "<thead><tr><th><b class=\"arm\">{}</b>{}</th><th class=\"said\">verdict</th><th "
        "class=\"n\">difference [95 %]</th><th class=\"n\">{}</th><th class=\"n\">{}</th><th "
        "class=\"n\">chance</th><th class=\"n\">adjusted</th><th class=\"n\">recordings</th>"
        "</tr></thead>\n<tbody>",
        escaped(compared.name), is_another(comparison, arm), escaped(baseline),
        escaped(compared.name));
    const std::string losses = losses_text(comparison, arm.arm);
    for (std::size_t i = 0; i < arm.measures.size(); ++i)
      html += row(comparison.metrics[i], arm.measures[i], losses);
    html += "</tbody>\n";
  }
  return html + "</table></div>\n" + remark_html(verdicts) + "</section>\n";
}

}  // namespace stope::report
