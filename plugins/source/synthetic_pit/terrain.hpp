#pragma once

#include <cstdint>
#include <vector>

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/layout.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::source {

/// A machine's place: a rectangle of level ground beside a turning place, where it stands.
struct Pad {
  Vector2 centre = Vector2::Zero();
  double yaw = 0;
  double half_length = 0, half_width = 0;
  double level = 0;
  bool contains(const Vector2& place, double grow) const;
};

/// The finished ground on a grid: cell centres carry it, between them it is bilinear.
struct Terrain {
  GridFrame frame;
  std::vector<float> height;           ///< metres
  std::vector<std::uint8_t> label;     ///< a PointLabel: ground, wall or berm
  std::vector<std::uint8_t> drivable;  ///< 1 where the centre lies in the drivable area

  /// Height between the cells' centres; beyond the border that of the border.
  double height_at(double x, double y) const;
};

/// Cuts and fills roads into the shape, piles berms along their edges, and strews rubble over the
/// rest.
Terrain build_terrain(const Layout& layout, const PitParameters& parameters,
                      const std::vector<Pad>& pads, std::uint64_t seed,
                      const Checkpoint& checkpoint = never_stop);

}  // namespace stope::source
