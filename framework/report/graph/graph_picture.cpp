#include "framework/report/graph/graph_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

#include "framework/report/activity_times.hpp"
#include "framework/report/graph/graph.hpp"
#include "framework/report/graph/layered_layout.hpp"
#include "framework/report/graph/pipeline_graph.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope {
namespace report {
namespace {

// Pixels.
constexpr double kMargin = 4, kPadding = 10, kHead = 42, kPortRow = 15, kFoot = 24;
constexpr double kColumnGap = 54, kNarrowest = 112, kWidest = 236;
constexpr std::size_t kLongestText = 34;

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string shortened(const std::string& text) {
  if (letters(text) <= kLongestText) return text;
  std::size_t bytes = 0;
  for (std::size_t count = 0; bytes < text.size(); ++bytes) {
    if ((text[bytes] & 0xc0) != 0x80 && ++count == kLongestText) break;
  }
  return text.substr(0, bytes) + "…";
}

class GraphDrawing {
 public:
  GraphDrawing(const Plan& plan, const RunRecord* record)
      : plan_(plan), record_(record), graph_(pipeline_graph(plan)) {
    LayoutProblem problem;
    for (const GraphNode& node : graph_.nodes) problem.boxes.push_back({height_of(node), 0});
    for (const GraphEdge& edge : graph_.edges)
      problem.wires.push_back(
          {edge.from, edge.to, port_height(edge.from_port),
           graph_.nodes[edge.to].is_output ? kHead / 2 : port_height(edge.to_port)});
    layout_ = lay_out(problem);
    place_columns();
  }

  std::string svg(const std::string& style) const {
    const double width = right_ + kMargin, height = layout_.height + 2 * kMargin;
    std::string text = fmt::format(
        "<svg class=\"pipeline\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
        "aria-label=\"Graph of the pipeline {2}\">\n{3}",
        width, height, escaped(plan_.name), style);
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) text += wire(e);
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) text += box(n);
    return text + "</svg>\n";
  }

 private:
  bool has_foot(const GraphNode& node) const { return record_ && process_of(node); }
  const ProcessRecord* process_of(const GraphNode& node) const {
    return process_named(*record_, plan_.stages[node.stage].name);
  }
  static double port_height(std::size_t port) {
    return kHead + kPortRow * (static_cast<double>(port) + 0.5);
  }
  double height_of(const GraphNode& node) const {
    const std::size_t rows = node.is_output ? 0 : std::max(node.inputs.size(), node.outputs.size());
    return kHead + kPortRow * static_cast<double>(rows) + (has_foot(node) ? kFoot : 6);
  }
  static double width_of(const GraphNode& node) {
    double ports = 0;
    for (std::size_t i = 0; i < std::max(node.inputs.size(), node.outputs.size()); ++i) {
      const std::size_t left = i < node.inputs.size() ? letters(node.inputs[i]) : 0;
      const std::size_t right = i < node.outputs.size() ? letters(node.outputs[i]) : 0;
      ports = std::max(ports, 6.0 * static_cast<double>(left + right) + 14);
    }
    const double name = 7.6 * static_cast<double>(letters(shortened(node.name)));
    const double use = 6.1 * static_cast<double>(letters(shortened(node.use)));
    return std::clamp(std::max({name, use, ports}) + 2 * kPadding, kNarrowest, kWidest);
  }

  void place_columns() {
    widths_.assign(static_cast<std::size_t>(layout_.columns), 0.0);
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      double& width = widths_[column_of(n)];
      width = std::max(width, width_of(graph_.nodes[n]));
    }
    double left = kMargin;
    for (const double width : widths_) {
      lefts_.push_back(left);
      right_ = left + width;
      left = right_ + kColumnGap;
    }
  }
  std::size_t column_of(std::size_t node) const {
    return static_cast<std::size_t>(layout_.column[node]);
  }
  double top_of(std::size_t node) const { return layout_.top[node] + kMargin; }

  std::string wire(std::size_t e) const {
    const GraphEdge& edge = graph_.edges[e];
    double x = lefts_[column_of(edge.from)] + widths_[column_of(edge.from)];
    double y = top_of(edge.from) + port_height(edge.from_port);
    std::string path = fmt::format("M{:.1f} {:.1f}", x, y);
    const auto curve_to = [&](double to_x, double to_y) {
      const double middle = (x + to_x) / 2;
      fmt::format_to(std::back_inserter(path), "C{0:.1f} {1:.1f} {0:.1f} {2:.1f} {3:.1f} {2:.1f}",
                     middle, y, to_y, to_x);
      x = to_x;
      y = to_y;
    };
    for (const Layout::Bend& bend : layout_.bends[e]) {
      const auto column = static_cast<std::size_t>(bend.column);
      curve_to(lefts_[column], bend.height + kMargin);
      x = lefts_[column] + widths_[column];
      fmt::format_to(std::back_inserter(path), "H{:.1f}", x);
    }
    const GraphNode& to = graph_.nodes[edge.to];
    curve_to(lefts_[column_of(edge.to)],
             top_of(edge.to) + (to.is_output ? kHead / 2 : port_height(edge.to_port)));
    return fmt::format("<path class=\"wire{}\" d=\"{}\"><title>{}{}</title></path>\n",
                       edge.stream ? " stream" : "", path, edge.stream ? "stream of " : "",
                       escaped(edge.type));
  }

  std::string box(std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    const double left = lefts_[column_of(n)], width = widths_[column_of(n)];
    const double top = top_of(n), height = height_of(node);
    const bool failed = record_ && record_->failed_stage == plan_.stages[node.stage].name &&
                        !record_->failed_stage.empty();
    std::string text = fmt::format(
        "<g class=\"stage{}{}\" transform=\"translate({:.1f} {:.1f})\"><title>{}</title>"
        "<rect class=\"box\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"{}\"/>",
        node.is_output ? " output" : "", failed ? " failed" : "", left, top, tooltip(node), width,
        height, node.is_output ? 2 : 7);
    text += fmt::format(
        "<text class=\"name\" x=\"{0}\" y=\"18\">{1}</text>"
        "<text class=\"use\" x=\"{0}\" y=\"33\">{2}</text>",
        kPadding, escaped(shortened(node.name)), escaped(shortened(node.use)));
    for (std::size_t i = 0; i < node.inputs.size(); ++i) text += port(node.inputs[i], i, 0, "");
    for (std::size_t i = 0; i < node.outputs.size(); ++i)
      text += port(node.outputs[i], i, width, " text-anchor=\"end\"");
    if (has_foot(node)) text += foot(*process_of(node), is_streaming(n), width, height);
    return text + "</g>\n";
  }

  static std::string port(const std::string& name, std::size_t row, double x, const char* anchor) {
    const double y = port_height(row);
    return fmt::format(
        "<circle class=\"pin\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>"
        "<text class=\"port\" x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>",
        x, y, x + (*anchor != '\0' ? -8 : 8), y + 3.5, anchor, escaped(name));
  }

  // Whether a box reads or writes a stream: then the number of its items tells something.
  bool is_streaming(std::size_t node) const {
    return std::any_of(graph_.edges.begin(), graph_.edges.end(), [node](const GraphEdge& edge) {
      return edge.stream && (edge.from == node || edge.to == node);
    });
  }

  static std::string foot(const ProcessRecord& process, bool streaming, double width,
                          double height) {
    const auto times = activity_times(process);
    const double life = static_cast<double>(
        std::max<std::int64_t>({process.end - process.begin,
                                std::accumulate(times.begin(), times.end(), std::int64_t{0}), 1}));
    // A map computes on workers; its own thread waits for them, and that is in `run`.
    const std::int64_t busy = (process.work > 0 ? process.work : process.run) + process.io;
    const std::uint64_t items = std::max(process.items_read, process.items_written);
    std::string text = fmt::format(
        "<text class=\"time\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>"
        "<text class=\"time\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
        kPadding, height - 11, duration_text(busy), width - kPadding, height - 11,
        streaming ? count_text(items, "item", "items") : "");
    double x = kPadding;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double part = (width - 2 * kPadding) * static_cast<double>(times[i]) / life;
      if (part < 0.05) continue;
      text += fmt::format(
          "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
          "height=\"3.5\"/>",
          kActivityStyles[i], x, height - 7.5, part);
      x += part;
    }
    return text;
  }

  static std::string tooltip(const GraphNode& node) {
    std::string text = fmt::format("{}: {}", node.name, node.use);
    for (const std::string& parameter : node.parameters) text += "\n" + parameter;
    return escaped(text);
  }

  const Plan& plan_;
  const RunRecord* record_;
  PipelineGraph graph_;
  Layout layout_;
  std::vector<double> lefts_, widths_;  ///< by column
  double right_ = 0;
};

}  // namespace

std::string graph_picture(const Plan& plan, const RunRecord* record) {
  return GraphDrawing(plan, record).svg("");
}

}  // namespace report

std::string graph_svg(const Plan& plan, const RunRecord* record) {
  return report::GraphDrawing(plan, record)
      .svg(fmt::format("<style>{}</style>\n", report::graph_style()));
}

}  // namespace stope
