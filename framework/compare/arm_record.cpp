#include "framework/compare/arm_record.hpp"

#include <utility>

namespace stope {

double busy_seconds(const ProcessRecord& process) {
  // A map computes on workers; its own thread waits for them, and that is in `run`.
  const std::int64_t computed = process.work > 0 ? process.work : process.run;
  return static_cast<double>(computed + process.io) * 1e-9;
}

RunRecord record_of_arm(const MergedPlan& merged, std::size_t arm, const std::string& name,
                        const Plan& plan, const RunRecord& record) {
  RunRecord of_arm = record;
  of_arm.processes.clear();
  of_arm.channels.clear();
  // Processes stand in the order of the stages, sinks behind them.
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const std::size_t place = merged.places[arm][i];
    if (place >= record.processes.size()) continue;
    of_arm.processes.push_back(record.processes[place]);
    of_arm.processes.back().name = plan.stages[i].name;
  }
  const std::string mark = name + ": ";
  for (std::size_t i = merged.plan.stages.size(); i < record.processes.size(); ++i) {
    if (!record.processes[i].name.starts_with(mark)) continue;
    of_arm.processes.push_back(record.processes[i]);
    of_arm.processes.back().name.erase(0, mark.size());
  }
  return of_arm;
}

std::vector<StageReuse> reuse_of_arm(const MergedPlan& merged, std::size_t arm,
                                     const CachedRun& cached) {
  std::vector<StageReuse> all;
  for (const std::size_t place : merged.places[arm])
    all.push_back(stage_reuse(cached.keys()[place], cached.reuse().fates[place]));
  return all;
}

std::vector<CellStage> cell_stages(const MergedPlan& merged, std::size_t arm, const Plan& plan,
                                   const CachedRun& cached, const RunRecord& record,
                                   const std::map<Digest, double>& seconds) {
  std::vector<CellStage> stages;
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const std::size_t place = merged.places[arm][i];
    const ProcessRecord& process = record.processes[place];
    CellStage stage{plan.stages[i].name, plan.stages[i].info.id, StageFate::kRan, -1,
                    process.items_written};
    switch (cached.reuse().fates[place]) {
      case Fate::kRuns:
      case Fate::kReopened:
        if (merged.owners[place].size() > 1) stage.fate = StageFate::kShared;
        break;
      case Fate::kStored:
        stage.fate = StageFate::kStored;
        break;
      case Fate::kNotNeeded:
        stage.fate = StageFate::kNotNeeded;
        break;
    }
    if (is_made(cached.reuse().fates[place])) stage.seconds = busy_seconds(process);
    if (const auto known = seconds.find(cached.keys()[place].digest); known != seconds.end())
      stage.seconds = known->second;
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace stope
