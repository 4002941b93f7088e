#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/cache/reported_run.hpp"
#include "framework/compare/comparison.hpp"
#include "framework/compare/merge_plans.hpp"
#include "framework/executor/run_record.hpp"
#include "framework/report/run_facts.hpp"

/// What the run of a merged graph was for one arm, in the names of the arm's own plan.
namespace stope {

/// What a process computed, read and wrote itself, in seconds by the clock: of a map summed over
/// its items, without what its thread waits for workers. Where a stage computes in parallel this is
/// how long that took, not a sum over threads.
double busy_seconds(const ProcessRecord& process);

/// The record, with the processes of the arm's stages and of the sinks named `arm: …` alone.
RunRecord record_of_arm(const MergedPlan& merged, std::size_t arm, const std::string& name,
                        const Plan& plan, const RunRecord& record);

/// What became of the arm's stages, as run.json tells it.
std::vector<StageReuse> reuse_of_arm(const MergedPlan& merged, std::size_t arm,
                                     const CachedRun& cached);

/// The same, as the comparison tells it. `seconds`: of what was computed in earlier attempts, by
/// key.
std::vector<CellStage> cell_stages(const MergedPlan& merged, std::size_t arm, const Plan& plan,
                                   const CachedRun& cached, const RunRecord& record,
                                   const std::map<Digest, double>& seconds);

}  // namespace stope
