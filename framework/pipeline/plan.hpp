#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/diagnostics/diagnostic.hpp"
#include "stope/stage_info.hpp"

namespace stope {

/// An output of a planned stage.
struct PlannedSource {
  std::size_t stage = 0;  ///< place in Plan::stages
  std::size_t port = 0;   ///< place in that stage's info.outputs
  bool operator==(const PlannedSource&) const = default;
};

/// A stage of a checked pipeline: everything resolved, nothing left to look up.
struct PlannedStage {
  std::string name;  ///< unique in the plan
  /// The name that its randomness comes from; empty: its own. A plan made of several gives one stage
  /// of each a name of its own and leaves what it computes as it was.
  std::string seeded_as;
  StageInfo info;
  Place place;                             ///< where the pipeline declares it
  std::vector<ParameterValue> parameters;  ///< as info.parameters; defaults filled in
  std::vector<std::optional<PlannedSource>>
      inputs;                 ///< as info.inputs; none where nothing is wired
  std::vector<bool> streams;  ///< as info.outputs: whether it carries a stream in this plan
  bool is_export = false;     ///< made by an entry under `outputs:`

  const std::string& seed_name() const { return seeded_as.empty() ? name : seeded_as; }
};

/// An entry under `outputs:`.
struct PlannedOutput {
  std::string name;       ///< as written, `roads.geojson`: what lands in DIR/outputs/
  std::size_t stage = 0;  ///< the export, whose only output is the Artefact
  bool stream = false;    ///< lands in a folder, one numbered file an item
  Place place;
};

/// A pipeline that has been checked. Stages stand in topological order: inputs come from earlier
/// stages.
struct Plan {
  std::string name;
  std::filesystem::path file;
  std::vector<PlannedStage> stages;
  std::vector<PlannedOutput> outputs;
  std::map<std::string, std::string> vars;        ///< as resolved, for the record
  std::vector<std::filesystem::path> files_read;  ///< the pipeline and what it includes
};

}  // namespace stope
