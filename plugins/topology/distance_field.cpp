#include "plugins/topology/distance_field.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {
namespace {

constexpr double kNegligible = 1e-6;  // cells

LinePoint between(const LinePoint& a, const LinePoint& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
          a.distance + part * (b.distance - a.distance)};
}

/// Notes places a cell away: whoever sees what changed one cell beside them sees it two away.
void note(const LinePoint& place, std::vector<LinePoint>* looked_at) {
  if (!looked_at) return;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) looked_at->push_back({place.x + x, place.y + y, 0});
}

}  // namespace

/// Calls visit(x, y) with the centre of the obstacle cell that each of the cells around sees.
template <class Visit>
void DistanceField::for_each_site(const LinePoint& place, std::int32_t reach, Visit visit) const {
  const auto column = static_cast<std::int32_t>(std::floor(place.x));
  const auto row = static_cast<std::int32_t>(std::floor(place.y));
  const std::int32_t right = std::min(column + reach, space_.width() - 1);
  for (std::int32_t y = std::max(row - reach, 0); y <= std::min(row + reach, space_.height() - 1);
       ++y) {
    for (std::int32_t x = std::max(column - reach, 0); x <= right; ++x) {
      const CellIndex cell = space_.index(x, y);
      if (space_[cell] & kObstacle) continue;
      const auto site = outlines_.place[static_cast<std::size_t>(edges_[cell])];
      visit(site.column + 0.5, site.row + 0.5);
    }
  }
}

double DistanceField::at(const LinePoint& place, std::int32_t reach) const {
  double least = -1;
  for_each_site(place, reach, [&](double x, double y) {
    const double squared = (place.x - x) * (place.x - x) + (place.y - y) * (place.y - y);
    if (least < 0 || squared < least) least = squared;
  });
  return least < 0 ? place.distance : std::sqrt(least);
}

void DistanceField::search(const LinePoint& from, const LinePoint& to, std::size_t before,
                           Narrowest& best, std::vector<LinePoint>* looked_at) const {
  const double length = distance_between(from, to);
  if ((from.distance + to.distance - length) / 2 >= best.place.distance - kNegligible) return;
  LinePoint middle = between(from, to, 0.5);
  note(middle, looked_at);
  if (length > 1) {
    middle.distance = at(middle, kReach);
    if (middle.distance < best.place.distance) best = {middle, before};
    search(from, middle, before, best, looked_at);
    search(middle, to, before, best, looked_at);
    return;
  }
  const double dx = to.x - from.x, dy = to.y - from.y;
  if (!(length > 0)) return;
  for_each_site(middle, kReach, [&](double x, double y) {
    const double part = ((x - from.x) * dx + (y - from.y) * dy) / (length * length);
    LinePoint foot = between(from, to, std::clamp(part, 0.0, 1.0));
    foot.distance = distance_between(foot, {x, y, 0});
    if (foot.distance < best.place.distance - kNegligible) best = {foot, before};
  });
}

void DistanceField::measure(std::vector<LinePoint>& line, std::vector<LinePoint>* looked_at) const {
  for (LinePoint& point : line) {
    point.distance = at(point, kReach);
    note(point, looked_at);
  }
  Narrowest best{line.front(), 0};
  for (const LinePoint& point : line)
    if (point.distance < best.place.distance) best.place = point;
  for (std::size_t i = 1; i < line.size(); ++i) search(line[i - 1], line[i], i, best, looked_at);
  if (best.before > 0)
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(best.before), best.place);
}

}  // namespace stope::topology
