#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "framework/pipeline/plan.hpp"

namespace stope::report {

/// A box of the drawn pipeline: a stage, or an entry under `outputs:` together with its export.
struct GraphNode {
  std::string name;  ///< of the stage, or of the file
  std::string use;   ///< the stage's or export's id
  bool is_output = false;
  std::size_t stage = 0;                     ///< place in Plan::stages
  std::vector<std::string> inputs, outputs;  ///< names of the wired ports; none of an output
  std::vector<std::string> parameters;  ///< those that differ from their default: `width = 8 m`
};

/// A wire between two boxes.
struct GraphEdge {
  std::size_t from = 0, from_port = 0;  ///< places in nodes and in its outputs
  std::size_t to = 0, to_port = 0;      ///< places in nodes and in its inputs
  bool stream = false;
  std::string type;  ///< of the payload, without vendor and version: `RoadGraph`
};

/// A plan as it is drawn. Nodes stand in topological order.
struct PipelineGraph {
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
};

PipelineGraph pipeline_graph(const Plan& plan);

/// `RoadGraph` of `stope/RoadGraph@2`.
std::string short_type(const std::string& type);

/// A parameter's value as a person writes it: `3.5 m`, `[0, 0]`, `nearest`.
std::string parameter_text(const ParameterValue& value, const std::string& unit);

}  // namespace stope::report
