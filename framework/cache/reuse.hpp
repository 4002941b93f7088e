#pragma once

#include <vector>

#include "framework/cache/kept_stage.hpp"
#include "framework/cache/object_store.hpp"

namespace stope {

/// What becomes of a stage in a run that may take results from a store.
enum class Fate : int {
  kRuns,
  kStored,    ///< its outputs come from the store
  kNotNeeded  ///< nobody asks for what it would give
};

/// Who does what in a run.
struct Reuse {
  std::vector<Fate> fates;        ///< by stage
  std::vector<KeptStage> stored;  ///< by stage; of those that are stored
};

/// Decides which stages of a plan must run. `wanted`: what the run is to leave behind. A stage is
/// taken from the store if every output that is asked for is there whole.
Reuse decide(const Plan& plan, const std::vector<StageKey>& keys,
             const std::vector<PlannedSource>& wanted, const KeptStages& kept,
             const ObjectStore& store);

}  // namespace stope
