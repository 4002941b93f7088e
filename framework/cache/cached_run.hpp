#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "framework/cache/keeper.hpp"
#include "framework/cache/reuse.hpp"
#include "framework/cache/stage_keys.hpp"
#include "framework/executor/run.hpp"

namespace stope {

/// What runs keep at most on the disk if nobody says otherwise.
inline constexpr std::uint64_t kDefaultStoreLimit = std::uint64_t{20} << 30;  // bytes

/// How a run uses a store.
struct CacheUse {
  std::filesystem::path store;  ///< its folder; empty: nothing is taken and nothing kept
  bool take = true;             ///< what is there already
  Keep keep = Keep::kValues;
  std::uint64_t limit = kDefaultStoreLimit;  ///< bytes, kept to after each run
};

/// A plan that runs with a store: what was computed before is taken from it, what is computed now
/// goes into it.
///
///     CachedRun run(plan, catalogue, seed, use, observer);
///     RunRecord record = run.run(wanted, [&](const Reuse&) { return sinks; }, options);
///     run.keys(), run.reuse(), run.complaint()                // what was what
///
/// A store that cannot be used fails no run: the run does without, and complaint() says why.
class CachedRun {
 public:
  /// Makes the keys, for which input files are read unless they are known from before. `plan`,
  /// `catalogue` and `observer` must live as long as this. Throws Error if a stage cannot be made,
  /// Cancelled if `stop` is set while files are read.
  CachedRun(const Plan& plan, const Catalogue& catalogue, std::uint64_t seed, CacheUse use,
            RunObserver& observer, const std::atomic<bool>* stop = nullptr);
  ~CachedRun();
  CachedRun(const CachedRun&) = delete;
  CachedRun& operator=(const CachedRun&) = delete;

  /// By stage of the plan.
  const std::vector<StageKey>& keys() const;
  /// Runs the plan as far as `wanted` and stages that nobody reads ask for it. `sinks_of` is told
  /// what becomes of each stage and gives the readers, which may be more than `wanted` where stages
  /// run or come from the store. If an object turns out to be damaged when it is touched, the run
  /// begins anew without it, and `sinks_of` is called once more: what came before is void.
  /// `options.seed` is that of the keys. Throws only what `sinks_of` throws.
  RunRecord run(const std::vector<PlannedSource>& wanted,
                const std::function<std::vector<Sink>(const Reuse&)>& sinks_of, RunOptions options,
                const std::function<void(const RunProgress&)>& progress = {});
  /// What became of each stage; after run().
  const Reuse& reuse() const;
  /// Whether the files that the stage and those above it may have read in this run still are what
  /// their keys were made of; after run(). If not, nothing that depends on them was kept, and the
  /// observer was warned.
  bool inputs_hold(std::size_t stage) const;
  /// Why something was not taken or kept; empty if nothing went wrong.
  std::string complaint() const;

  /// Keeps something small that was found out about a stage's output, such as a picture, under the
  /// stage's key and a name that no port has. Nothing is kept if outputs are not.
  void note(std::size_t stage, const std::string& name,
            const std::function<void(ByteSink&)>& write);
  /// Lets `read` read what was noted, in this run or an earlier one. False if there is nothing.
  bool noted(std::size_t stage, const std::string& name,
             const std::function<void(ByteSource&)>& read);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The store's folder if nobody says otherwise: STOPE_CACHE, or XDG_CACHE_HOME/stope/store; empty
/// if the environment names no home.
std::filesystem::path default_store();

}  // namespace stope
