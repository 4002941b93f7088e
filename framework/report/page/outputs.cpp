#include "framework/report/page/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "framework/report/page/html.hpp"
#include "framework/report/port_name.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

constexpr std::size_t kFilesShown = 6;
constexpr std::size_t kOthersNamed = 10;

std::string row(const WrittenFile& file, const std::string& from) {
  return fmt::format(
      "<tr><td><a href=\"{}\">{}</a></td><td>{}</td><td class=\"n\">{}</td>"
      "<td><code class=\"sum\">{}</code></td></tr>\n",
      link_text(file.path), escaped(file.path.substr(file.path.find('/') + 1)),
      file.companion ? "<span class=\"soft\">companion</span>" : escaped(from),
      bytes_text(file.bytes), file.sha256);
}

std::string rows_of(const ReportData& data, const PlannedOutput& output) {
  std::string from;
  for (const PlannedSource& source : data.sources_of(output)) {
    if (!from.empty()) from += ", ";
    from += port_name(data.plan, source);
  }
  std::string rows;
  std::size_t count = 0;
  std::uint64_t bytes = 0;
  for (const WrittenFile& file : data.outputs) {
    if (file.output != output.name) continue;
    bytes += file.bytes;
    if (++count <= kFilesShown) rows += row(file, from);
  }
  if (count > kFilesShown)
    rows += fmt::format(
        "<tr><td class=\"soft\">… {} in all</td><td></td><td class=\"n soft\">{}"
        "</td><td class=\"soft\">run.json lists each</td></tr>\n",
        count_text(count, "file", "files"), bytes_text(bytes));
  return rows;
}

std::string others_line(const std::vector<std::string>& others) {
  if (others.empty()) return {};
  const std::size_t named = std::min(kOthersNamed, others.size());
  std::string names;
  for (std::size_t i = 0; i < named; ++i)
    names += fmt::format("{}<code>{}</code>", i > 0 ? ", " : "", escaped(others[i]));
  if (others.size() > named) names += fmt::format(" and {} more", others.size() - named);
  return fmt::format("<p class=\"soft\">Also in outputs/, but not written by this run: {}.</p>\n",
                     names);
}

}  // namespace

std::string link_text(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '/' || c == '.' || c == '-' || c == '_') {
      text += c;
    } else {
      text += fmt::format("%{:02X}", byte);
    }
  }
  return text;
}

std::string outputs_html(const ReportData& data) {
  if (data.plan.outputs.empty()) return {};
  std::string html = "<section id=\"outputs\"><h2>Outputs</h2>\n";
  if (data.record.end != RunRecord::End::kDone) {
    html += "<p>The run did not end well, so it left no outputs.";
    if (!data.outputs_kept.empty()) {
      html += " Still there from an earlier run:";
      for (const std::string& name : data.outputs_kept)
        html += fmt::format(" <a href=\"{}\">{}</a>", link_text(name), escaped(name));
    }
    return html + "</p></section>\n";
  }
  html +=
      "<table><thead><tr><th>file</th><th>made of</th><th class=\"n\">size</th><th>SHA-256</th>"
      "</tr></thead><tbody>\n";
  for (const PlannedOutput& output : data.plan.outputs) html += rows_of(data, output);
  return html + "</tbody></table>\n" + others_line(data.outputs_beside) + "</section>\n";
}

}  // namespace stope::report
