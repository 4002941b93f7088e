#pragma once

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// The drafts in topological order: every stage after those it reads, otherwise as written. Reports
/// each cycle by naming its stages; those on one, and those that read them, are left out.
std::vector<std::size_t> order_stages(const std::vector<StageDraft>& drafts,
                                      Diagnostics& diagnostics);

/// Works out in that order which outputs carry streams: of a map, if a wired input does; else as
/// declared. Reports streams wired into inputs that take one value.
void find_streams(std::vector<StageDraft>& drafts, const std::vector<std::size_t>& order,
                  Diagnostics& diagnostics);

}  // namespace stope
