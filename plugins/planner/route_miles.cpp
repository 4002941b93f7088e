// Problem: a truck stands somewhere off its route, and must come onto it, and off it again at the
// loader.
// Idea: a hybrid search from where it stands to several places of the route at once takes the one
// that is cheapest to join; at the other end it starts from places farther and farther before the
// route's end. Both arrive by a word of Reeds and Shepp, so that place and heading fit exactly.
// Cost: one search for each end, a few if the last places do not serve.
#include "plugins/planner/route_miles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plugins/planner/drive_points.hpp"
#include "plugins/planner/hybrid_search.hpp"
#include "plugins/planner/refusal.hpp"
#include "plugins/planner/route_line.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

constexpr double kAround = 50;             // metres around both ends that a search may use
constexpr std::size_t kMostPoses = 60000;  // of a search
constexpr double kSame = 1e-6;

Pose2 pose_of(const PathPoint& point) { return {point.x, point.y, point.yaw}; }

bool same(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) < kSame &&
         std::abs(std::remainder(a.yaw - b.yaw, 2 * std::numbers::pi)) < kSame;
}

/// Refuses a path that is no curve for this truck.
void check_bends(const std::vector<PathPoint>& points, const Vehicle& vehicle) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const PathPoint &a = points[i - 1], &b = points[i];
    const double turn = std::abs(std::remainder(b.yaw - a.yaw, 2 * std::numbers::pi));
    const double way = std::hypot(b.x - a.x, b.y - a.y);
    const double middle = a.yaw + std::remainder(b.yaw - a.yaw, 2 * std::numbers::pi) / 2;
    const double slide = std::abs(std::cos(middle) * (b.y - a.y) - std::sin(middle) * (b.x - a.x));
    if (turn <= 1.002 * vehicle.max_curvature() * way && slide <= 0.01 * way + 1e-3) continue;
    throw Error(fmt::format(
        "at {} the path is no curve that this truck can drive (it turns by {:.1f} degrees within "
        "{:.2f} m): put planner/smooth before this stage, with the same truck",
        text_of_place(a.x, a.y), turn * 180 / std::numbers::pi, way));
  }
}

class Miles {
 public:
  Miles(const Path& path, const OccupancyGrid& grid, const ElevationGrid* elevation,
        const MileRequest& request, const std::function<void()>& checkpoint)
      : grid_(grid),
        elevation_(elevation),
        request_(request),
        checkpoint_(checkpoint),
        points_(path.points) {
    along_.push_back(0);
    for (std::size_t i = 1; i < points_.size(); ++i)
      along_.push_back(along_.back() + std::hypot(points_[i].x - points_[i - 1].x,
                                                  points_[i].y - points_[i - 1].y));
  }

  /// Returns what the first mile is, for the log.
  std::string add_first(const Pose2& start) {
    if (same(start, pose_of(points_.front()))) return {};
    std::vector<std::size_t> places;
    const double most = std::min(request_.join_within, along_.back());
    for (int i = 0; i <= 8; ++i) places.push_back(place_at(most * i / 8));
    std::vector<Pose2> goals;
    for (const std::size_t place : places) goals.push_back(pose_of(points_[place]));
    const auto curve = search(start, goals);
    if (!curve) {
      throw Error(fmt::format(
          "no way was found from the start {} onto the path within {:.0f} m of its beginning: {}",
          text_of_place(start.x, start.y), request_.join_within, advice(start)));
    }
    std::size_t joined = 0;
    for (std::size_t i = 0; i < goals.size(); ++i)
      if (same(curve->end(), goals[i])) joined = places[i];
    auto mile = points_of(*curve);
    mile.insert(mile.end(), points_.begin() + static_cast<std::ptrdiff_t>(joined) + 1,
                points_.end());
    const std::string text = describe("first", *curve, points_[joined]);
    replace(std::move(mile));
    return text;
  }

  std::string add_last(const std::vector<Pose2>& goals) {
    const Pose2 end = pose_of(points_.back());
    if (request_.goal_area.holds(end))
      return fmt::format("the path already ends in the goal_area, at {}: there is no last mile",
                         text_of_place(end.x, end.y));
    for (const Pose2& goal : goals)
      if (same(goal, end)) return {};
    for (const double share : {0.0, 0.15, 0.3, 0.6, 1.0}) {
      const double most = std::min(request_.join_within, along_.back());
      const std::size_t place = place_at(along_.back() - share * most);
      const auto curve = search(pose_of(points_[place]), goals);
      if (!curve) continue;
      std::vector<PathPoint> all(points_.begin(),
                                 points_.begin() + static_cast<std::ptrdiff_t>(place));
      const auto mile = points_of(*curve);
      const std::string text = describe("last", *curve, points_[place]);
      // The curvature at the place where the path is left is that of the way before it.
      const double before = points_[place].curvature;
      all.insert(all.end(), mile.begin(), mile.end());
      if (place > 0) all[place].curvature = before;
      replace(std::move(all));
      return text;
    }
    throw Error(fmt::format("no way was found from the path's last {:.0f} m to the goal {}: {}",
                            request_.join_within, text_of_place(goals.front().x, goals.front().y),
                            advice(goals.front())));
  }

  std::vector<PathPoint> take() { return std::move(points_); }
  double length() const { return along_.back(); }

 private:
  std::size_t place_at(double along) const {
    const auto found = std::lower_bound(along_.begin(), along_.end(), along - 1e-9);
    return std::min(static_cast<std::size_t>(found - along_.begin()), points_.size() - 1);
  }

  void replace(std::vector<PathPoint> points) {
    points_ = std::move(points);
    along_.assign(1, 0);
    for (std::size_t i = 1; i < points_.size(); ++i)
      along_.push_back(along_.back() + std::hypot(points_[i].x - points_[i - 1].x,
                                                  points_[i].y - points_[i - 1].y));
  }

  std::optional<DriveCurve> search(const Pose2& from, const std::vector<Pose2>& goals) const {
    const ClearanceField field(grid_, box_of(from, goals), kAround);
    const Drivability ground(request_.vehicle, grid_, field, elevation_);
    return hybrid_search(from, goals, ground, field,
                         {request_.allow_reverse, request_.vehicle.turning_radius, kMostPoses},
                         checkpoint_)
        .curve;
  }

  static MapBox box_of(const Pose2& from, const std::vector<Pose2>& goals) {
    MapBox box{from.x, from.y, from.x, from.y};
    for (const Pose2& goal : goals) {
      box.left = std::min(box.left, goal.x), box.right = std::max(box.right, goal.x);
      box.bottom = std::min(box.bottom, goal.y), box.top = std::max(box.top, goal.y);
    }
    return box;
  }

  std::vector<PathPoint> points_of(const DriveCurve& curve) const {
    const ClearanceField field(grid_, box_of(curve.start, {curve.end()}), kAround + 20);
    const Drivability ground(request_.vehicle, grid_, field, elevation_);
    return drive_points(curve, ground, elevation_, request_.step);
  }

  std::string advice(const Pose2& pose) const {
    const ClearanceField field(grid_, box_of(pose, {}), kAround);
    const Drivability ground(request_.vehicle, grid_, field, elevation_);
    if (const auto why = ground.obstruction_at(pose)) {
      if (why->kind == Obstruction::Kind::kFootprint) {
        return fmt::format(
            "the truck cannot even stand there, its footprint would touch an obstacle "
            "at {}",
            text_of_place(why->obstacle.x(), why->obstacle.y()));
      }
      return "the ground there is too steep for the truck to stand, or its height is not known";
    }
    return request_.allow_reverse ? "give another heading, or raise join_within"
                                  : "allow_reverse would let the truck turn round";
  }

  static std::string describe(const char* which, const DriveCurve& curve, const PathPoint& place) {
    const std::size_t cusps = cusps_of(curve);
    return fmt::format("the {} mile has {:.1f} m and {} {}; it meets the path at {}", which,
                       curve.length(), cusps,
                       cusps == 1 ? "change of direction" : "changes of direction",
                       text_of_place(place.x, place.y));
  }

  const OccupancyGrid& grid_;
  const ElevationGrid* elevation_;
  const MileRequest& request_;
  const std::function<void()>& checkpoint_;
  std::vector<PathPoint> points_;
  std::vector<double> along_;
};

}  // namespace

Path add_miles(const Path& path, const OccupancyGrid& grid, const ElevationGrid* elevation,
               const MileRequest& request, const std::function<void(std::string_view)>& say,
               const std::function<void()>& checkpoint) {
  const RouteLine checked(path);
  check_bends(path.points, request.vehicle);
  Miles miles(path, grid, elevation, request, checkpoint);
  if (request.start) {
    if (const auto text = miles.add_first(*request.start); !text.empty()) say(text);
  }
  if (!request.goals.empty()) {
    if (const auto text = miles.add_last(request.goals); !text.empty()) say(text);
  }
  Path driven;
  driven.edges = path.edges;
  driven.length = miles.length();
  driven.points = miles.take();
  plan_speeds(driven.points, request.vehicle, request.limits);
  return driven;
}

}  // namespace stope::planner
