#include "framework/compare/report/page_facts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/compare/report/finding.hpp"
#include "framework/compare/report/marks.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

constexpr std::size_t kOpenRows = 12;

std::size_t cells_that(const Comparison& comparison, CellStatus status) {
  return static_cast<std::size_t>(
      std::count_if(comparison.cells.begin(), comparison.cells.end(),
                    [&](const ComparedCell& cell) { return cell.status == status; }));
}

// The mark of what is said first.
const char* style_of(const ArmVerdicts& arm) {
  const char* style = "unknown";
  for (const Verdict wanted :
       {Verdict::kSame, Verdict::kIdentical, Verdict::kWorse, Verdict::kBetter})
    for (const ComparedMeasure& measure : arm.measures)
      if (measure.verdict == wanted) style = mark_of(measure).style;
  return style;
}

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

}  // namespace

std::string comparison_header_html(const Comparison& comparison,
                                   const std::vector<ArmVerdicts>& verdicts) {
  std::string html =
      fmt::format("<header><p class=\"over\">Comparison · Stope {}</p>\n<h1>{}</h1>\n",
                  escaped(comparison.version), escaped(comparison.name));
  if (!comparison.complete)
    html += fmt::format("<p class=\"so-far\">So far: {} of {} runs are done.</p>\n",
                        comparison.cells.size() - cells_that(comparison, CellStatus::kPending),
                        comparison.cells.size());
  for (const ArmVerdicts& arm : verdicts)
    html += fmt::format("<p class=\"finding {}\">{}</p>\n", style_of(arm),
                        escaped(finding_text(comparison, arm)));
  html += "<dl class=\"facts\">\n";
  const auto fact = [&html](const char* name, std::size_t count, const std::string& remark = {}) {
    html += fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>\n", name, count_text(count),
                        remark.empty() ? "" : fmt::format(" <small>{}</small>", escaped(remark)));
  };
  fact("arms", comparison.arms.size(), "baseline " + comparison.arms[comparison.baseline].name);
  const std::size_t recordings = distinct_recordings(comparison).size();
  fact("recordings", recordings,
       recordings == comparison.recordings.size()
           ? ""
           : fmt::format("under {} names", comparison.recordings.size()));
  fact("seeds", comparison.seeds.size(), comparison.seeds.size() > 1 ? "averaged" : "");
  fact("metrics", comparison.metrics.size());
  const std::size_t failed = cells_that(comparison, CellStatus::kFailed);
  fact("runs", comparison.cells.size(),
       failed == 0 ? "none failed" : fmt::format("{} failed", failed));
  fact("left out", comparison.exclusions.size());
  html += "</dl>\n";
  if (!comparison.warnings.empty()) {
    html += "<ul class=\"log\">\n";
    for (const std::string& warning : comparison.warnings)
      html += fmt::format("<li class=\"warning\">{}</li>\n", escaped(warning));
    html += "</ul>\n";
  }
  return html + "</header>\n";
}

std::string exclusions_html(const Comparison& comparison) {
  if (comparison.exclusions.empty()) return {};
  const std::size_t count = comparison.exclusions.size();
  std::string html = fmt::format(
      "<section id=\"left-out\"><h2>Left out</h2>\n<details{}><summary>{} of the statistics"
      "</summary>\n<div class=\"scroll\"><table><thead><tr><th>arm</th><th>recording</th><th "
      "class=\"n\">seed</th><th>metric</th><th>why</th></tr></thead><tbody>\n",
      count <= kOpenRows ? " open=\"open\"" : "",
      count_text(count, "thing is left out", "things are left out"));
  for (const Exclusion& exclusion : comparison.exclusions)
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td>{}</td><td>{}</td></tr>\n",
        escaped(exclusion.arm), escaped(exclusion.recording), exclusion.seed,
        exclusion.metric.empty() ? "<span class=\"soft\">all of the run</span>"
                                 : escaped(exclusion.metric),
        escaped(exclusion.sentence));
  return html + "</tbody></table></div></details></section>\n";
}

std::string comparison_provenance_html(const Comparison& comparison) {
  std::string html = "<section id=\"provenance\"><h2>Provenance</h2>\n<dl>\n";
  const auto fact = [&html](const char* name, const std::string& value) {
    if (!value.empty()) html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escaped(value));
  };
  fact("Stope", comparison.version);
  fact("experiment", comparison.file.string());
  fact("pipeline", comparison.base.string());
  fact("folder", comparison.folder.string());
  fact("comparison", comparison.id);
  fact("started", comparison.started);
  fact("ended", comparison.ended);
  fact("threads", std::to_string(comparison.threads));
  std::string seeds;
  for (const std::uint64_t seed : comparison.seeds)
    seeds += (seeds.empty() ? "" : ", ") + std::to_string(seed);
  fact("seeds", seeds);
  html += "</dl>\n<table><thead><tr><th>arm</th><th>sets</th><th>stages</th></tr></thead><tbody>\n";
  for (const ComparedArm& arm : comparison.arms) {
    std::string plan;
    for (const std::string& line : arm.plan) plan += fmt::format("<li>{}</li>", escaped(line));
    html += fmt::format(
        "<tr><td>{}{}</td><td><code>{}</code></td><td><ul class=\"plan\">{}</ul></td></tr>\n",
        escaped(arm.name),
        arm.same_as.empty()
            ? ""
            : fmt::format("<br/><small>the same as {}</small>", escaped(arm.same_as)),
        escaped(joined(arm.overrides)), plan);
  }
  html +=
      "</tbody></table>\n<table><thead><tr><th>recording</th><th>sets</th></tr></thead><tbody>\n";
  for (const ComparedRecording& recording : comparison.recordings)
    html += fmt::format(
        "<tr><td>{}{}</td><td><code>{}</code></td></tr>\n", escaped(recording.name),
        recording.same_as.empty()
            ? ""
            : fmt::format("<br/><small>the same as {}</small>", escaped(recording.same_as)),
        escaped(joined(recording.overrides)));
  return html + "</tbody></table></section>\n";
}

}  // namespace stope::report
