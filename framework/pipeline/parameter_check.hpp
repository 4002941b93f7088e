#pragma once

#include <optional>
#include <string>

#include "framework/pipeline/located_node.hpp"
#include "stope/parameter.hpp"

namespace stope {

/// Reads what is written for a parameter: converts units, makes paths absolute, and holds the value
/// against the parameter's type and limits. `owner` is the stage's id, for sentences. Reports
/// everything that is wrong and gives nothing then.
std::optional<ParameterValue> check_parameter(const ParameterInfo& parameter,
                                              const LocatedNode& node, const std::string& owner,
                                              Diagnostics& diagnostics);

}  // namespace stope
