#pragma once

#include <atomic>
#include <mutex>
#include <vector>

#include "framework/compare/experiment/experiment_plan.hpp"
#include "stope/error.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {

/// An experiment that turned out to be wrong in something that only its first results could tell.
class WrongExperiment final : public Error {
 public:
  explicit WrongExperiment(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// Finds metrics that no run of a comparison can give, as soon as that is sure. Which figures a
/// stage gives is known when it has given some: a stage declares its outputs, not what they hold.
/// Stages that are alike, of one member with the same wires and parameters, give the same figures,
/// so that usually the first run to measure tells for all, and a misspelt figure costs minutes
/// instead of a night.
///
/// A metric is hopeless if every kind of stage it is read from anywhere in the experiment has
/// measured, and none gave its figure in a unit that fits. That does not depend on who was first.
class MetricCheck {
 public:
  /// Both must live as long as this.
  MetricCheck(const Experiment& experiment, const ExperimentPlan& plan);

  /// Looks at what a metric's stage has measured. Any thread may call it.
  void look(std::size_t arm, std::size_t recording, std::size_t metric, const Measures& measures);
  /// Tells that a metric's figure has been read, in this or an earlier run of the comparison.
  void was_read(std::size_t metric);
  /// Whether a metric is hopeless; what runs may as well stop.
  bool hopeless() const { return hopeless_; }
  /// Throws WrongExperiment, with a diagnostic for each hopeless metric, if there is one.
  void require_hope() const;

 private:
  /// Stages that are alike as far as the figures they give go.
  struct Kind {
    const PlannedStage* stage = nullptr;
    std::size_t port = 0;
    bool told = false;  ///< it has measured, without the figure
  };
  struct Hope {
    std::vector<Kind> kinds;
    std::vector<std::size_t> kind_of;  ///< by recording and arm
    bool fulfilled = false;
    Diagnostic complaint;  ///< of the kind that told last
  };
  static bool alike(const Kind& kind, const Kind& other);
  bool hopeless(const Hope& hope) const;

  const Experiment& experiment_;
  const ExperimentPlan& plan_;
  mutable std::mutex mutex_;
  std::vector<Hope> hopes_;  ///< by metric
  std::atomic<bool> hopeless_{false};
};

}  // namespace stope
