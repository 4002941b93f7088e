#pragma once

#include <memory>
#include <vector>

#include "framework/cache/input_check.hpp"
#include "framework/cache/item_journal.hpp"
#include "framework/cache/kept_stage.hpp"
#include "framework/cache/object_store.hpp"
#include "framework/cache/reuse.hpp"
#include "framework/cache/warning_memory.hpp"
#include "framework/executor/run.hpp"

namespace stope {

/// Which outputs a run keeps.
enum class Keep : int {
  kNothing,
  kValues,  ///< maps, graphs, and all measures and artefacts. Other streams are made again.
  kAll      ///< all but what a source loads from its own files as it is touched
};

/// Writes outputs of a run into a store while it goes on. A stage whose outputs have all ended is
/// known to the store at once, so that a run which is killed later need not begin anew; of a map
/// whose stream is kept, each item is. Nothing becomes known of a stage after a file that it may
/// have read has changed.
class Keeper {
 public:
  /// Keeps outputs of stages that run and are read, by another stage or `wanted` by the run;
  /// others are never made. What stages have warned of by then is kept with them. All must live as
  /// long as the run.
  Keeper(const Plan& plan, const std::vector<StageKey>& keys, const Reuse& reuse,
         const std::vector<PlannedSource>& wanted, Keep keep, const InputCheck& inputs,
         KeptStages& kept, ObjectStore& store, ItemJournal* journal = nullptr,
         WarningMemory* warnings = nullptr);
  ~Keeper();
  /// Processes for run_plan(). They refer to this object. A store that cannot be written to fails
  /// no run: `complaint()` tells.
  std::vector<Sink> sinks();
  /// To be called after the run, however it ended: makes known what is left.
  void end();
  /// Why something was not kept; empty if all was.
  std::string complaint() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stope
