#pragma once

#include <string>

#include "framework/executor/run_record.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope {

/// The pipeline as a Graphviz file.
std::string graph_dot(const Plan& plan);

/// The pipeline as a Mermaid flowchart.
std::string graph_mermaid(const Plan& plan);

/// The pipeline as an SVG file of its own, laid out without Graphviz. With a record, each box shows
/// how its process spent its time.
std::string graph_svg(const Plan& plan, const RunRecord* record = nullptr);

}  // namespace stope
