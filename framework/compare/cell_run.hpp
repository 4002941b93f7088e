#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "framework/compare/comparison.hpp"
#include "framework/compare/experiment/experiment_plan.hpp"
#include "framework/compare/metric_check.hpp"
#include "framework/executor/run.hpp"
#include "framework/report/run_facts.hpp"

namespace stope {

/// Writes one cell's run directory and reads its measures while it runs, alone or among others. Its
/// sources and records are those of the arm's own plan.
class CellRun {
 public:
  /// All but `facts` must live as long as this. Throws Error if the folder cannot be written.
  CellRun(const Experiment& experiment, const PlannedArm& arm, const Catalogue& catalogue,
          RunFacts facts, MetricCheck& metrics, Comparison& comparison, ComparedCell& cell);
  ~CellRun();

  ComparedCell& cell() const;
  const Plan& plan() const;
  /// What it must have of the plan.
  std::vector<PlannedSource> wanted() const;
  /// Readers of what is wanted. Called again, it begins anew.
  std::vector<Sink> sinks();
  void log(LogLevel level, std::string_view stage, std::string_view sentence);
  /// Puts everything in place and fills the cell: done. `record` and `reuse` are of the arm's plan.
  /// Throws Error if it cannot be written.
  void finish(const RunRecord& record, std::vector<StageReuse> reuse);
  /// Writes down that and why it failed, and fills the cell. Throws Error likewise.
  void fail(const RunRecord& record);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stope
