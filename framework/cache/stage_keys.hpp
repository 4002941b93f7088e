#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"
#include "stope/digest.hpp"

namespace stope {

/// One of the things a stage's outputs depend on.
struct KeyPart {
  std::string name;   ///< `parameter min_clearance`, `input grid`, `plugin build`, …
  std::string value;  ///< as text; of files their digest, of an input the key of what feeds it
  bool operator==(const KeyPart&) const = default;
};

/// What a stage's outputs will be, known before it runs: equal keys, equal bytes.
struct StageKey {
  Digest digest;
  std::vector<KeyPart> parts;  ///< in a fixed order
  /// Files and folders whose content the parts tell, as the stage names them.
  std::vector<std::filesystem::path> files;
  /// Whether the key holds for this run only: the stage, or one above it, may give other bytes
  /// each time.
  bool only_this_run = false;
};

/// What keys are made with besides the plan.
struct KeyFacts {
  std::uint64_t seed = 0;  ///< of the run
  std::string run;         ///< a name no other run has
  std::string sdk;         ///< build of the SDK's library, whose code all stages call
  std::function<Digest(const std::filesystem::path&)> digest_of_path;  ///< of files and folders
};

/// The key of each stage of a plan: from its id, the builds of its
/// plugin and of what that is linked with, its parameters in SI units,
/// the content of the files that they name or that it also reads, the keys of its inputs, its
/// payloads' layouts and its seed. Stages that are live, not deterministic, or read what cannot be
/// read are keyed by the run. Throws Error if a stage cannot be made.
std::vector<StageKey> stage_keys(const Plan& plan, const Catalogue& catalogue,
                                 const KeyFacts& facts);

/// What differs between two keys of one stage, as sentences; empty if nothing does.
std::vector<std::string> differences(const StageKey& before, const StageKey& now);

}  // namespace stope
