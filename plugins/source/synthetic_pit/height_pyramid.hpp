#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/terrain.hpp"

namespace stope::source {

/// Where a ray meets the ground.
struct GroundHit {
  double range = 0;  ///< metres along the ray
  Cell cell;         ///< of the terrain, the nearest to the hit
};

/// Casts rays against a terrain, exactly against its bilinear surface.
class HeightPyramid {
 public:
  /// Keeps a reference to `terrain`.
  explicit HeightPyramid(const Terrain& terrain, const Checkpoint& checkpoint = never_stop);
  /// The first meeting of the ray from `origin` along the unit vector `direction`, if it is nearer
  /// than `max_range` and on the map.
  std::optional<GroundHit> cast(const Vector3& origin, const Vector3& direction,
                                double max_range) const;

 private:
  struct Level {
    std::int32_t width = 0, height = 0;
    std::vector<float> highest;
  };
  std::optional<double> meet_patch(std::int32_t column, std::int32_t row,
                                   const std::array<double, 3>& enter,
                                   const std::array<double, 3>& leave) const;
  const Terrain& terrain_;
  std::vector<Level> levels_;  ///< from single patches between four cell centres upwards
};

}  // namespace stope::source
