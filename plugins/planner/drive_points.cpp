#include "plugins/planner/drive_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stope::planner {
namespace {

constexpr double kJump = 1e-3;     // 1/m: less is no turn of the wheels on the spot
constexpr double kNearest = 0.1;   // metres between points, unless something changes there
constexpr double kClosest = 1e-3;  // metres

/// A place between two pieces where direction or curvature is not continuous.
struct Break {
  double along;
  bool cusp;
};

std::vector<Break> breaks_of(const DriveCurve& curve) {
  std::vector<Break> breaks;
  double along = 0;
  const CurvePiece* before = nullptr;
  for (const CurvePiece& piece : curve.pieces) {
    if (piece.length == 0) continue;
    if (before) {
      const bool cusp = (before->length < 0) != (piece.length < 0);
      if (cusp || std::abs(piece.curvature - before->curvature_end) > kJump)
        breaks.push_back({along, cusp});
    }
    before = &piece;
    along += std::abs(piece.length);
  }
  return breaks;
}

}  // namespace

std::size_t cusps_of(const DriveCurve& curve) {
  const auto breaks = breaks_of(curve);
  return static_cast<std::size_t>(
      std::count_if(breaks.begin(), breaks.end(), [](const Break& place) { return place.cusp; }));
}

std::vector<PathPoint> drive_points(const DriveCurve& curve, const Drivability& ground,
                                    const ElevationGrid* elevation, double step) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const auto breaks = breaks_of(curve);
  const std::vector<CurvePlace> all = places_along(curve, step);
  std::vector<PathPoint> points;
  std::size_t next = 0;
  double last = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool wanted = i == 0 || i + 1 == all.size() || all[i].along - last >= kNearest;
    while (next < breaks.size() && all[i].along >= breaks[next].along - 1e-9) {
      wanted = true;
      ++next;
    }
    if (!wanted) continue;
    // Closer than that two points would say nothing of the way between them.
    if (!points.empty() && all[i].along - last < kClosest) {
      if (i + 1 < all.size() || points.size() < 2) continue;
      points.pop_back();
    }
    last = all[i].along;
    const Pose2& pose = all[i].pose;
    PathPoint point;
    point.x = pose.x, point.y = pose.y;
    point.z = elevation ? height_at(*elevation, pose.x, pose.y).value_or(kUnknown) : kUnknown;
    point.yaw = std::remainder(pose.yaw, 2 * std::numbers::pi);
    point.curvature = all[i].curvature;
    point.clearance = ground.footprint().clearance(pose);
    points.push_back(point);
  }
  return points;
}

}  // namespace stope::planner
