#pragma once

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// Reads what stands behind `in:`, `X` or `{input: X, …}`, into the draft's wires.
void read_wires(StageDraft& draft, const LocatedNode& in, Diagnostics& diagnostics);

/// Reads `stage` or `stage.port`. Reports anything else and gives nothing then.
std::optional<Wire> read_wire(const LocatedNode& node, Diagnostics& diagnostics);

/// Finds each wire's producer among the drafts, marks it as read, and reports the wires that name
/// no stage.
void find_producers(std::vector<StageDraft>& drafts, StageDraft& reader, Diagnostics& diagnostics);

}  // namespace stope
