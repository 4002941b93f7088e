#pragma once

#include <functional>

namespace stope::topology {

/// Called by a long computation every few milliseconds; gives it up by throwing.
using Checkpoint = std::function<void()>;

/// For callers who let a computation run to its end.
inline void never_stop() {}

/// How many rows of a grid are worked on between two calls.
constexpr int kRowsBetweenCheckpoints = 128;

}  // namespace stope::topology
