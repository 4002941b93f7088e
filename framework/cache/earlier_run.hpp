#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/cache/stage_keys.hpp"

namespace stope {

/// A stage as run.json has it.
struct EarlierStage {
  std::string use;  ///< `family/name`
  StageKey key;
};

/// A file under outputs/ as run.json has it.
struct EarlierOutput {
  std::string name;  ///< the entry under `outputs:`
  std::string path;  ///< relative to the run directory
  std::uint64_t bytes = 0;
  std::string sha256;
};

/// A file that the pipeline was read from.
struct EarlierFile {
  std::filesystem::path path;
  std::string sha256;
};

/// What run.json tells of a run, as far as it is needed to compare another run with it.
struct EarlierRun {
  std::string version;  ///< of Stope
  std::string end;      ///< `done`, `failed` or `cancelled`
  std::uint64_t seed = 0;
  std::filesystem::path pipeline, working_folder;
  std::vector<std::string> overrides;
  std::vector<EarlierFile> files;
  std::map<std::string, EarlierStage> stages;  ///< by name
  std::vector<EarlierOutput> outputs;
  std::vector<std::string> features;  ///< of the processor
  std::string libraries;
};

/// Reads a run.json. Throws Error with a sentence if there is none, or none that this Stope
/// understands.
EarlierRun read_earlier_run(const std::filesystem::path& file);

/// Why the stage of this name and key runs, against an earlier run of it: what has changed since,
/// as one sentence. `take`: whether the store was asked.
std::string why_it_runs(const std::string& name, const StageKey& key, const EarlierRun* earlier,
                        bool take);

}  // namespace stope
