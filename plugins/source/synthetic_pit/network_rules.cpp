#include "plugins/source/synthetic_pit/network_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plugins/source/synthetic_pit/curve.hpp"

namespace stope::source {
namespace {

/// A place on a road with the room it takes.
struct Spot {
  Vector2 place;
  double elevation = 0;
  double reach = 0;    ///< half the width, or a turning place's radius
  double station = 0;  ///< along its street
  std::size_t street = 0;
};

std::vector<Spot> spots_of(const Street& street, std::size_t number) {
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < street.points.size(); ++i) {
    if (i % 3 != 0 && i + 1 != street.points.size()) continue;
    spots.push_back(
        {street.points[i], street.elevation[i], street.half_width(), street.station[i], number});
  }
  return spots;
}

bool on_map(const std::vector<Spot>& spots, const NetworkRules& rules) {
  return std::all_of(spots.begin(), spots.end(), [&](const Spot& spot) {
    const double far = std::max(std::abs(spot.place.x()), std::abs(spot.place.y()));
    return far + spot.reach + rules.margin <= rules.half_size;
  });
}

bool gentle(const Street& street, const NetworkRules& rules) {
  if (smallest_radius(street.points, street.closed) < rules.smallest_radius) return false;
  for (std::size_t i = 1; i < street.points.size(); ++i) {
    const double rise = std::abs(street.elevation[i] - street.elevation[i - 1]);
    if (rise > 1.05 * rules.grade * (street.station[i] - street.station[i - 1])) return false;
  }
  return true;
}

bool apart(const Spot& a, const Spot& b, const NetworkRules& rules) {
  // Above the surface everything is tipped rock, which does not stand as steep as a blasted wall.
  const bool tipped = std::max(a.elevation, b.elevation) > 2.5;
  const double slope = tipped ? rules.repose_slope : rules.wall_slope;
  const double bank = std::abs(a.elevation - b.elevation) / slope;
  return (a.place - b.place).norm() >= a.reach + b.reach + 2 * rules.berm_width + bank + 1.0;
}

double along(const Street& street, double from, double to) {
  const double direct = std::abs(from - to);
  return street.closed ? std::min(direct, street.length() - direct) : direct;
}

bool spaced(const StreetNetwork& network, const Attachment& tie, const NetworkRules& rules) {
  const Street& through = network.streets[tie.through];
  const double station = through.station[tie.through_point];
  for (const Attachment& other : network.attachments) {
    if (other.through == tie.through &&
        along(through, station, through.station[other.through_point]) < rules.junction_spacing)
      return false;
  }
  if (through.closed) return true;
  double ahead = rules.junction_spacing, behind = rules.junction_spacing;
  for (const DeadEnd& end : network.dead_ends) {
    if (end.street == tie.through) (end.at_end ? ahead : behind) += end.radius;
  }
  return station > behind && through.length() - station > ahead;
}

bool meet_near(const std::optional<Attachment>& tie, const Spot& mine, const Spot& other,
               double excused) {
  return tie && (mine.place - tie->place).norm() < excused && other.street == tie->through &&
         (other.place - tie->place).norm() < 2 * excused;
}

}  // namespace

bool buildable(const StreetNetwork& network, const Proposal& proposal, const NetworkRules& rules) {
  const Street& street = proposal.street;
  std::vector<Spot> mine = spots_of(street, network.streets.size());
  if (proposal.dead_end) {
    Spot& place = mine.back();
    place.reach = proposal.dead_end->radius + 2;
  }
  if (!on_map(mine, rules) || !gentle(street, rules)) return false;
  if (proposal.start && !spaced(network, *proposal.start, rules)) return false;
  if (proposal.end && !spaced(network, *proposal.end, rules)) return false;

  std::vector<Spot> others;
  for (std::size_t i = 0; i < network.streets.size(); ++i) {
    const std::vector<Spot> spots = spots_of(network.streets[i], i);
    others.insert(others.end(), spots.begin(), spots.end());
  }
  for (const DeadEnd& end : network.dead_ends)
    others.push_back({network.centre(end), network.elevation(end), end.radius + 2,
                      end.at_end ? network.streets[end.street].length() : 0.0, end.street});

  const double excused = street.width + rules.fillet + 2 * rules.berm_width + 6;
  for (const Spot& a : mine) {
    for (const Spot& b : others) {
      if (!apart(a, b, rules) && !meet_near(proposal.start, a, b, excused) &&
          !meet_near(proposal.end, a, b, excused))
        return false;
    }
    const double far = 2.2 * (a.reach + street.half_width()) + 2 * rules.berm_width + 12;
    for (const Spot& b : mine) {
      if (along(street, a.station, b.station) > far && !apart(a, b, rules)) return false;
    }
  }
  return true;
}

void build(StreetNetwork& network, Proposal proposal) {
  const std::size_t number = network.streets.size();
  network.streets.push_back(std::move(proposal.street));
  for (auto* tie : {&proposal.start, &proposal.end}) {
    if (!*tie) continue;
    (*tie)->branch = number;
    (*tie)->at_end = tie == &proposal.end;
    network.attachments.push_back(**tie);
  }
  if (proposal.dead_end) {
    proposal.dead_end->street = number;
    network.dead_ends.push_back(*proposal.dead_end);
  }
}

}  // namespace stope::source
