#pragma once

#include <cstdint>

namespace stope {

/// What a point was measured on.
enum class PointLabel : std::uint8_t {
  kUnknown = 0,
  kGround = 1,
  kWall = 2,
  kBerm = 3,
  kObject = 4,
  kMoving = 5
};

}  // namespace stope
