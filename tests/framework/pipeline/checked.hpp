#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/pipeline/check.hpp"

namespace stope {

/// What came of checking a text against the fake catalogue.
struct Checked {
  std::optional<Plan> plan;
  std::vector<Diagnostic> diagnostics;
  std::string text;  ///< all diagnostics, one a line

  /// The stage of this name. Throws std::out_of_range if the plan has none.
  const PlannedStage& stage(const std::string& name) const;
  /// A parameter of a stage, by name.
  const ParameterValue& parameter(const std::string& stage, const std::string& name) const;
  /// The source of a stage's input, as `stage.port`; empty if it is not wired.
  std::string source(const std::string& stage, const std::string& input) const;
};

Checked check_text(const std::string& text, const std::vector<std::string>& overrides = {});
Checked check_file(const std::string& file, const std::vector<std::string>& overrides = {});

}  // namespace stope
