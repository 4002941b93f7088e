#pragma once

#include <string>
#include <vector>

#include "framework/cache/item_journal.hpp"
#include "framework/cache/kept_stage.hpp"
#include "framework/cache/object_store.hpp"
#include "framework/cache/resumed_map.hpp"

namespace stope {

/// What becomes of a stage in a run that may take results from a store.
enum class Fate : int {
  kRuns,
  kReopened,  ///< a source that gave all this before, from files that it loads as they are touched
  kStored,    ///< its outputs come from the store
  kNotNeeded  ///< nobody asks for what it would give
};
/// Whether the stage itself is made and run.
inline bool is_made(Fate fate) { return fate == Fate::kRuns || fate == Fate::kReopened; }

/// Who does what in a run.
struct Reuse {
  std::vector<Fate> fates;        ///< by stage
  std::vector<KeptStage> stored;  ///< by stage; of those that are stored
  /// By stage; of maps that run, but did a part of it before they were stopped. Empty if none is
  /// known.
  std::vector<MadeItems> made;
  std::size_t count(Fate fate) const;
};

/// What becomes of the stages in a sentence: `2 stages run, 1 comes from the store, 3 are not
/// needed`.
std::string fates_text(const Reuse& reuse);

/// Adds to a decision what maps that run had made before they were stopped.
void find_made_items(const Plan& plan, const std::vector<StageKey>& keys,
                     const ItemJournal& journal, const ObjectStore& store, Reuse& reuse);

/// Decides which stages of a plan must run. `wanted`: what the run is to leave behind. A stage is
/// taken from the store if every output that is asked for is there whole. A stage without outputs
/// always runs: it is there for what it does.
Reuse decide(const Plan& plan, const std::vector<StageKey>& keys,
             const std::vector<PlannedSource>& wanted, const KeptStages& kept,
             const ObjectStore& store);

}  // namespace stope
