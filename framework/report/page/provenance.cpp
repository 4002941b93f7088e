#include "framework/report/page/provenance.hpp"

#include <fmt/format.h>

#include "framework/report/diagnostic_text.hpp"
#include "framework/report/graph/pipeline_graph.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"
#include "framework/report/run_json.hpp"

namespace stope::report {
namespace {

std::string facts_html(const ReportData& data) {
  std::string html = "<dl>\n";
  const auto fact = [&html](const char* name, const std::string& value) {
    if (!value.empty()) html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escaped(value));
  };
  const Machine& machine = data.machine;
  fact("Stope", data.facts.version);
  fact("started", utc_text(data.facts.start));
  fact("machine",
       fmt::format("{}{}{}, {}, {}", machine.host, machine.host.empty() ? "" : ": ",
                   machine.processor,
                   count_text(static_cast<std::uint64_t>(machine.cores), "core", "cores"),
                   bytes_text(machine.memory)));
  fact("system", machine.system);
  fact("threads", count_text(static_cast<std::uint64_t>(data.facts.threads)));
  fact("memory", fmt::format("{} allowed, {} at the most", bytes_text(data.facts.memory),
                             bytes_text(data.record.peak_resident)));
  fact(
      "payloads",
      fmt::format("{} loaded, {} evicted, {} spilled ({})", count_text(data.record.payloads_loaded),
                  count_text(data.record.payloads_evicted),
                  count_text(data.record.payloads_spilled), bytes_text(data.record.bytes_spilled)));
  fact("seed", std::to_string(data.facts.seed));
  for (const auto& [name, value] : data.plan.vars)
    html += fmt::format("<dt><code>{}</code></dt><dd><code>{}</code></dd>\n", escaped(name),
                        escaped(value));
  return html + "</dl>\n";
}

std::string files_html(const ReportData& data) {
  if (data.files_read.empty()) return {};
  std::string html =
      "<table><thead><tr><th>pipeline file</th><th>SHA-256</th></tr></thead><tbody>\n";
  for (const FileRead& file : data.files_read)
    html += fmt::format("<tr><td>{}</td><td><code class=\"sum\">{}</code></td></tr>\n",
                        escaped(file.path),
                        file.sha256.empty() ? "cannot be read any more" : file.sha256);
  return html + "</tbody></table>\n";
}

std::string parameters_html(const PlannedStage& stage) {
  std::string html;
  for (std::size_t i = 0; i < stage.info.parameters.size() && i < stage.parameters.size(); ++i) {
    const ParameterInfo& info = stage.info.parameters[i];
    const bool chosen = stage.parameters[i] != info.default_value;
    html += fmt::format("<span class=\"{}\" title=\"{}\">{}&#160;=&#160;{}</span> ",
                        chosen ? "chosen" : "default", escaped(info.doc), escaped(info.name),
                        escaped(parameter_text(stage.parameters[i], info.unit)));
  }
  return html;
}

std::string stages_html(const ReportData& data) {
  std::string html =
      "<table class=\"stages\"><thead><tr><th>stage</th><th>use</th><th>plugin</th><th>parameters "
      "<span class=\"soft\">(those given in bold)</span></th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < data.plan.stages.size(); ++i) {
    const PlannedStage& stage = data.plan.stages[i];
    const StageReuse* reuse = data.reuse_of(i);
    const StageRecord* record = data.catalogue.find(stage.info.id);
    html += fmt::format(
        "<tr><td{}>{}</td><td><code>{}</code>{}</td><td title=\"{}\">{}</td><td>{}</td></tr>\n",
        reuse ? fmt::format(" title=\"key {}\"", reuse->key) : "", escaped(stage.name),
        escaped(stage.info.id),
        stage.info.deterministic ? "" : " <span class=\"soft\">not deterministic</span>",
        record ? escaped(record->file.string() + ", build " + record->build_id) : "",
        record ? escaped(record->plugin_id + " " + record->plugin_version) : "",
        parameters_html(stage));
  }
  return html + "</tbody></table>\n";
}

std::string line_html(const LogLine& line) {
  return fmt::format("<li{}><span class=\"n soft\">{:.3f} s</span> {}{}</li>\n",
                     line.level == LogLevel::kWarning ? " class=\"warning\"" : "", line.seconds,
                     line.stage.empty() ? "" : fmt::format("<b>{}</b> ", escaped(line.stage)),
                     escaped(line.sentence));
}

}  // namespace

std::string provenance_html(const ReportData& data) {
  return "<section id=\"provenance\"><h2>Provenance</h2>\n" + facts_html(data) + files_html(data) +
         stages_html(data) + "</section>\n";
}

std::string log_html(const ReportData& data) {
  std::string html = "<section id=\"log\"><h2>Log</h2>\n";
  const std::size_t warnings = data.facts.warnings.size() + data.log.warning_count();
  if (warnings > 0) {
    html +=
        fmt::format("<p>{}</p>\n<ul class=\"log\">\n", count_text(warnings, "warning", "warnings"));
    for (const Diagnostic& diagnostic : data.facts.warnings)
      html += fmt::format("<li class=\"warning\">{}</li>\n", escaped(diagnostic_text(diagnostic)));
    for (const LogLine& line : data.log.warnings()) html += line_html(line);
    html += "</ul>\n";
  }
  const auto lines = data.log.last_lines();
  if (!lines.empty()) {
    html += "<details><summary>The last lines</summary>\n<ul class=\"log\">\n";
    for (const LogLine& line : lines) html += line_html(line);
    html += "</ul></details>\n";
  }
  return html +
         "<p class=\"soft\">All of it: <a href=\"log.txt\">log.txt</a>. For programs: "
         "<a href=\"run.json\">run.json</a>.</p></section>\n";
}

}  // namespace stope::report
