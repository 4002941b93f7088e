#pragma once

#include <cmath>
#include <cstdint>

namespace stope {

/// A point in time, in nanoseconds since an epoch the recording chooses. The same clock for all
/// sensors of a run.
using Stamp = std::int64_t;

/// Nanoseconds of `seconds`, rounded to the nearest.
inline Stamp stamp_from_seconds(double seconds) { return std::llround(seconds * 1e9); }

/// Seconds of a stamp or of a difference of stamps.
inline double seconds_from_stamp(Stamp stamp) { return static_cast<double>(stamp) * 1e-9; }

}  // namespace stope
