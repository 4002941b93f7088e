#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "framework/cli/arguments.hpp"
#include "framework/diagnostics/diagnostic.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/plugin_catalogue.hpp"

namespace stope {

/// A pipeline, checked against the plugins there are.
struct LoadedPipeline {
  std::unique_ptr<PluginCatalogue> catalogue;
  std::optional<Plan> plan;  ///< none: what is wrong has been printed
  std::vector<Diagnostic> warnings;
  int exit_code = 0;  ///< where there is no plan
};

/// Finds the plugins and checks the pipeline the arguments name; prints what the check has to say,
/// as text on the error stream or, with --json, as JSON on the output stream when there are errors.
LoadedPipeline load_pipeline(const Arguments& arguments);

/// Prints what a check has to say, as text on the error stream or as JSON on the output stream.
void print_diagnostics(const std::vector<Diagnostic>& list, bool json);

/// The exit code for these errors. A stage that is missing because a plugin could not be used is
/// that plugin's fault, not the pipeline's.
int why_no_plan(const std::vector<Diagnostic>& list, const PluginCatalogue& catalogue);

/// Where plugins are looked for: --plugin-path, STOPE_PLUGIN_PATH, the user's folder, the folder
/// beside the command.
std::unique_ptr<PluginCatalogue> load_catalogue(const Arguments& arguments);

}  // namespace stope
