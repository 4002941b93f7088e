#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "stope/geometry.hpp"

namespace stope {

/// One solution of a GNSS or INS receiver, in the map frame. The item's stamp is the time it is
/// valid for.
struct NavFix {
  static constexpr std::string_view kType = "stope/NavFix@1";
  enum class Quality : std::uint8_t { kNone, kSingle, kDifferential, kFloat, kFixed, kInertial };
  Pose T_map_nav;                       ///< rotation is identity where has_attitude is false
  std::array<double, 36> covariance{};  ///< row-major; translation (m), then rotation (rad)
  Vector3 velocity = Vector3::Zero();   ///< m/s, map frame
  bool has_attitude = false;
  bool has_velocity = false;
  Quality quality = Quality::kNone;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("T_map_nav", s.T_map_nav);
    visit("covariance", s.covariance);
    visit("velocity", s.velocity);
    visit("has_attitude", s.has_attitude);
    visit("has_velocity", s.has_velocity);
    visit("quality", s.quality);
  }
};

}  // namespace stope
