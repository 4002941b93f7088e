#include <fmt/format.h>

#include "framework/report/graph/graph.hpp"
#include "framework/report/graph/pipeline_graph.hpp"

namespace stope {
namespace {

using namespace report;

// Text inside double quotes of a Graphviz file.
std::string dot_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

// Text inside double quotes of a Mermaid file, which knows HTML's entities.
std::string mermaid_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"') {
      result += "#quot;";
    } else if (c == '#') {
      result += "#35;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c == '\n' ? ' ' : c;
    }
  }
  return result;
}

std::string wire_label(const PipelineGraph& graph, const GraphEdge& edge) {
  const std::string& from = graph.nodes[edge.from].outputs[edge.from_port];
  const GraphNode& to = graph.nodes[edge.to];
  if (to.is_output || to.inputs[edge.to_port] == from) return from;
  return fmt::format("{} → {}", from, to.inputs[edge.to_port]);
}

}  // namespace

std::string graph_dot(const Plan& plan) {
  const PipelineGraph graph = pipeline_graph(plan);
  std::string text = fmt::format("digraph \"{}\" {{\n", dot_text(plan.name));
  text +=
      "  rankdir=LR;\n"
      "  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=11];\n"
      "  edge [fontname=\"Helvetica\", fontsize=9, arrowsize=0.6];\n";
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    text += fmt::format("  n{} [label=\"{}\\n{}\"{}];\n", i, dot_text(node.name),
                        dot_text(node.use), node.is_output ? ", shape=note, style=\"\"" : "");
  }
  for (const GraphEdge& edge : graph.edges)
    text += fmt::format("  n{} -> n{} [label=\"{}\", tooltip=\"{}\"{}];\n", edge.from, edge.to,
                        dot_text(wire_label(graph, edge)), dot_text(edge.type),
                        edge.stream ? ", penwidth=2" : "");
  return text + "}\n";
}

std::string graph_mermaid(const Plan& plan) {
  const PipelineGraph graph = pipeline_graph(plan);
  std::string text = "flowchart LR\n";
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    const std::string label =
        fmt::format("{}<br/><small>{}</small>", mermaid_text(node.name), mermaid_text(node.use));
    text += node.is_output ? fmt::format("  n{}>\"{}\"]\n", i, label)
                           : fmt::format("  n{}[\"{}\"]\n", i, label);
  }
  for (const GraphEdge& edge : graph.edges)
    text += fmt::format("  n{} {}|\"{}\"| n{}\n", edge.from, edge.stream ? "==>" : "-->",
                        mermaid_text(wire_label(graph, edge)), edge.to);
  return text;
}

}  // namespace stope
