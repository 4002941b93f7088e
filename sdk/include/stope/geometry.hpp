#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace stope {

/// Fixed-size, unaligned Eigen types: the only ones that may sit inside a payload, so that its
/// layout does not depend on how a plugin was compiled.
using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;
using Vector3 = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// A point of a scan or cloud, in metres. Single precision: keep it relative to a nearby origin.
struct Point3f {
  float x = 0, y = 0, z = 0;
  bool operator==(const Point3f&) const = default;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("x", s.x);
    visit("y", s.y);
    visit("z", s.z);
  }
};

/// A pose in the plane: metres, and radians counter-clockwise from the x axis (east).
struct Pose2 {
  double x = 0, y = 0, yaw = 0;
  bool operator==(const Pose2&) const = default;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("x", s.x);
    visit("y", s.y);
    visit("yaw", s.yaw);
  }
};

/// A rigid transform. `T_a_b` maps a point of frame b into frame a: p_a = T_a_b * p_b.
struct Pose {
  Vector3 translation = Vector3::Zero();           ///< metres
  Quaternion rotation = Quaternion(1.0, 0, 0, 0);  ///< unit length

  Vector3 operator*(const Vector3& point) const { return rotation * point + translation; }
  Pose operator*(const Pose& other) const {
    return {*this * other.translation, (rotation * other.rotation).normalized()};
  }
  Pose inverse() const {
    const Quaternion back = rotation.conjugate();
    return {back * Vector3(-translation), back};
  }
  /// Heading of the x axis in the plane, radians.
  double yaw() const {
    const Vector3 forward = rotation * Vector3(Vector3::UnitX());
    return std::atan2(forward.y(), forward.x());
  }
  static constexpr void fields(auto& s, auto&& visit) {
    visit("translation", s.translation);
    visit("rotation", s.rotation);
  }
};

/// The pose `fraction` of the way from `a` to `b`: translation linear, rotation by spherical
/// interpolation.
inline Pose interpolate(const Pose& a, const Pose& b, double fraction) {
  return {a.translation + fraction * (b.translation - a.translation),
          a.rotation.slerp(fraction, b.rotation)};
}

}  // namespace stope
