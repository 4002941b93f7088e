#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "stope/about.hpp"

namespace stope::planner {

/// A truck that steers with its front wheels. Its pose is that of the middle of its rear axle, its
/// outline a rectangle around it. All in metres.
struct Vehicle {
  double length = 9, width = 4;
  double rear_overhang = 2.5;  ///< from the rear axle back to the tail
  double wheelbase = 5.15;     ///< between the axles
  double turning_radius = 12;  ///< least radius of the rear axle's way
  double max_grade = 0.12;     ///< rise over run between the axles
  double margin = 0.5;         ///< kept free on all sides of the outline
  double steering_distance =
      6;  ///< driven while the wheels go from straight to full lock; 0: they turn on the spot

  double nose() const { return length - rear_overhang; }
  /// Turns tighter than half the width would roll an inner rear wheel backwards; a tenth of the
  /// length bounds what one metre of way can sweep, whatever the width.
  double least_turning_radius() const { return std::max(width / 2, length / 10); }
  double max_curvature() const { return 1 / turning_radius; }
  /// Greatest change of curvature by the metre; infinite if the wheels may turn on the spot.
  double max_curvature_rate() const { return max_curvature() / steering_distance; }
  /// From the rear axle's middle to the farthest corner of the outline.
  double reach() const { return std::hypot(std::max(nose(), rear_overhang), width / 2); }
};

/// Equal circles along the vehicle's middle line that together cover its outline.
struct CoveringCircles {
  static constexpr std::size_t kCount = 5;
  explicit CoveringCircles(const Vehicle& vehicle) {
    const double share = vehicle.length / kCount;
    radius = std::hypot(share / 2, vehicle.width / 2);
    for (std::size_t i = 0; i < kCount; ++i)
      offsets[i] = (static_cast<double>(i) + 0.5) * share - vehicle.rear_overhang;
  }
  std::array<double, kCount> offsets{};  ///< of their centres, ahead of the rear axle
  double radius = 0;
};

/// Declares a vehicle's parameters, the same in every stage that drives one.
template <class S>
void describe_vehicle(About<S>& about) {
  about
      .param("turning_radius", &Vehicle::turning_radius, "m", more_than(0.0),
             "Least radius of the way of the rear axle's middle; at least half the width and a "
             "tenth of the length.")
      .param("length", &Vehicle::length, "m", at_least(0.1), "Length of the truck.")
      .param("width", &Vehicle::width, "m", at_least(0.1), "Width of the truck.")
      .param(
          "rear_overhang", &Vehicle::rear_overhang, "m", at_least(0.0),
          "From the rear axle back to the tail; the rear axle's middle is what follows the path.")
      .param("wheelbase", &Vehicle::wheelbase, "m", more_than(0.0), "Between the axles.")
      .param("max_grade", &Vehicle::max_grade, more_than(0.0),
             "Steepest slope between the axles, rise over run, where elevation is wired.")
      .param("margin", &Vehicle::margin, "m", at_least(0.0),
             "Room kept free on all sides of the truck.")
      .param("steering_distance", &Vehicle::steering_distance, "m", at_least(0.0),
             "Driven while the wheels go from straight to full lock; 0 lets curvature jump.");
}

/// Throws Error, a sentence, if the sizes do not make a truck.
void check_vehicle(const Vehicle& vehicle);

}  // namespace stope::planner
