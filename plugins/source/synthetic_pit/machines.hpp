#pragma once

#include <cstdint>
#include <vector>

#include "plugins/source/synthetic_pit/layout.hpp"
#include "plugins/source/synthetic_pit/terrain.hpp"

namespace stope::source {

/// An upright box: part of a machine.
struct Box {
  Vector3 centre = Vector3::Zero();  ///< metres, map frame
  Vector3 half = Vector3::Zero();    ///< half of length, width and height
  double yaw = 0;                    ///< of the length, radians
  /// Distance along the ray to its first meeting with the box, or infinity.
  double cast(const Vector3& origin, const Vector3& direction) const;
};

/// Machines parked around turning places, nose to the edge of the drivable area, so that they do
/// not change it.
struct Machines {
  std::vector<Pad> pads;
  std::vector<Box> boxes;
};
Machines park_machines(const Layout& layout, const PitParameters& parameters, std::uint64_t seed);

}  // namespace stope::source
