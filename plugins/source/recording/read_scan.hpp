#pragma once

#include <cstddef>

#include "stope/payloads/lidar_scan.hpp"

namespace stope::source {

/// A scan as read, and how many of its points had a coordinate that is not finite and were left
/// out.
struct ReadScan {
  LidarScan scan;
  std::size_t dropped = 0;
};

}  // namespace stope::source
