#include "framework/report/page/page.hpp"

#include <fmt/format.h>

#include "framework/report/graph/graph_picture.hpp"
#include "framework/report/page/gallery.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/page/outputs.hpp"
#include "framework/report/page/provenance.hpp"
#include "framework/report/page/style.hpp"
#include "framework/report/page/times.hpp"
#include "framework/report/quantity_text.hpp"
#include "framework/report/run_json.hpp"

namespace stope::report {
namespace {

std::string verdict_html(const RunRecord& record) {
  const char* word = "Done";
  if (record.end == RunRecord::End::kFailed) word = "Failed";
  if (record.end == RunRecord::End::kCancelled) word = "Cancelled";
  std::string html =
      fmt::format("<p class=\"verdict {}\"><b>{}</b> {} {}", end_name(record.end), word,
                  record.end == RunRecord::End::kDone ? "in" : "after", duration_text(record.wall));
  if (!record.sentence.empty()) html += fmt::format(". {}", escaped(record.sentence));
  return html + "</p>\n";
}

// A word of the command line as a shell would need it.
std::string shell_word(const std::string& word) {
  const bool plain =
      !word.empty() && word.find_first_of(" \t\n\"'\\$`*?[]{}()<>|&;#~!") == std::string::npos;
  if (plain) return word;
  std::string inner;
  for (const char c : word)
    inner += c == '\'' ? std::string_view("'\\''") : std::string_view(&c, 1);
  return fmt::format("'{}'", inner);
}

std::string header_html(const ReportData& data) {
  const auto fact = [](const char* name, const std::string& value, const std::string& remark) {
    return fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>\n", name, escaped(value),
                       remark.empty() ? "" : fmt::format(" <small>{}</small>", escaped(remark)));
  };
  std::string command;
  for (const std::string& word : data.facts.command) {
    if (!command.empty()) command += ' ';
    command += shell_word(word);
  }
  std::size_t stages = 0;
  for (const PlannedStage& stage : data.plan.stages) stages += stage.is_export ? 0 : 1;
  const auto count = [&](StageReuse::From from) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < data.reuse.size(); ++i)
      number += !data.plan.stages[i].is_export && data.reuse[i].from == from ? 1 : 0;
    return number;
  };
  std::string remark;
  if (count(StageReuse::From::kStore) + count(StageReuse::From::kNotNeeded) > 0)
    remark = fmt::format("{} ran, {} from the store, {} not needed",
                         count(StageReuse::From::kRun) + count(StageReuse::From::kReopened),
                         count(StageReuse::From::kStore), count(StageReuse::From::kNotNeeded));
  const std::size_t warnings = data.facts.warnings.size() + data.log.warning_count();
  std::string html = fmt::format("<header><p class=\"over\">Stope {}</p>\n<h1>{}</h1>\n",
                                 escaped(data.facts.version), escaped(data.plan.name));
  html += verdict_html(data.record);
  html += "<dl class=\"facts\">\n";
  html += fact("stages", count_text(stages), remark);
  html += fact("outputs", count_text(data.plan.outputs.size()), "");
  html += fact("threads", count_text(static_cast<std::uint64_t>(data.facts.threads)), "");
  if (data.record.peak_resident > 0)
    html += fact("memory", bytes_text(data.record.peak_resident),
                 fmt::format("of {}", bytes_text(data.facts.memory)));
  html += fact("seed", std::to_string(data.facts.seed), "");
  html += fact("warnings", warnings == 0 ? "none" : count_text(warnings), "");
  const std::string start = utc_text(data.facts.start);
  html += fact("started", fmt::format("{} {}", start.substr(0, 10), start.substr(11, 5)), "UTC");
  html += "</dl>\n";
  if (!command.empty()) html += fmt::format("<p class=\"command\">{}</p>\n", escaped(command));
  return html + "</header>\n";
}

std::string pipeline_html(const ReportData& data) {
  return fmt::format(
      "<section id=\"pipeline\"><h2>Pipeline</h2>\n<div class=\"scroll\">{}</div></section>\n",
      graph_picture(data.plan, &data.record));
}

}  // namespace

std::string report_page(const ReportData& data) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>"
      "<title>{} – Stope</title>\n<style>{}{}</style></head>\n<body><main>\n",
      escaped(data.plan.name), page_style(), graph_style());
  page += header_html(data);
  page += pipeline_html(data);
  page += gallery_html(data);
  page += measures_html(data);
  page += times_html(data);
  page += channels_html(data);
  page += outputs_html(data);
  page += provenance_html(data);
  page += log_html(data);
  return page + "</main></body></html>\n";
}

}  // namespace stope::report
