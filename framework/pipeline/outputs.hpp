#pragma once

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// An entry under `outputs:`, drafted as an export stage.
struct OutputDraft {
  std::string name;
  std::string stem;       ///< the name's last part without the extension
  std::size_t draft = 0;  ///< place of the export among the drafts
  Place place;
};

/// Adds an export to the drafts for everything under `outputs:`. The short form `name.ext: X` finds
/// the one export that writes `.ext` and takes what X gives; the long form `name.ext: {use, in,
/// params}` names it. Connects each; reports names that leave the folder, formats that nothing
/// writes, and exports that do not take what they are given.
std::vector<OutputDraft> draft_outputs(const LocatedNode* outputs, std::vector<StageDraft>& drafts,
                                       const Catalogue& catalogue, Diagnostics& diagnostics);

/// Reports outputs that would be written to the same place. A stream `roads.png` is the folder
/// `roads/` with `000000.png` and so on.
void check_collisions(const std::vector<OutputDraft>& outputs,
                      const std::vector<StageDraft>& drafts, Diagnostics& diagnostics);

}  // namespace stope
