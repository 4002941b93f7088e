#pragma once

#include <functional>
#include <string>

#include "stope/payloads/elevation_grid.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/path.hpp"

namespace stope::metric {

/// A truck as its maker states it, in metres. A path's points are where the middle of its rear axle
/// is.
struct TruckLimits {
  double length = 9, width = 4, rear_overhang = 2.5, wheelbase = 5.15;
  double turning_radius = 12;
  double max_grade = 0.12;  ///< rise over run between the axles
  double margin = 0.5;      ///< metres that must stay free around the outline
};

/// What was found along a path, and how often it breaks a limit.
struct DriveValidity {
  double length = 0;                ///< metres, along arcs through the points
  double least_radius = 0;          ///< metres, of the tightest bend between two points
  double least_clearance = 0;       ///< metres between outline and obstacles, at most kFarthest
  double steepest = 0;              ///< rise over run; NaN without elevation
  double curvature_error = 0;       ///< 1/m, between stated and driven curvature
  double heading_error = 0;         ///< radians, between heading and direction of motion
  double lateral_acceleration = 0;  ///< m/s², at the stated speeds
  std::size_t turns = 0, touches = 0, slopes = 0, headings = 0, statements = 0;  ///< violations
  std::size_t cusps = 0;
  /// Places between the ends where the stated speed is 0; none are counted if all speeds are.
  std::size_t standstills = 0;
  std::string first;  ///< the first violation, a sentence; empty: none
  std::size_t violations() const { return turns + touches + slopes + headings + statements; }
  static constexpr double kFarthest = 3;
};

/// Looks at a path as the truck would drive it, knowing nothing of how it was planned: between two
/// points along the arc that joins them, every kLook metres.
///
///   turn       the heading turns by more a metre than 1 / turning_radius (by 0.1 % or more), or
///              the circle through three points in a row is smaller (by 1 % or more)
///   heading    the truck would have to slide: its motion is not along its heading (by 0.01 rad, or
///              1 mm), or two points are more than 1.1 m or less than 0.1 mm apart
///   touch      an obstacle cell, as a closed square, comes nearer to the outline than `margin`;
///              what is unknown or off the map is an obstacle
///   slope      front and rear axle stand on ground whose slope exceeds max_grade, or is not known
///   statement  the stated curvature is off that of the bends before and behind the point by more
///              than kCurvatureError, or the stated speed has the wrong sign
///
/// Throws Error, a sentence, if the path has fewer than two points or one that is not finite.
DriveValidity check_drive(
    const Path& path, const OccupancyGrid& grid, const ElevationGrid* elevation,
    const TruckLimits& truck, const std::function<void()>& checkpoint = [] {});

constexpr double kLook = 0.1;              // metres
constexpr double kCurvatureError = 0.005;  // 1/m

}  // namespace stope::metric
