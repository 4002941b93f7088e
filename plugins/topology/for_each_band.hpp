#pragma once

#include <cstdint>
#include <functional>

#include "plugins/topology/checkpoint.hpp"

namespace stope::topology {

/// Works on one band of rows.
using BandWork = std::function<void(std::int32_t band)>;

/// Works on bands 0 to before `bands`, side by side on the threads of the caller's oneTBB arena, so
/// in no particular order: the work on a band must not depend on that on others. Each thread gets
/// work of its own from `make_work`, with what memory it needs. The checkpoint is called by the
/// calling thread only, before each band it works on; what it throws ends all of it.
void for_each_band(std::int32_t bands, const Checkpoint& checkpoint,
                   const std::function<BandWork()>& make_work);

}  // namespace stope::topology
