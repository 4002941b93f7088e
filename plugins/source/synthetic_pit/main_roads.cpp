#include "plugins/source/synthetic_pit/main_roads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plugins/source/synthetic_pit/curve.hpp"
#include "stope/error.hpp"

namespace stope::source {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vector2> around(const PitShape& shape, double outward) {
  const double circumference = 2 * kPi * (shape.rim(0) + outward);
  const int count = std::max(8, static_cast<int>(std::lround(circumference / 45)));
  std::vector<Vector2> controls;
  for (int i = 0; i < count; ++i) controls.push_back(shape.at(2 * kPi * i / count, outward));
  return smooth_curve(controls, true, kStreetStep);
}

double ring_offset(const PitParameters& parameters) { return 30 + parameters.road_width; }

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Level landings of a length, and a constant grade between them.
struct Profile {
  double first = 34, landing = 46, last = 34;  ///< metres of level road
  std::int64_t steps = 1;
  double depth = 0;    ///< metres, of all steps
  double incline = 0;  ///< metres along the road, of one step

  double length() const {
    return first + last + static_cast<double>(steps) * incline +
           static_cast<double>(steps - 1) * landing;
  }
  double depth_at(double station) const {
    const double rest = station - first;
    if (rest <= 0) return 0;
    const double period = incline + landing;
    const auto step = std::min(steps - 1, static_cast<std::int64_t>(rest / period));
    const double part = (rest - static_cast<double>(step) * period) / incline;
    return depth / static_cast<double>(steps) * (static_cast<double>(step) + std::min(1.0, part));
  }
  double landing_middle(std::int64_t step) const {
    return first + static_cast<double>(step) * (incline + landing) - 0.5 * landing;
  }
};

/// Leads on over the floor, in a bow that grows with the way there is to go, to meet the loop at a
/// right angle.
void land_on(const Layout& layout, const Street& loop, double angle, double turn,
             std::vector<Vector2>& controls) {
  const double leg = layout.rules.leg();
  const Vector2 centre = layout.shape.centre(), start = controls.back();
  const double away = (start - centre).norm();
  const double to_go = away - (loop.points[point_towards(layout, loop, angle)] - centre).norm();
  angle += turn * std::max(1.3 * leg, 0.8 * to_go) / away;
  const Vector2 last = loop.points[point_towards(layout, loop, angle)];
  const Vector2 outwards = (last - centre).normalized();
  const Vector2 before_last = last + leg * outwards;
  const Vector2 ahead = (start - controls[controls.size() - 2]).normalized();
  const double distance = (before_last - start).norm();
  const int legs = static_cast<int>(std::lround(distance / leg));
  for (int i = 1; i < legs; ++i) {
    // A Hermite curve from one direction to the other.
    const double t = static_cast<double>(i) / legs, u = 1 - t;
    controls.push_back(u * u * (1 + 2 * t) * start + t * t * (3 - 2 * t) * before_last +
                       distance * (u * u * t * ahead + t * t * u * outwards));
  }
  controls.push_back(before_last);
  controls.push_back(last);
}

/// Walks down the pit's wall in short legs, each as far inside the rim as the depth there asks for.
std::vector<Vector2> spiral(const Layout& layout, const Street& ring, std::size_t start,
                            const Street& loop, const Profile& profile, const RampPlan& plan,
                            double ring_distance) {
  const double leg = layout.rules.leg();
  const PitShape& shape = layout.shape;
  const Vector2 first = ring.points[start];
  Vector2 direction = first - shape.centre();
  double angle = std::atan2(direction.y(), direction.x());
  double turn = plan.turn;
  std::vector<Vector2> controls{first, first - leg * direction.normalized()};
  double station = leg, shift = 0;
  angle += turn * 0.6 * leg / shape.rim(angle);
  while (station < profile.length() - 50) {
    const double depth = profile.depth_at(station + leg);
    if (plan.switchback && turn == plan.turn && depth > 0.5 * profile.depth) {
      turn = -turn;
      shift = 2.3 * std::max(layout.rules.smallest_radius, 20.0);
      angle -= turn * 0.5 * leg / shape.rim(angle);
    }
    const double blend = smooth_step((station - 10) / 70);
    const double outward = (1 - blend) * (ring_distance - leg - 0.5 * ring.width) -
                           blend * (shape.inward(depth) + shift);
    angle += turn * leg / (shape.rim(angle) + outward);
    controls.push_back(shape.at(angle, outward));
    station += (controls.back() - controls[controls.size() - 2]).norm();
  }
  land_on(layout, loop, angle, turn, controls);
  return controls;
}

}  // namespace

std::size_t point_towards(const Layout& layout, const Street& street, double angle) {
  const Vector2 direction(std::cos(angle), std::sin(angle));
  std::size_t best = 0;
  double best_cosine = -2;
  for (std::size_t i = 0; i < street.points.size(); ++i) {
    const double cosine = (street.points[i] - layout.shape.centre()).normalized().dot(direction);
    if (cosine > best_cosine) best_cosine = cosine, best = i;
  }
  return best;
}

Street ring_road(const PitShape& shape, const PitParameters& parameters) {
  Street street = make_street(around(shape, ring_offset(parameters)), parameters.road_width, true);
  for (std::size_t i = 0; i < street.points.size(); ++i)
    street.elevation[i] = shape.surface(street.points[i]);
  return street;
}

Street floor_loop(const PitShape& shape, const PitParameters& parameters) {
  const double wall = shape.inward(shape.depth());
  double narrowest = shape.rim(0);
  for (int i = 1; i < 72; ++i) narrowest = std::min(narrowest, shape.rim(2 * kPi * i / 72));
  const double floor = narrowest - wall;
  const double least = 1.2 * parameters.road_width + 10;
  const double radius = std::max(least, std::min(0.62 * floor, floor - 40));
  if (floor < least + 0.5 * parameters.road_width + 8)
    throw Error(fmt::format(
        "{} benches of {:.0f} m leave {:.0f} m from the middle of the pit's floor to its wall, but "
        "a loop of {:.0f} m wide roads needs {:.0f} m: use a larger size, fewer or lower benches "
        "or a narrower road",
        parameters.benches, parameters.bench_height, std::max(0.0, floor), parameters.road_width,
        least + 0.5 * parameters.road_width + 8));
  Street street = make_street(around(shape, radius - narrowest), parameters.road_width, true);
  std::fill(street.elevation.begin(), street.elevation.end(), -shape.depth());
  return street;
}

std::optional<Ramp> ramp_road(const Layout& layout, const PitParameters& parameters,
                              std::size_t ring_number, std::size_t loop_number,
                              const RampPlan& plan) {
  const Street& ring = layout.network.streets[ring_number];
  const Street& loop = layout.network.streets[loop_number];
  const std::size_t start = point_towards(layout, ring, plan.angle);
  const double top = ring.elevation[start];
  Profile profile;
  profile.steps = std::max<std::int64_t>(1, parameters.benches);
  profile.depth = layout.shape.depth() + top;
  profile.incline = profile.depth / static_cast<double>(profile.steps) / plan.grade;
  const std::vector<Vector2> controls =
      spiral(layout, ring, start, loop, profile, plan, ring_offset(parameters));
  Street street =
      make_street(smooth_curve(controls, false, kStreetStep), parameters.road_width, false);

  // The curve came out a little longer or shorter than planned: the inclines take it up.
  const double excess = street.length() - profile.length();
  profile.incline += excess / static_cast<double>(profile.steps);
  if (profile.incline <= 0) return std::nullopt;
  for (std::size_t i = 0; i < street.points.size(); ++i)
    street.elevation[i] = top - profile.depth_at(street.station[i]);
  street.elevation = moving_average(street.elevation, 6);

  Ramp ramp;
  for (std::int64_t step = 1; step < profile.steps; ++step)
    ramp.landings.push_back(profile.landing_middle(step));
  Attachment upper, lower;
  upper.through = ring_number;
  upper.through_point = start;
  upper.place = street.points.front();
  lower.through = loop_number;
  lower.place = street.points.back();
  const Vector2 down = lower.place - layout.shape.centre();
  lower.through_point = point_towards(layout, loop, std::atan2(down.y(), down.x()));
  street.points.front() = ring.points[start];
  street.points.back() = loop.points[lower.through_point];
  ramp.proposal = {std::move(street), upper, lower, std::nullopt};
  return ramp;
}

}  // namespace stope::source
