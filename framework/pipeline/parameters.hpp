#pragma once

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// Fills a draft's parameters from its `params:`, with defaults for what is not written. A block
/// keyed by a member of the family (`topology/voronoi: {…}`) is applied if it is the one used, and
/// only checked otherwise; it wins over what stands beside it.
void read_parameters(StageDraft& draft, const Catalogue& catalogue, Diagnostics& diagnostics);

}  // namespace stope
