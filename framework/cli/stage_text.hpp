#pragma once

#include <string>
#include <vector>

#include "framework/plugins/catalogue.hpp"

namespace stope {

/// A stage's declaration for a person at a terminal: what it does, ports, parameters with units,
/// limits and defaults, where the method comes from, and the members it can be swapped with.
std::string stage_text(const StageRecord& record, const std::vector<std::string>& interchangeable);

/// The same as a section of a Markdown page.
std::string stage_markdown(const StageRecord& record,
                           const std::vector<std::string>& interchangeable);

/// A parameter's value as a pipeline would write it; `none` if it is not given.
std::string value_text(const ParameterValue& value);

/// What values a parameter accepts, in words: `>= 0 m`, `one of a, b`; empty if anything goes.
std::string limits_text(const ParameterInfo& parameter);

}  // namespace stope
