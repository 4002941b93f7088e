#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/pipeline/located_node.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"

namespace stope {

/// `stage` or `stage.port` as someone wrote it behind `in:` or under `outputs:`.
struct Wire {
  std::string input;  ///< of the reading stage; empty in the short form `in: X`
  Place input_place;
  std::string stage, port;  ///< what is read; the port may be empty
  Place place;
  std::optional<std::size_t> producer;  ///< place of `stage` among the drafts, if there is one
};

/// A stage while it is being checked. Where something about it is unknown, that has been reported
/// and nothing that follows from it is.
struct StageDraft {
  std::string name;  ///< of an export: the output's name
  Place place;
  std::string use;
  Place use_place;
  const StageRecord* record = nullptr;  ///< null: no such stage
  bool is_export = false;
  const LocatedNode* params = nullptr;
  std::vector<Wire> wires;
  bool wires_broken = false;  ///< some wire could not be read

  std::vector<std::optional<PlannedSource>> inputs;  ///< by draft; as record->info.inputs
  std::vector<Place> input_places;
  std::vector<bool> streams;  ///< as record->info.outputs
  std::vector<ParameterValue> parameters;
  bool read = false;  ///< some stage or output reads it

  /// "Stage 'roads' (topology/watershed)", to begin a sentence with.
  std::string subject() const;
};

/// Reads the body of a stage or of an output's long form: `{use, in, params}`. `names` are the
/// parameters to mention if one stands outside `params:`.
void read_body(StageDraft& draft, const LocatedNode& body, const Catalogue& catalogue,
               Diagnostics& diagnostics);

/// Makes drafts of everything under `stages:`.
std::vector<StageDraft> draft_stages(const LocatedNode* stages, const Catalogue& catalogue,
                                     Diagnostics& diagnostics);

/// The part of an id before the slash, with it: `topology/`.
std::string family_of(const std::string& id);

/// The ids of all stages of a family, such as `topology/`.
std::vector<std::string> members_of(const Catalogue& catalogue, const std::string& family);

}  // namespace stope
