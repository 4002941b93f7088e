#include "framework/report/page/times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "framework/report/activity_times.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"
#include "framework/report/run_report.hpp"

namespace stope::report {
namespace {

constexpr int kBins = 240;
constexpr double kStripHeight = 14;

using Shares = std::array<double, 4>;  ///< of a bin's time, by activity

// What a process did in each of the bins the run is divided into. A span that stands for many is
// spread evenly over the stretch it covers.
std::vector<Shares> shares_over_time(const ProcessRecord& process, std::int64_t wall) {
  std::vector<Shares> bins(kBins, Shares{});
  const double bin = static_cast<double>(std::max<std::int64_t>(wall, 1)) / kBins;
  for (const Span& span : process.spans) {
    const double begin = static_cast<double>(span.begin), end = static_cast<double>(span.end);
    if (end <= begin) continue;
    const double density = span.count > 1 ? static_cast<double>(span.busy) / (end - begin) : 1.0;
    const int first = std::clamp(static_cast<int>(begin / bin), 0, kBins - 1);
    const int last = std::clamp(static_cast<int>(end / bin), 0, kBins - 1);
    for (int i = first; i <= last; ++i) {
      const double overlap = std::min(end, (i + 1) * bin) - std::max(begin, i * bin);
      if (overlap > 0)
        bins[static_cast<std::size_t>(i)][activity_place(span.activity)] += density * overlap / bin;
    }
  }
  return bins;
}

// Activities stacked from the ground up, neighbouring bins of equal height joined.
std::string strip(const ProcessRecord& process, std::int64_t wall) {
  const std::vector<Shares> bins = shares_over_time(process, wall);
  std::array<std::string, 4> paths;
  std::vector<double> ground(bins.size(), 0.0);
  for (std::size_t activity = 0; activity < paths.size(); ++activity) {
    const auto edges = [&](std::size_t i) {
      const double top = std::min(1.0, ground[i] + bins[i][activity]);
      return std::pair(std::lround(ground[i] * kStripHeight * 10),
                       std::lround(top * kStripHeight * 10));
    };
    for (std::size_t i = 0; i < bins.size();) {
      std::size_t end = i + 1;
      const auto [low, high] = edges(i);
      while (end < bins.size() && edges(end) == std::pair(low, high)) ++end;
      if (high > low)
        fmt::format_to(std::back_inserter(paths[activity]), "M{} {:.1f}h{}v{:.1f}h-{}z", i,
                       kStripHeight - static_cast<double>(high) / 10, end - i,
                       static_cast<double>(high - low) / 10, end - i);
      i = end;
    }
    for (std::size_t i = 0; i < bins.size(); ++i) ground[i] += bins[i][activity];
  }
  std::string svg =
      fmt::format("<svg class=\"strip\" viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\">", kBins,
                  kStripHeight);
  for (std::size_t activity = 0; activity < paths.size(); ++activity) {
    if (!paths[activity].empty())
      svg +=
          fmt::format("<path class=\"{}\" d=\"{}\"/>", kActivityStyles[activity], paths[activity]);
  }
  return svg + "</svg>";
}

std::string row(const ProcessRecord& process, std::int64_t wall, bool stored) {
  const auto time = [](std::int64_t ns) { return ns > 0 ? duration_text(ns) : std::string("–"); };
  std::string run = time(process.run);
  // A map's items run side by side: their sum tells more than the time the process watched them.
  std::string work = process.work > 0 ? duration_text(process.work) : "";
  const std::uint64_t items = std::max(process.items_read, process.items_written);
  return fmt::format(
      "<tr><th scope=\"row\">{}{}</th><td class=\"timeline\">{}</td><td class=\"n\">{}</td>"
      "<td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n soft\">{}</td>"
      "<td class=\"n soft\">{}</td><td class=\"n\">{}</td></tr>\n",
      escaped(process.name), stored ? " <span class=\"soft\">from the store</span>" : "",
      strip(process, wall), run, work, time(process.io),
      time(process.wait_in), time(process.wait_out), items > 0 ? count_text(items) : "–");
}

constexpr const char* kHead =
    "<table class=\"times\"><thead><tr><th>process</th><th class=\"timeline\">{}</th>"
    "<th class=\"n\">run</th><th class=\"n\" title=\"summed over the items of a map, which run "
    "side "
    "by side\">work</th><th class=\"n\">disk</th><th class=\"n\">waits for input</th>"
    "<th class=\"n\">waits for readers</th><th class=\"n\">items</th></tr></thead><tbody>\n";

}  // namespace

std::string times_html(const ReportData& data) {
  if (data.record.processes.empty()) return {};
  std::string rows, taps;
  for (std::size_t i = 0; i < data.record.processes.size(); ++i) {
    const ProcessRecord& process = data.record.processes[i];
    // Stages come first, in the order of the plan.
    const StageReuse* reuse = i < data.plan.stages.size() ? data.reuse_of(i) : nullptr;
    if (reuse && reuse->from == StageReuse::From::kNotNeeded) continue;
    (RunReport::is_tap(process.name) ? taps : rows) +=
        row(process, data.record.wall, reuse && reuse->from == StageReuse::From::kStore);
  }
  const std::string head =
      fmt::format(fmt::runtime(kHead),
                  fmt::format("<span>0</span><span>{}</span>", duration_text(data.record.wall)));
  std::string html =
      "<section id=\"times\"><h2>Time</h2>\n<p class=\"legend\"><span><i "
      "class=\"run\"></i>runs</span>"
      "<span><i class=\"io\"></i>reads or writes the disk</span><span><i "
      "class=\"wait-in\"></i>waits "
      "for input</span><span><i class=\"wait-out\"></i>waits for readers</span></p>\n" +
      head + rows + "</tbody></table>\n";
  if (!taps.empty())
    html += "<details><summary>What this report and the store cost</summary>\n" + head + taps +
            "</tbody></table></details>\n";
  return html +
         "<p class=\"soft\">In detail: <a href=\"trace.json\">trace.json</a>, which Perfetto "
         "opens.</p></section>\n";
}

std::string channels_html(const ReportData& data) {
  if (data.record.channels.empty()) return {};
  std::string rows;
  std::size_t grown = 0;
  for (const ChannelRecord& channel : data.record.channels) {
    grown += channel.growths > 0 ? 1 : 0;
    rows += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{}</td></tr>\n",
        escaped(channel.from), escaped(channel.to), count_text(channel.items),
        count_text(channel.capacity), channel.growths > 0 ? count_text(channel.growths) : "–");
  }
  return fmt::format(
      "<section id=\"channels\"><h2>Channels</h2>\n<details{}><summary>{}; {}"
      "</summary>\n<table><thead><tr><th>from</th><th>to</th><th class=\"n\">items"
      "</th><th class=\"n\">capacity</th><th class=\"n\">grown</th></tr></thead>"
      "<tbody>\n{}</tbody></table></details></section>\n",
      data.record.channels.size() <= 12 ? " open=\"open\"" : "",
      count_text(data.record.channels.size(), "channel", "channels"),
      grown == 0 ? "none had to grow" : fmt::format("{} had to grow", grown), rows);
}

}  // namespace stope::report
