#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "framework/cache/earlier_run.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"

namespace stope {

/// What a second run of a recorded run shows.
struct ReplayVerdict {
  std::vector<std::string> differences;  ///< sentences, the first cause first
  std::vector<std::string> remarks;      ///< what might have made a difference, or explains one
  std::size_t compared = 0;              ///< files
  bool same() const { return differences.empty(); }
};

/// The keys of a plan without a store. Throws as stage_keys() does, Cancelled if `stop` is set.
std::vector<StageKey> keys_of(const Plan& plan, const Catalogue& catalogue, std::uint64_t seed,
                              const std::atomic<bool>* stop);

/// What can be told before anything runs: stages, plugin builds, parameters and contents of input
/// files that differ from those recorded, in the order of the plan. Of a stage that differs only
/// because its inputs do, nothing is said.
ReplayVerdict compare_before(const EarlierRun& earlier, const Plan& plan,
                             const std::vector<StageKey>& keys, const std::string& version);

/// Compares what the second run left with what the first recorded and with what lies in the first
/// one's `folder` now, file by file, and if something differs says what may be behind it: another
/// processor, a stage that may give other bytes, somebody who edited the file.
void compare_after(const EarlierRun& earlier, const std::filesystem::path& folder,
                   const EarlierRun& now, const std::vector<StageKey>& keys, const Plan& plan,
                   ReplayVerdict& verdict);

/// The first of the files that the pipeline was read from that has changed since, as a sentence;
/// empty if none has.
std::string first_changed_file(const EarlierRun& earlier);

}  // namespace stope
