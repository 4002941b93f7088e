#pragma once

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// Connects the inputs of one draft to the outputs its wires name. Reports unknown ports, missing
/// inputs, wires that could mean several ports, and payload types that differ in name or layout;
/// where members of the stage's family would fit, names them.
void connect(std::vector<StageDraft>& drafts, std::size_t stage, const Catalogue& catalogue,
             Diagnostics& diagnostics);

}  // namespace stope
