#include "framework/compare/report/difference_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/compare/report/finding.hpp"
#include "framework/compare/report/marks.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

/// Places along the plot as a share of its width, so that it fits any screen and text does not
/// shrink with it.
struct Axis {
  double low = 0, high = 0;
  std::string at(double value) const {
    return fmt::format("{:.2f}%", 100 * (value - low) / (high - low));
  }
  std::string across(double from, double to) const {
    return fmt::format("{:.2f}%", 100 * (to - from) / (high - low));
  }
};

Axis axis_of(const std::vector<ArmVerdicts>& verdicts, std::size_t metric, double delta) {
  Axis axis{-delta, delta};
  for (const ArmVerdicts& arm : verdicts) {
    const ComparedMeasure& measure = arm.measures[metric];
    for (const double difference : measure.differences) {
      axis.low = std::min(axis.low, difference);
      axis.high = std::max(axis.high, difference);
    }
    if (!measure.has_interval()) continue;
    axis.low = std::min(axis.low, measure.interval.low);
    axis.high = std::max(axis.high, measure.interval.high);
  }
  if (!(axis.high > axis.low)) axis = {axis.low - 1, axis.high + 1};
  const double margin = 0.06 * (axis.high - axis.low);
  return {axis.low - margin, axis.high + margin};
}

std::string strip(const ComparedMeasure& measure, const Axis& axis) {
  std::string svg = "<svg class=\"strip\" width=\"100%\" height=\"44\">";
  const double delta = measure.smallest_that_matters;
  if (delta > 0)
    svg += fmt::format("<rect class=\"band\" x=\"{}\" width=\"{}\" y=\"0\" height=\"44\"/>",
                       axis.at(-delta), axis.across(-delta, delta));
  svg += fmt::format("<line class=\"zero\" x1=\"{0}\" x2=\"{0}\" y1=\"0\" y2=\"44\"/>", axis.at(0));
  for (std::size_t i = 0; i < measure.differences.size(); ++i)
    svg += fmt::format(
        "<circle class=\"pair\" cx=\"{}\" cy=\"{}\" r=\"4\"><title>{}: {}</title></circle>",
        axis.at(measure.differences[i]),
        11 + 5 * static_cast<int>(i % 3 == 0   ? 0
                                  : i % 3 == 1 ? 1
                                               : -1),
        escaped(measure.recordings[i]), number_text(measure.differences[i]));
  if (measure.has_interval()) {
    svg += fmt::format(
        "<g class=\"{}\"><line class=\"interval\" x1=\"{}\" x2=\"{}\" y1=\"32\" y2=\"32\"/>"
        "<line class=\"interval\" x1=\"{}\" x2=\"{}\" y1=\"27\" y2=\"37\"/><line "
        "class=\"interval\" "
        "x1=\"{}\" x2=\"{}\" y1=\"27\" y2=\"37\"/><circle class=\"mean\" cx=\"{}\" cy=\"32\" "
        "r=\"5\"><title>mean {}</title></circle></g>",
        mark_of(measure).style, axis.at(measure.interval.low), axis.at(measure.interval.high),
        axis.at(measure.interval.low), axis.at(measure.interval.low),
        axis.at(measure.interval.high), axis.at(measure.interval.high),
        axis.at(measure.mean_difference), difference_text(measure));
  }
  return svg + "</svg>";
}

std::string scale(const Axis& axis) {
  std::string svg = "<svg class=\"strip axis\" width=\"100%\" height=\"22\">";
  for (const double tick : ticks(axis.low, axis.high))
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{0}\" y1=\"0\" y2=\"5\"/><text x=\"{0}\" y=\"18\" "
        "text-anchor=\"middle\">{1}</text>",
        axis.at(tick), number_text(tick));
  return svg + "</svg>";
}

}  // namespace

std::vector<double> ticks(double low, double high) {
  const double wanted = (high - low) / 6;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10 * power;
  for (const double round : {5.0, 2.0, 1.0})
    if (round * power >= wanted) step = round * power;
  std::vector<double> places;
  for (double k = std::ceil(low / step); k * step <= high; ++k)
    places.push_back(k == 0 ? 0.0 : k * step);
  return places;
}

std::string difference_plots_html(const Comparison& comparison,
                                  const std::vector<ArmVerdicts>& verdicts) {
  if (comparison.metrics.empty() || verdicts.empty()) return {};
  std::string html = fmt::format(
      "<section id=\"differences\"><h2>Paired differences</h2>\n<p class=\"legend keys\">"
      "<span><svg class=\"key dot\" viewBox=\"0 0 10 10\"><circle class=\"pair\" cx=\"5\" cy=\"5\" "
      "r=\"4\"/></svg>one recording, arm against {}</span><span><svg class=\"key\" viewBox=\"0 0 "
      "22 "
      "10\"><path class=\"interval\" d=\"M1 5H21M1 1V9M21 1V9\"/><circle class=\"mean\" cx=\"11\" "
      "cy=\"5\" r=\"3.5\"/></svg>mean and its 95 % interval</span><span><i "
      "class=\"band\"></i>too little to matter, ±δ</span></p>\n<div class=\"plots\">\n",
      escaped(comparison.arms[comparison.baseline].name));
  for (std::size_t i = 0; i < comparison.metrics.size(); ++i) {
    const ComparedMetric& metric = comparison.metrics[i];
    const Axis axis = axis_of(verdicts, i, metric.smallest_that_matters);
    html += fmt::format(
        "<figure class=\"plot\"><figcaption><b>{}</b>{} <span class=\"ways\"><span>← worse</span> "
        "<span>better →</span></span></figcaption>\n",
        escaped(metric.name), metric.unit.empty() ? "" : fmt::format(", {}", escaped(metric.unit)));
    for (const ArmVerdicts& arm : verdicts) {
      const ComparedMeasure& measure = arm.measures[i];
      const VerdictMark mark = mark_of(measure);
      html += fmt::format(
          "<div class=\"row\"><span class=\"name\">{} <b class=\"{}\" title=\"{}\">{}</b></span>{}"
          "</div>\n",
          escaped(comparison.arms[arm.arm].name), mark.style, escaped(text_of(measure)), mark.sign,
          strip(measure, axis));
    }
    html += fmt::format("<div class=\"row\"><span class=\"name\"></span>{}</div></figure>\n",
                        scale(axis));
  }
  return html + "</div></section>\n";
}

}  // namespace stope::report
