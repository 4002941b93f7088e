#include "framework/compare/report/stage_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

std::string seconds_text(double seconds) {
  return duration_text(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
}

std::string range_text(const Spread& spread) {
  return fmt::format("{} – {}", seconds_text(spread.least), seconds_text(spread.greatest));
}

StageRow& row_of(std::vector<StageRow>& rows, const Comparison& comparison, const std::string& name,
                 std::size_t& after) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const StageRow& row) { return row.name == name; });
  if (found != rows.end()) {
    after = static_cast<std::size_t>(found - rows.begin()) + 1;
    return *found;
  }
  const auto place = rows.begin() + static_cast<std::ptrdiff_t>(after);
  ++after;
  return *rows.insert(
      place, StageRow{name, std::vector<std::optional<StageTime>>(comparison.arms.size())});
}

std::string fate_html(const StageTime& time) {
  if (time.shared > 0 && time.ran == 0 && time.stored == 0)
    return " <span class=\"tag\" title=\"run once for this arm and others\">shared</span>";
  if (time.stored > 0 && time.ran == 0 && time.shared == 0)
    return " <span class=\"tag\" title=\"not run: its outputs were kept from "
           "before\">stored</span>";
  if (time.shared > 0 || time.stored > 0)
    return fmt::format(
        " <span class=\"tag\" title=\"cells in which it was run for this arm alone, shared with "
        "others, kept from before\">{} own, {} shared, {} stored</span>",
        time.ran, time.shared, time.stored);
  return {};
}

std::string cell_html(const std::optional<StageTime>& time, double most) {
  if (!time) return "<td class=\"soft\">–</td>";
  const bool own = time->ran > 0;
  std::string html = fmt::format("<td class=\"time{}\">", own ? "" : " lent");
  if (time->seconds.count == 0) return html + "–" + fate_html(*time) + "</td>";
  html += fmt::format("<i class=\"bar\" style=\"width:{:.1f}%\"></i><b title=\"{}\">{}</b>",
                      most > 0 ? 100 * time->seconds.median / most : 0, escaped(time->use),
                      seconds_text(time->seconds.median));
  if (time->seconds.count > 1) html += fmt::format(" <small>{}</small>", range_text(time->seconds));
  return html + fate_html(*time) + "</td>";
}

std::string pairs_html(const Comparison& comparison) {
  std::string rows;
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
    std::vector<double> baseline, own, ratios;
    for (const TimedPair& timed : comparison.timings) {
      if (timed.arm != arm) continue;
      const std::size_t pairs = std::min(timed.baseline_seconds.size(), timed.arm_seconds.size());
      for (std::size_t i = 0; i < pairs; ++i) {
        baseline.push_back(timed.baseline_seconds[i]);
        own.push_back(timed.arm_seconds[i]);
        if (timed.baseline_seconds[i] > 0)
          ratios.push_back(timed.arm_seconds[i] / timed.baseline_seconds[i]);
      }
    }
    if (own.empty()) continue;
    const Spread a = spread_of(baseline), b = spread_of(own), ratio = spread_of(ratios);
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"n\">{}</td>",
                        escaped(comparison.arms[arm].name), own.size());
    for (const Spread& spread : {a, b})
      rows += fmt::format(
          "<td class=\"n\">{}</td><td class=\"n\"><b>{}</b></td><td class=\"n\">{}</td>",
          seconds_text(spread.least), seconds_text(spread.median), seconds_text(spread.greatest));
    rows += ratio.count == 0
                ? std::string("<td class=\"n\">–</td></tr>\n")
                : fmt::format("<td class=\"n\">{:.2f} <small>{:.2f} – {:.2f}</small></td></tr>\n",
                              ratio.median, ratio.least, ratio.greatest);
  }
  if (rows.empty()) return {};
  return fmt::format(
             "<h3>Taken in turns</h3>\n<div class=\"scroll\"><table class=\"turns\"><thead><tr><th>"
             "arm</th><th class=\"n\">pairs</th><th class=\"n\">{0}: least</th><th "
             "class=\"n\">median</th><th class=\"n\">most</th><th class=\"n\">arm: least</th><th "
             "class=\"n\">median</th><th class=\"n\">most</th><th class=\"n\">arm : {0}</th></tr>"
             "</thead><tbody>\n",
             escaped(comparison.arms[comparison.baseline].name)) +
         rows +
         "</tbody></table></div>\n<p class=\"soft\">The stages that differ, without the store, arm "
         "and baseline by turns, so that a machine that slows down slows both. The ratio is that "
         "of "
         "each pair.</p>\n";
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return {values.front(), median, values.back(), values.size()};
}

std::vector<StageRow> stage_times(const Comparison& comparison) {
  std::vector<StageRow> rows;
  for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
    std::vector<std::pair<std::string, std::vector<double>>> seconds;
    for (const ComparedCell& cell : comparison.cells) {
      if (cell.arm != arm) continue;
      std::size_t after = 0;
      for (const CellStage& stage : cell.stages) {
        StageRow& row = row_of(rows, comparison, stage.name, after);
        if (!row.arms[arm]) row.arms[arm] = StageTime{stage.use, {}, 0, 0, 0};
        StageTime& time = *row.arms[arm];
        time.ran += stage.fate == StageFate::kRan ? 1 : 0;
        time.shared += stage.fate == StageFate::kShared ? 1 : 0;
        time.stored += stage.fate == StageFate::kStored ? 1 : 0;
        if (stage.seconds < 0) continue;
        auto held = std::find_if(seconds.begin(), seconds.end(),
                                 [&](const auto& one) { return one.first == stage.name; });
        if (held == seconds.end()) held = seconds.insert(seconds.end(), {stage.name, {}});
        held->second.push_back(stage.seconds);
      }
    }
    for (StageRow& row : rows)
      for (const auto& [name, values] : seconds)
        if (name == row.name && row.arms[arm]) row.arms[arm]->seconds = spread_of(values);
  }
  return rows;
}

std::string stage_times_html(const Comparison& comparison) {
  const std::vector<StageRow> rows = stage_times(comparison);
  if (rows.empty()) return {};
  double most = 0;
  for (const StageRow& row : rows)
    for (const auto& time : row.arms)
      if (time) most = std::max(most, time->seconds.median);
  std::string html =
      "<section id=\"times\"><h2>Time a stage</h2>\n<div class=\"scroll\"><table "
      "class=\"stage-times\"><thead><tr><th>stage</th>";
  for (const ComparedArm& arm : comparison.arms)
    html += fmt::format("<th>{}</th>", escaped(arm.name));
  html += "</tr></thead><tbody>\n";
  std::vector<double> own(comparison.arms.size(), 0.0);
  for (const StageRow& row : rows) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escaped(row.name));
    for (std::size_t arm = 0; arm < row.arms.size(); ++arm) {
      html += cell_html(row.arms[arm], most);
      if (row.arms[arm] && row.arms[arm]->ran > 0) own[arm] += row.arms[arm]->seconds.median;
    }
    html += "</tr>\n";
  }
  html += "</tbody><tfoot><tr><th scope=\"row\">its own stages</th>";
  for (const double sum : own)
    html += fmt::format("<td class=\"time\"><b>{}</b></td>", seconds_text(sum));
  return html +
         "</tr></tfoot></table></div>\n<p class=\"soft\">Medians over recordings and seeds, with "
         "least and most: what a stage computed, read and wrote, of a map summed over its items, "
         "without what it waited for others or for a free worker. Stages run side by side on one "
         "machine and slow each other: these figures say where time goes, not which arm is "
         "faster.</p>\n" +
         pairs_html(comparison) + "</section>\n";
}

}  // namespace stope::report
