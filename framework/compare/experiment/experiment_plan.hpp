#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/compare/experiment/experiment.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"

namespace stope {

/// One arm on one recording.
struct PlannedArm {
  std::optional<Plan> plan;            ///< none: the arm lacks this recording
  std::string why_not;                 ///< a sentence, if there is no plan
  std::vector<PlannedSource> metrics;  ///< by metric: the output whose Measures it is read from
};

/// An experiment with nothing left to look up.
struct ExperimentPlan {
  std::size_t arms = 0;
  std::vector<PlannedArm> all;  ///< for each recording, each arm
  std::vector<std::string> warnings;
  const PlannedArm& of(std::size_t arm, std::size_t recording) const {
    return all[recording * arms + arm];
  }
};

/// On how many recordings the best-off arm can be compared with the baseline.
std::size_t comparable_recordings(const Experiment& experiment, const ExperimentPlan& plan);

/// Checks the pipeline that each arm is on each recording, before any data is read. Reports all
/// that is wrong, each with the arm it is wrong in; nothing is given then. A recording whose files
/// are not there for an arm is no error but left out of it, unless nothing is left.
std::optional<ExperimentPlan> plan_experiment(const Experiment& experiment,
                                              const Catalogue& catalogue, Diagnostics& diagnostics);

}  // namespace stope
