#include "plugins/source/synthetic_pit/side_roads.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/source/synthetic_pit/curve.hpp"

namespace stope::source {
namespace {

Attachment tie(const Layout& layout, const SideRoadPlan& plan) {
  Attachment attachment;
  attachment.through = plan.through;
  attachment.through_point = plan.point;
  attachment.place = layout.network.streets[plan.through].points[plan.point];
  return attachment;
}

Vector2 leaving(const Layout& layout, const SideRoadPlan& plan) {
  const Vector2 ahead = layout.network.streets[plan.through].direction(plan.point);
  return plan.side * Vector2(-ahead.y(), ahead.x());
}

double elevation_at(const Layout& layout, const SideRoadPlan& plan) {
  return layout.network.streets[plan.through].elevation[plan.point];
}

}  // namespace

Proposal side_road(const Layout& layout, const SideRoadPlan& plan, const DeadEnd& dead_end,
                   Random& random) {
  Proposal proposal;
  proposal.start = tie(layout, plan);
  const Vector2 first = proposal.start->place, away = leaving(layout, plan);
  const int legs = std::max(2, static_cast<int>(std::lround(plan.length / layout.rules.leg())));
  const double leg = plan.length / legs;
  std::vector<Vector2> controls{first, first + leg * away};
  double heading = std::atan2(away.y(), away.x());
  for (int i = 1; i < legs; ++i) {
    // The last leg goes straight on into the turning place.
    if (i + 1 < legs) heading += plan.lean / (legs - 2) + plan.wobble * random.uniform(-1, 1);
    controls.push_back(controls.back() + leg * Vector2(std::cos(heading), std::sin(heading)));
  }
  const double width = layout.network.streets[plan.through].width;
  proposal.street = make_street(smooth_curve(controls, false, kStreetStep), width, false);
  proposal.street.points.front() = first;
  auto& elevation = proposal.street.elevation;
  std::fill(elevation.begin(), elevation.end(), elevation_at(layout, plan));
  proposal.dead_end = dead_end;
  return proposal;
}

Proposal connecting_road(const Layout& layout, const SideRoadPlan& from, const SideRoadPlan& to,
                         Random& random) {
  Proposal proposal;
  proposal.start = tie(layout, from);
  proposal.end = tie(layout, to);
  const Vector2 first = proposal.start->place, last = proposal.end->place;
  const Vector2 second = first + layout.rules.leg() * leaving(layout, from);
  const Vector2 second_last = last + layout.rules.leg() * leaving(layout, to);
  const double distance = (second_last - second).norm();
  const int legs = std::max(2, static_cast<int>(std::lround(distance / 30)));
  const Vector2 across =
      Vector2(second.y() - second_last.y(), second_last.x() - second.x()).normalized();
  // One bow over the whole length: from ring roads it swings outwards, clear of the ring itself.
  const double bow = from.lean + from.wobble * random.uniform(-1, 1);
  std::vector<Vector2> controls{first, second};
  for (int i = 1; i < legs; ++i) {
    const double t = static_cast<double>(i) / legs;
    controls.push_back(second + t * (second_last - second) +
                       4 * t * (1 - t) * bow * 0.5 * distance * across);
  }
  controls.push_back(second_last);
  controls.push_back(last);
  const double width = layout.network.streets[from.through].width;
  proposal.street = make_street(smooth_curve(controls, false, kStreetStep), width, false);
  Street& street = proposal.street;
  street.points.front() = first;
  street.points.back() = last;
  const double level = 26, slope_length = std::max(1.0, street.length() - 2 * level);
  const double low = elevation_at(layout, from), high = elevation_at(layout, to);
  for (std::size_t i = 0; i < street.points.size(); ++i) {
    const double t = std::clamp((street.station[i] - level) / slope_length, 0.0, 1.0);
    street.elevation[i] = low + t * (high - low);
  }
  street.elevation = moving_average(street.elevation, 6);
  return proposal;
}

}  // namespace stope::source
