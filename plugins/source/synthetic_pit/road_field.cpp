// The drivable area as a signed distance.
//
// Problem: truth and terrain must agree to the centimetre, at any resolution. Idea: both are read
// off one function of the place, the distance outside the nearest street's strip; meeting streets
// are joined by the circular union of Mercury's hg_sdf, and the surfaces of meeting streets are
// blended. Cost: a map tile first keeps the few segments that can be nearest to any of its cells,
// so a cell costs about a microsecond near roads and nothing far from them.
#include "plugins/source/synthetic_pit/road_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "plugins/source/synthetic_pit/noise.hpp"
#include "stope/random.hpp"

namespace stope::source {
namespace {

constexpr std::size_t kSectionPoints = 24;
constexpr double kCutSlope = 2.6;      // of a wall above a road
constexpr double kRockSlope = 2.2;     // of the bank below a road in the pit
constexpr double kTipSlope = 0.75;     // of the bank below a road on tipped rock
constexpr double kTipLevel = 1.5;      // metres, above it all ground is tipped
constexpr double kMouthFillet = 8;     // metres, between a road and its turning place
constexpr double kFaceWavelength = 5;  // metres, of a freshly dug face

double round_union(double a, double b, double radius) {
  const double u = std::max(radius - a, 0.0), v = std::max(radius - b, 0.0);
  return std::max(radius, std::min(a, b)) - std::hypot(u, v);
}

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double segment_parameter(const Vector2& a, const Vector2& b, const Vector2& p) {
  const Vector2 leg = b - a;
  return std::clamp((p - a).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
}

}  // namespace

RoadField::RoadField(const Layout& layout, double rough, std::uint64_t seed)
    : shape_(layout.shape),
      network_(layout.network),
      rules_(layout.rules),
      rough_(rough),
      seed_(mix_seed(seed, 20)) {
  for (std::size_t i = 0; i < network_.streets.size(); ++i) add_sections(i);
}

double RoadField::bank_reach(const Section& section) const {
  // The ground may rise or fall away from the road at half a bank's slope; twice the bank covers
  // it.
  const Street& street = network_.streets[section.street];
  double difference = 0, level = 0;
  const auto look = [&](const Vector2& place) {
    difference = std::max(difference, std::abs(shape_.ground(place) - level));
  };
  for (std::size_t i = section.first; i <= section.last; i += 2) {
    const std::size_t point = i % street.points.size();
    level = street.elevation[point];
    const Vector2 ahead = street.direction(point), left(-ahead.y(), ahead.x());
    const double edge = street.half_width() + rules_.berm_width;
    look(street.points[point] + edge * left);
    look(street.points[point] - edge * left);
  }
  if (section.dead_end) {
    const double edge = section.dead_end->radius + rules_.berm_width;
    for (int i = 0; i < 12; ++i) {
      const double angle = i * std::numbers::pi / 6;
      look(network_.centre(*section.dead_end) + edge * Vector2(std::cos(angle), std::sin(angle)));
    }
  }
  const double slope = level > kTipLevel ? kTipSlope : 0.5 * kRockSlope;
  return rules_.berm_width + 12 + 1.3 * difference / slope;
}

void RoadField::add_sections(std::size_t number) {
  const Street& street = network_.streets[number];
  const std::size_t last_point = street.closed ? street.points.size() : street.points.size() - 1;
  for (std::size_t first = 0; first < last_point; first += kSectionPoints) {
    Section section;
    section.street = number;
    section.first = first;
    section.last = std::min(first + kSectionPoints, last_point);
    const Vector2& a = street.points[section.first];
    const Vector2& b = street.points[section.last % street.points.size()];
    section.centre = 0.5 * (a + b);
    for (std::size_t i = section.first; i <= section.last; ++i) {
      const Vector2& point = street.points[i % street.points.size()];
      section.radius = std::max(section.radius, (point - section.centre).norm());
    }
    for (const Attachment& tie : network_.attachments) {
      if (tie.branch != number) continue;
      if (tie.at_end && section.last == last_point) section.ends_attached = true;
      if (!tie.at_end && section.first == 0) section.starts_attached = true;
    }
    section.radius += street.half_width();
    for (const DeadEnd& end : network_.dead_ends) {
      if (end.street != number || (end.at_end ? section.last != last_point : first != 0)) continue;
      section.dead_end = &end;
      section.radius = std::max(
          section.radius, (network_.centre(end) - section.centre).norm() + end.radius + rough_);
    }
    section.reach = bank_reach(section);
    sections_.push_back(section);
  }
}

RoadField::Tile RoadField::tile(const Vector2& centre, double radius) const {
  Tile tile;
  for (std::size_t k = 0; k < sections_.size(); ++k) {
    const Section& section = sections_[k];
    if ((section.centre - centre).norm() > section.radius + radius + section.reach) continue;
    const Street& street = network_.streets[section.street];
    const std::size_t n = street.points.size();
    std::array<double, kSectionPoints> distance{};
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = section.first; i < section.last; ++i) {
      const Vector2 &a = street.points[i], &b = street.points[(i + 1) % n];
      const Vector2 foot = a + segment_parameter(a, b, centre) * (b - a);
      distance[i - section.first] = (foot - centre).norm();
      smallest = std::min(smallest, distance[i - section.first]);
    }
    Tile::Candidate candidate{k, {}};
    for (std::size_t i = section.first; i < section.last; ++i) {
      if (distance[i - section.first] <= smallest + 2 * radius)
        candidate.segments.push_back(static_cast<std::uint32_t>(i));
    }
    tile.candidates.push_back(std::move(candidate));
  }
  for (std::size_t k = 0; k < network_.attachments.size(); ++k) {
    if ((network_.attachments[k].place - centre).norm() < 80 + radius)
      tile.attachments.push_back(k);
  }
  return tile;
}

double RoadField::turning_place(const DeadEnd& end, const Vector2& place) const {
  const Vector2 offset = place - network_.centre(end);
  const double distance = offset.norm();
  double outside = distance - end.radius;
  if (end.kind == DeadEndKind::kLoadingFace && rough_ > 0 && distance > 1) {
    // Dug only opposite the entrance; the rest of the place is swept clean.
    const double share = smooth_step(2 * offset.dot(network_.heading(end)) / distance - 0.2);
    outside += rough_ * share *
               fractal_noise(seed_, place.x() / kFaceWavelength, place.y() / kFaceWavelength);
  }
  return outside;
}

RoadField::Near RoadField::nearest(const Section& section,
                                   const std::vector<std::uint32_t>& segments,
                                   const Vector2& place) const {
  const Street& street = network_.streets[section.street];
  const std::size_t n = street.points.size();
  double best = std::numeric_limits<double>::infinity(), best_t = 0;
  std::size_t best_segment = section.first;
  for (const std::uint32_t i : segments) {
    const Vector2 &a = street.points[i], &b = street.points[(i + 1) % n];
    const double t = segment_parameter(a, b, place);
    const double squared = (a + t * (b - a) - place).squaredNorm();
    if (squared < best) best = squared, best_segment = i, best_t = t;
  }
  const std::size_t next = (best_segment + 1) % n;
  const double half = street.half_width();
  Near near{section.street, std::sqrt(best) - half,
            street.elevation[best_segment] +
                best_t * (street.elevation[next] - street.elevation[best_segment])};

  // Past the end that meets another street the strip fades out before it reaches that street's far
  // edge, so that the far edge stays straight.
  const bool before_start = section.starts_attached && best_segment == 0 && best_t == 0;
  const bool past_end =
      section.ends_attached && best_segment + 2 == n && !street.closed && best_t == 1;
  if (before_start || past_end) {
    const Vector2& end = street.points[before_start ? 0 : n - 1];
    const Vector2 outwards = before_start ? Vector2(-street.direction(0)) : street.direction(n - 1);
    const Vector2 offset = place - end;
    const double beyond = offset.dot(outwards);
    const double aside = std::abs(outwards.x() * offset.y() - outwards.y() * offset.x());
    const double slope = (rules_.fillet + half) / half;
    near.outside = std::max(aside - half, -half + slope * beyond);
  }
  if (section.dead_end) {
    near.outside = round_union(near.outside, turning_place(*section.dead_end, place), kMouthFillet);
  }
  return near;
}

RoadSample RoadField::sample(const Tile& tile, const Vector2& place) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  RoadSample sample{kFar, 0, -kFar, kFar};
  if (tile.candidates.empty()) return sample;

  const auto bank = [&](double outside, double level) {
    const double run = std::max(0.0, outside - rules_.berm_width);
    const double down = level > kTipLevel ? kTipSlope : kRockSlope;
    sample.upper = std::min(sample.upper, level + kCutSlope * run);
    sample.lower = std::max(sample.lower, level - down * run);
  };
  // Each street near here by its nearest section, in the order of the network.
  thread_local std::vector<Near> streets;
  streets.clear();
  for (const auto& candidate : tile.candidates) {
    const Section& section = sections_[candidate.section];
    const Near near = nearest(section, candidate.segments, place);
    if (near.outside < section.reach) bank(near.outside, near.level);
    if (streets.empty() || streets.back().street != near.street) {
      streets.push_back(near);
    } else if (near.outside < streets.back().outside) {
      streets.back() = near;
    }
  }
  const auto first =
      std::min_element(streets.begin(), streets.end(),
                       [](const Near& a, const Near& b) { return a.outside < b.outside; });
  sample.outside = first->outside;
  sample.level = first->level;
  for (const std::size_t k : tile.attachments) {
    const Attachment& tie = network_.attachments[k];
    const double fade = smooth_step((80 - (place - tie.place).norm()) / 30);
    if (fade <= 0) continue;
    const auto find = [&](std::size_t street) {
      return std::find_if(streets.begin(), streets.end(),
                          [&](const Near& near) { return near.street == street; });
    };
    const auto branch = find(tie.branch), through = find(tie.through);
    if (branch == streets.end() || through == streets.end()) continue;
    sample.outside = std::min(sample.outside,
                              round_union(branch->outside, through->outside, fade * rules_.fillet));
    if (first != branch && first != through) continue;
    const auto other = first == branch ? through : branch;
    const double share = fade * smooth_step(0.5 + (first->outside - other->outside) / 16);
    sample.level += share * (other->level - first->level);
  }
  bank(sample.outside, sample.level);
  return sample;
}

}  // namespace stope::source
