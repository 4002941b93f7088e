#pragma once

#include <memory>
#include <optional>

#include "framework/cli/arguments.hpp"
#include "framework/compare/experiment/experiment_plan.hpp"
#include "framework/plugins/plugin_catalogue.hpp"

namespace stope {

/// An experiment, checked against the plugins there are.
struct LoadedExperiment {
  std::unique_ptr<PluginCatalogue> catalogue;
  std::optional<Experiment> experiment;
  std::optional<ExperimentPlan> plan;  ///< none: what is wrong has been printed
  int exit_code = 0;                   ///< where there is no plan
};

/// Finds the plugins and checks the experiment the arguments name; prints what is wrong, as text on
/// the error stream or, with --json, as JSON on the output stream.
LoadedExperiment load_experiment(const Arguments& arguments);

/// Whether a file says of itself that it is an experiment.
bool is_experiment(const std::filesystem::path& file);

}  // namespace stope
