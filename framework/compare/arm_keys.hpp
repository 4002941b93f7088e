#pragma once

#include <string>
#include <vector>

#include "framework/compare/compare_job.hpp"

namespace stope {

/// The keys of an arm's stages on a recording, for a seed. `run` is the name of the comparison, by
/// which stages are keyed that may give other bytes each time. Throws Error if a file that the arm
/// reads cannot be read, Cancelled if the job is stopped.
std::vector<StageKey> arm_keys(const CompareJob& job, const Plan& plan, std::uint64_t seed,
                               const std::string& run);

/// The key of all that a cell leaves: of its outputs by their names, and of its metrics.
std::string cell_key(const Experiment& experiment, const PlannedArm& arm,
                     const std::vector<StageKey>& keys);

}  // namespace stope
