#include "framework/compare/report/comparison_page.hpp"

#include <fmt/format.h>

#include <span>

#include "framework/compare/report/difference_plot.hpp"
#include "framework/compare/report/downloads.hpp"
#include "framework/compare/report/page_facts.hpp"
#include "framework/compare/report/script.hpp"
#include "framework/compare/report/stage_times.hpp"
#include "framework/compare/report/style.hpp"
#include "framework/compare/report/verdict_table.hpp"
#include "framework/compare/report/viewer.hpp"
#include "framework/report/draw/base64.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/page/style.hpp"
#include "framework/report/pending_file.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

std::string downloads_html(const std::vector<Download>& downloads) {
  std::string html = "<section id=\"downloads\"><h2>For programs</h2>\n<ul class=\"downloads\">\n";
  for (const Download& download : downloads) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(download.text.data());
    html += fmt::format(
        "<li><a class=\"download\" download=\"{0}\" href=\"data:{1};base64,{2}\">{0} "
        "<small>{3}, {4}</small></a></li>\n",
        download.name, download.media, base64({bytes, download.text.size()}), download.what,
        bytes_text(download.text.size()));
  }
  return html + "</ul>\n<p class=\"soft\">The same files stand beside this page.</p></section>\n";
}

std::string page_of(const Comparison& comparison, const std::vector<ArmVerdicts>& verdicts,
                    const std::vector<Download>& downloads) {
  // A page opened from disk may have no icon of its own: without the link it would ask for one.
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>"
      "<link rel=\"icon\" href=\"data:,\"/><title>{} – Stope</title>\n<style>{}{}</style></head>\n"
      "<body><main>\n",
      escaped(comparison.name), page_style(), comparison_style());
  page += comparison_header_html(comparison, verdicts);
  page += verdict_table_html(comparison, verdicts);
  page += difference_plots_html(comparison, verdicts);
  page += viewer_html(comparison);
  page += stage_times_html(comparison);
  page += exclusions_html(comparison);
  page += downloads_html(downloads);
  page += comparison_provenance_html(comparison);
  return page + fmt::format("</main>\n<script>{}</script>\n</body></html>\n", comparison_script());
}

}  // namespace

std::string comparison_page(const Comparison& comparison) {
  const std::vector<ArmVerdicts> verdicts = verdicts_of(comparison);
  return page_of(comparison, verdicts, downloads_of(comparison, verdicts));
}

void write_comparison_report(const Comparison& comparison) {
  const std::vector<ArmVerdicts> verdicts = verdicts_of(comparison);
  const std::vector<Download> downloads = downloads_of(comparison, verdicts);
  for (const Download& download : downloads)
    write_file(comparison.folder / download.name, download.text);
  write_file(comparison.folder / "report.html", page_of(comparison, verdicts, downloads));
}

}  // namespace stope::report
