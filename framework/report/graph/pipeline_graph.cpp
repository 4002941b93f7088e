#include "framework/report/graph/pipeline_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace stope::report {
namespace {

// The place of a name in a list, where it is put if it is not there.
std::size_t place_of(std::vector<std::string>& list, const std::string& name) {
  const auto found = std::find(list.begin(), list.end(), name);
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  list.push_back(name);
  return list.size() - 1;
}

struct ValueText {
  std::string operator()(std::monostate) const { return "not given"; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return value; }
  template <class T>
  std::string operator()(const std::vector<T>& values) const {
    return fmt::format("[{}]", fmt::join(values, ", "));
  }
};

GraphNode node_of(const Plan& plan, std::size_t place) {
  const PlannedStage& stage = plan.stages[place];
  GraphNode node{stage.name, stage.info.id, stage.is_export, place, {}, {}, {}};
  if (stage.is_export) {
    for (const PlannedOutput& output : plan.outputs) {
      if (output.stage == place) node.name = output.name;
    }
  }
  for (std::size_t i = 0; i < stage.parameters.size() && i < stage.info.parameters.size(); ++i) {
    const ParameterInfo& info = stage.info.parameters[i];
    if (stage.parameters[i] != info.default_value)
      node.parameters.push_back(
          fmt::format("{} = {}", info.name, parameter_text(stage.parameters[i], info.unit)));
  }
  return node;
}

}  // namespace

std::string short_type(const std::string& type) {
  const std::size_t slash = type.find('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  return type.substr(begin, type.find('@', begin) - begin);
}

std::string parameter_text(const ParameterValue& value, const std::string& unit) {
  const std::string text = std::visit(ValueText{}, value);
  if (unit.empty() || std::holds_alternative<std::monostate>(value)) return text;
  std::string symbol = unit;
  if (const std::size_t power = symbol.find("^2"); power != std::string::npos)
    symbol.replace(power, 2, "²");
  return fmt::format("{} {}", text, symbol);
}

PipelineGraph pipeline_graph(const Plan& plan) {
  PipelineGraph graph;
  for (std::size_t s = 0; s < plan.stages.size(); ++s) {
    const PlannedStage& stage = plan.stages[s];
    GraphNode node = node_of(plan, s);
    for (std::size_t i = 0; i < stage.inputs.size(); ++i) {
      if (!stage.inputs[i]) continue;
      const PlannedSource& source = *stage.inputs[i];
      const PlannedStage& from = plan.stages[source.stage];
      const PortInfo& port = from.info.outputs[source.port];
      GraphEdge edge;
      edge.from = source.stage;
      edge.from_port = place_of(graph.nodes[source.stage].outputs, port.name);
      edge.to = s;
      edge.to_port = node.is_output ? 0 : place_of(node.inputs, stage.info.inputs[i].name);
      edge.stream = source.port < from.streams.size() && from.streams[source.port];
      edge.type = short_type(port.type);
      graph.edges.push_back(std::move(edge));
    }
    graph.nodes.push_back(std::move(node));
  }
  return graph;
}

}  // namespace stope::report
