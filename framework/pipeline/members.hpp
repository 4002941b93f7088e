#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// The ids of all stages that can take the place of this one by changing `use` alone: of the same
/// family, with the same required inputs (names and types) and at least its outputs; of a source just
/// its outputs. The stage itself is among them. Empty if there is no such stage.
std::vector<std::string> interchangeable_members(const Catalogue& catalogue, std::string_view id);

/// The ids of other members of a drafted stage's family that its wires would fit: those it has and
/// those others have to it.
std::vector<std::string> members_that_fit(const std::vector<StageDraft>& drafts, std::size_t stage,
                                          const Catalogue& catalogue);

}  // namespace stope
