// Problem: is a path what it claims to be, one that a truck can drive?
// Idea: take nothing on trust but the points. Bends are measured from headings and, again, from
// positions alone; the outline is a polygon whose distance to each obstacle square nearby is
// computed corner by corner and edge by edge; slopes come from the elevation under both axles. It
// shares no code with the planners on purpose: an error of theirs must not hide here.
// Cost: the cells under and around the truck for each kLook metres of way.
#include "plugins/metric/drive_validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plugins/metric/outline_clearance.hpp"
#include "plugins/metric/path_motion.hpp"
#include "stope/error.hpp"

namespace stope::metric {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// Height between four cell centres, by weights; NaN where one of them is not known.
double ground_height(const ElevationGrid& elevation, double x, double y) {
  const Vector2 at = elevation.frame.to_grid(x, y) - Vector2(0.5, 0.5);
  if (!(at.x() >= -0.5 && at.y() >= -0.5 && at.x() <= elevation.frame.width - 0.5 &&
        at.y() <= elevation.frame.height - 0.5))
    return kNaN;
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const double column = std::floor(at.x()) + (k & 1), row = std::floor(at.y()) + (k >> 1);
    const double weight = (1 - std::abs(at.x() - column)) * (1 - std::abs(at.y() - row));
    const Cell cell{std::clamp(static_cast<std::int32_t>(column), 0, elevation.frame.width - 1),
                    std::clamp(static_cast<std::int32_t>(row), 0, elevation.frame.height - 1)};
    sum += weight * static_cast<double>(elevation.cells[elevation.frame.place(cell)]);
  }
  return sum;
}

class Validator {
 public:
  Validator(const Path& path, const OccupancyGrid& grid, const ElevationGrid* elevation,
            const TruckLimits& truck)
      : points_(path.points), grid_(grid), elevation_(elevation), truck_(truck) {}

  DriveValidity run(const std::function<void()>& checkpoint) {
    found_.least_clearance = DriveValidity::kFarthest;
    if (!elevation_) found_.steepest = kNaN;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
      motions_.push_back(motion_between(points_[i], points_[i + 1]));
    double tightest = 0;
    look({points_[0].x, points_[0].y, points_[0].yaw}, 0);
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      if (i % 64 == 0) checkpoint();
      tightest = std::max(tightest, std::abs(motions_[i].curvature));
      check_motion(i);
      sweep(i);
      check_statements(i);
      found_.length += motions_[i].length;
    }
    check_statements(motions_.size());
    count_standstills();
    found_.least_radius = 1 / std::max(tightest, 1e-12);
    return found_;
  }

 private:
  void violate(std::size_t& count, double x, double y, double along, const std::string& what) {
    ++count;
    if (found_.first.empty())
      found_.first =
          fmt::format("at ({:.2f}, {:.2f}), {:.1f} m along the path, {}", x, y, along, what);
  }

  void check_motion(std::size_t i) {
    const PathPoint& here = points_[i];
    const PathMotion& motion = motions_[i];
    const double along = found_.length, most = 1 / truck_.turning_radius;
    if (!(motion.length >= 1e-4) || motion.length > 1.1) {
      violate(
          found_.headings, here.x, here.y, along,
          fmt::format("the next point is {:.4f} m away: at most 1 m can be judged", motion.length));
      return;
    }
    found_.heading_error =
        std::max(found_.heading_error, std::max(0.0, motion.slide - 1e-3) / motion.length);
    if (motion.slide > std::max(1e-3, 0.01 * motion.length)) {
      violate(found_.headings, here.x, here.y, along,
              fmt::format("the truck would slide {:.3f} m sideways: its heading is not that of its "
                          "motion",
                          motion.slide));
    }
    if (std::abs(motion.curvature) > most * 1.001) {
      violate(found_.turns, here.x, here.y, along,
              fmt::format("the heading turns with a radius of {:.2f} m, the truck needs {:.2f} m",
                          1 / std::abs(motion.curvature), truck_.turning_radius));
    }
    if (i == 0) return;
    if (motion.backwards != motions_[i - 1].backwards) {
      ++found_.cusps;
      return;
    }
    const double circle = circle_through({points_[i - 1].x, points_[i - 1].y}, {here.x, here.y},
                                         {points_[i + 1].x, points_[i + 1].y});
    if (circle > most * 1.01) {
      violate(found_.turns, here.x, here.y, along,
              fmt::format("the points lie on a circle of {:.2f} m, the truck needs {:.2f} m",
                          1 / circle, truck_.turning_radius));
    }
  }

  void sweep(std::size_t i) {
    const PathPoint &a = points_[i], &b = points_[i + 1];
    const PathMotion& motion = motions_[i];
    const double count = std::clamp(std::ceil(motion.length / kLook), 1.0, 1e4);
    // The arc's bulge to the side of the chord.
    const Vector2 chord(b.x - a.x, b.y - a.y);
    const double bulge = -std::tan(motion.turn / 4) / 2;
    for (double k = 1; k <= count; ++k) {
      const double t = k / count, side = 4 * t * (1 - t) * bulge;
      const Vector2 at = Vector2(a.x, a.y) + t * chord + side * Vector2(-chord.y(), chord.x());
      look({at.x(), at.y(), a.yaw + t * motion.turn}, found_.length + t * motion.length);
    }
  }

  void look(const Pose2& pose, double along) {
    const double clearance = clearance_of(outline_of(truck_, pose), grid_,
                                          std::max(DriveValidity::kFarthest, truck_.margin));
    found_.least_clearance = std::min(found_.least_clearance, clearance);
    if (clearance == 0 || clearance < truck_.margin - 1e-9) {
      violate(found_.touches, pose.x, pose.y, along,
              fmt::format("the outline comes within {:.3f} m of an obstacle, it must keep {:.3f} m",
                          clearance, truck_.margin));
    }
    if (!elevation_) return;
    const double rise = ground_height(*elevation_, pose.x + truck_.wheelbase * std::cos(pose.yaw),
                                      pose.y + truck_.wheelbase * std::sin(pose.yaw)) -
                        ground_height(*elevation_, pose.x, pose.y);
    const double grade = std::abs(rise) / truck_.wheelbase;
    if (grade > found_.steepest) found_.steepest = grade;
    if (!(grade <= truck_.max_grade)) {
      violate(found_.slopes, pose.x, pose.y, along,
              std::isnan(grade) ? std::string("the elevation under the truck is not known")
                                : fmt::format("the slope is {:.2f} %, the truck climbs {:.2f} %",
                                              100 * grade, 100 * truck_.max_grade));
    }
  }

  void check_statements(std::size_t i) {
    const PathPoint& point = points_[i];
    const PathMotion& before = motions_[i == 0 ? 0 : i - 1];
    const PathMotion& after = motions_[std::min(i, motions_.size() - 1)];
    const auto [low, high] = std::minmax(before.curvature, after.curvature);
    const double off = std::max({0.0, low - point.curvature, point.curvature - high});
    const double most = 1.001 / truck_.turning_radius;
    found_.curvature_error = std::max(found_.curvature_error, off);
    found_.lateral_acceleration = std::max(found_.lateral_acceleration,
                                           point.speed * point.speed * std::abs(point.curvature));
    if (!(off <= kCurvatureError) || !(std::abs(point.curvature) <= most)) {
      violate(found_.statements, point.x, point.y, found_.length,
              fmt::format("a curvature of {:.4f} is stated, {:.4f} to {:.4f} 1/m is driven",
                          point.curvature, low, high));
    }
    const bool moves_back = point.speed < 0;
    if (point.speed != 0 && moves_back != before.backwards && moves_back != after.backwards) {
      violate(found_.statements, point.x, point.y, found_.length,
              "the sign of the speed is not that of the motion");
    }
  }

  /// Several points in a row where the truck stands are one stop.
  void count_standstills() {
    const auto stands = [](const PathPoint& point) { return point.speed == 0; };
    if (std::all_of(points_.begin(), points_.end(), stands)) return;
    const auto moves = std::find_if_not(points_.begin(), points_.end(), stands);
    for (auto stop = std::find_if(moves, points_.end(), stands); stop != points_.end();) {
      const auto on = std::find_if_not(stop, points_.end(), stands);
      if (on == points_.end()) break;  // its end
      ++found_.standstills;
      stop = std::find_if(on, points_.end(), stands);
    }
  }

  const std::vector<PathPoint>& points_;
  const OccupancyGrid& grid_;
  const ElevationGrid* elevation_;
  const TruckLimits truck_;
  std::vector<PathMotion> motions_;
  DriveValidity found_;
};

}  // namespace

DriveValidity check_drive(const Path& path, const OccupancyGrid& grid,
                          const ElevationGrid* elevation, const TruckLimits& truck,
                          const std::function<void()>& checkpoint) {
  if (path.points.size() < 2) {
    throw Error(
        fmt::format("the path has {} points: at least two are needed to judge how it is driven",
                    path.points.size()));
  }
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const PathPoint& point = path.points[i];
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.yaw) ||
        std::max(std::abs(point.x), std::abs(point.y)) > 1e9) {
      throw Error(fmt::format("point {} of the path has no finite place and heading: ({}, {}), {}",
                              i, point.x, point.y, point.yaw));
    }
  }
  return Validator(path, grid, elevation, truck).run(checkpoint);
}

}  // namespace stope::metric
