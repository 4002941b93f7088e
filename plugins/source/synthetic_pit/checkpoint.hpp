#pragma once

#include <functional>

namespace stope::source {

/// Asked every few milliseconds while a pit is made; throws to give the work up, as
/// Context::stop_if_cancelled() does. Several threads may ask at once.
using Checkpoint = std::function<void()>;

/// For work that nobody will want to stop.
inline void never_stop() {}

}  // namespace stope::source
