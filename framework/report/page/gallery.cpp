#include "framework/report/page/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "framework/report/page/figure.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/port_name.hpp"
#include "framework/report/quantity_text.hpp"
#include "stope/payloads.hpp"

namespace stope::report {
namespace {

const std::string& type_at(const Plan& plan, const PlannedSource& source) {
  return plan.stages[source.stage].info.outputs[source.port].type;
}

// The sketch of the nearest output of this type upstream of a stage, breadth first; among equally
// near ones the first in the order of the inputs. Null if there is none.
const Sketch* upstream(const ReportData& data, std::size_t stage, std::string_view type) {
  std::set<std::size_t> seen{stage};
  for (std::vector<std::size_t> front{stage}; !front.empty();) {
    std::vector<std::size_t> next;
    for (const std::size_t place : front) {
      for (const auto& input : data.plan.stages[place].inputs) {
        if (!input) continue;
        const TapResult* tap = data.tap_at(*input);
        if (type_at(data.plan, *input) == type && tap && !tap->sketches.empty())
          return &tap->sketches.back();
        if (seen.insert(input->stage).second) next.push_back(input->stage);
      }
    }
    front = std::move(next);
  }
  return nullptr;
}

std::vector<std::string> figures_of(const ReportData& data, const TapResult& tap, bool wide) {
  std::vector<std::string> figures;
  for (std::size_t i = 0; i < tap.sketches.size(); ++i) {
    const Sketch& sketch = tap.sketches[i];
    FigureParts parts;
    parts.sketch = &sketch;
    parts.name = port_name(data.plan, tap.source);
    parts.wide = wide;
    if (!sketch.raster && !sketch.strokes.empty())
      parts.ground = upstream(data, tap.source.stage, OccupancyGrid::kType);
    if (sketch.kind == "Path") parts.roads = upstream(data, tap.source.stage, RoadGraph::kType);
    if (tap.items > 1)
      parts.remark =
          fmt::format("{} of {} items", i == 0 ? "first" : "last", count_text(tap.items));
    figures.push_back(figure_html(parts));
  }
  return figures;
}

}  // namespace

std::string gallery_html(const ReportData& data) {
  std::string wide, small;
  for (const TapResult& tap : data.taps) {
    const std::string& type = type_at(data.plan, tap.source);
    // A road graph that a source gives, as truth, lies on no map and is no result.
    const bool result = (type == RoadGraph::kType || type == Path::kType) &&
                        upstream(data, tap.source.stage, OccupancyGrid::kType) != nullptr;
    std::string html;
    for (const std::string& figure : figures_of(data, tap, result)) html += figure;
    if (result) {
      wide.insert(0, html);
    } else {
      small += html;
    }
  }
  if (wide.empty() && small.empty()) return {};
  std::string html = "<section id=\"pictures\"><h2>Pictures</h2>\n";
  if (!wide.empty()) html += fmt::format("<div class=\"results\">\n{}</div>\n", wide);
  if (!small.empty()) html += "<div class=\"gallery\">\n" + small + "</div>\n";
  return html + "</section>\n";
}

std::string measures_html(const ReportData& data) {
  std::string rows;
  for (const TapResult& tap : data.taps) {
    for (std::size_t s = 0; s < tap.sketches.size(); ++s) {
      if (!tap.sketches[s].measures) continue;
      const Measures& measures = *tap.sketches[s].measures;
      const std::size_t count = std::min(measures.names.size(), measures.values.size());
      for (std::size_t i = 0; i < count; ++i)
        rows += fmt::format(
            "<tr><td>{}</td><td>{}</td><td class=\"n\">{:.5g}</td><td>{}</td><td class=\"soft\">{}"
            "</td></tr>\n",
            i > 0 ? "" : escaped(port_name(data.plan, tap.source)), escaped(measures.names[i]),
            measures.values[i], i < measures.units.size() ? escaped(measures.units[i]) : "",
            i < measures.notes.size() ? escaped(measures.notes[i]) : "");
    }
  }
  if (rows.empty()) return {};
  return "<section id=\"measures\"><h2>Measures</h2>\n<table><thead><tr><th>from</th><th>measure"
         "</th><th class=\"n\">value</th><th>unit</th><th>computed "
         "with</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></section>\n";
}

}  // namespace stope::report
