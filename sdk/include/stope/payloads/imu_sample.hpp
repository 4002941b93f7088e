#pragma once

#include <string_view>

#include "stope/geometry.hpp"

namespace stope {

/// One reading of an inertial measurement unit, in the IMU's frame. The item's stamp is the time of
/// measurement.
struct ImuSample {
  static constexpr std::string_view kType = "stope/ImuSample@1";
  Vector3 acceleration = Vector3::Zero();      ///< specific force, m/s^2 (upward 9.81 at rest)
  Vector3 angular_velocity = Vector3::Zero();  ///< rad/s
  static constexpr void fields(auto& s, auto&& visit) {
    visit("acceleration", s.acceleration);
    visit("angular_velocity", s.angular_velocity);
  }
};

}  // namespace stope
