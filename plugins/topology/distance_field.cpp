// Problem: how far a place between cell centres, or a whole line, is from the nearest obstacle
// cell, never a bit too far. What the cells around see is nearly always the answer, but an obstacle
// can be nearest to places that lie between cell centres and to none of these. Idea: what the cells
// around see bounds the answer from above, and lets an unseen obstacle be only where it is: no
// obstacle is nearer to a cell than the one that the cell sees. Of the circle that the bound draws
// around a place, all but a thin rim lies within the circles that have nothing inside of them, so
// few cells are left to look at. Along a line an obstacle that matters lies straight beside it, so
// there is even less. Cost: see the header.
#include "plugins/topology/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stope::topology {
namespace {

constexpr double kNegligible = 1e-6;  // cells
constexpr double kRounding = 1e-9;    // cells

LinePoint between(const LinePoint& a, const LinePoint& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
          a.distance + part * (b.distance - a.distance)};
}

double squared(double a) { return a * a; }

/// The first cell whose centre is not before `place`, and the last whose centre is not beyond it.
std::int32_t first_centre(double place) {
  return static_cast<std::int32_t>(std::ceil(place - 0.5 - kRounding));
}
std::int32_t last_centre(double place) {
  return static_cast<std::int32_t>(std::floor(place - 0.5 + kRounding));
}

/// Notes places a cell away: whoever sees what changed one cell beside them sees it two away.
void note(const LinePoint& place, LookedAt* looked_at) {
  if (!looked_at) return;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) looked_at->places.push_back({place.x + x, place.y + y, 0});
}

}  // namespace

/// Calls visit(x, y, site) with the column and the row of each free cell around and the obstacle
/// cell it sees.
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
      visit(x, y, outlines_.place[static_cast<std::size_t>(edges_[cell])]);
    }
  }
}

double DistanceField::at(const LinePoint& place, std::int32_t reach) const {
  double least = -1;
  for_each_site(place, reach, [&](std::int32_t, std::int32_t, const Outlines::Place& site) {
    const double distance =
        squared(place.x - site.column - 0.5) + squared(place.y - site.row - 0.5);
    if (least < 0 || distance < least) least = distance;
  });
  return least < 0 ? place.distance : std::sqrt(least);
}

CellIndex DistanceField::cell_at(const LinePoint& place) const {
  const auto column = static_cast<std::int32_t>(std::floor(place.x));
  const auto row = static_cast<std::int32_t>(std::floor(place.y));
  return space_.index(std::clamp(column, 0, space_.width() - 1),
                      std::clamp(row, 0, space_.height() - 1));
}

void DistanceField::estimate(std::vector<LinePoint>& line) const {
  // A line leads through memory that nobody has looked at for long, so it is asked for in advance.
  constexpr std::size_t kAhead = 8;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i + 2 * kAhead < line.size()) {
      const CellIndex cell = cell_at(line[i + 2 * kAhead]);
      for (const CellIndex row : {-space_.stride(), 0, space_.stride()}) {
        __builtin_prefetch(&edges_[cell + row]);
        __builtin_prefetch(&space_[cell + row]);
      }
    }
    if (i + kAhead < line.size()) {
      const CellIndex cell = cell_at(line[i + kAhead]);
      if (!(space_[cell] & kObstacle))
        __builtin_prefetch(&outlines_.place[static_cast<std::size_t>(edges_[cell])]);
    }
    line[i].distance = at(line[i], 1);
  }
}

DistanceField::Surroundings DistanceField::look_around(const LinePoint& place) const {
  Surroundings around;
  for_each_site(place, kReach, [&](std::int32_t x, std::int32_t y, const Outlines::Place& site) {
    const double distance = std::sqrt(squared(x - site.column) + squared(y - site.row));
    around.cells[around.count++] = {x + 0.5, y + 0.5, site.column + 0.5, site.row + 0.5, distance};
  });
  return around;
}

bool DistanceField::probe(std::int32_t column, std::int32_t row, LookedAt* looked_at) const {
  if (column < -1 || row < -1 || column > space_.width() || row > space_.height()) return false;
  const CellIndex cell = space_.index(column, row);
  if (looked_at) looked_at->probed.push_back(cell);
  return space_[cell] & kObstacle;
}

double DistanceField::exactly_at(const LinePoint& place, LookedAt* looked_at) const {
  note(place, looked_at);
  const Surroundings around = look_around(place);
  if (around.count == 0) return place.distance;
  double least = std::numeric_limits<double>::max();
  for (const Cell& cell : around)
    least = std::min(least, squared(place.x - cell.site_x) + squared(place.y - cell.site_y));
  for (const double to_x : {-1.0, 1.0})
    for (const double to_y : {-1.0, 1.0})
      search_quarter(place, around, to_x, to_y, least, looked_at);
  return std::sqrt(least);
}

/// Looks for obstacles nearer than the square root of `least` in one quarter of the circle, row by
/// row outside of the empty circle that reaches furthest that way.
void DistanceField::search_quarter(const LinePoint& place, const Surroundings& around, double to_x,
                                   double to_y, double& least, LookedAt* looked_at) const {
  const auto reach = [&](const Cell& cell) {
    return cell.distance +
           (to_x * (cell.x - place.x) + to_y * (cell.y - place.y)) / std::numbers::sqrt2;
  };
  const Cell& empty =
      *std::max_element(around.begin(), around.end(),
                        [&](const Cell& a, const Cell& b) { return reach(a) < reach(b); });
  const auto step = static_cast<std::int32_t>(to_y);
  for (std::int32_t row = to_y > 0 ? first_centre(place.y) : last_centre(place.y);; row += step) {
    const double y = row + 0.5;
    const double outer_squared = least - squared(y - place.y);
    if (outer_squared <= 0) return;
    const double outer = std::sqrt(outer_squared);
    const double half = std::sqrt(std::max(squared(empty.distance) - squared(y - empty.y), 0.0));
    const double ahead = to_x * (empty.x - place.x);
    // Of the row, nothing from the place on is in the way but what lies beyond the empty circle.
    const double inner = ahead < half ? std::max(ahead + half, 0.0) : 0.0;
    if (inner > outer + kRounding) continue;
    const double from = place.x + to_x * inner, to = place.x + to_x * outer;
    const std::int32_t last = last_centre(std::max(from, to));
    for (std::int32_t column = first_centre(std::min(from, to)); column <= last; ++column) {
      const double distance = squared(column + 0.5 - place.x) + squared(y - place.y);
      if (distance < least && probe(column, row, looked_at)) least = distance;
    }
  }
}

void DistanceField::search(const LinePoint& from, const LinePoint& to, std::size_t before,
                           Narrowest& best, LookedAt* looked_at) const {
  const double length = distance_between(from, to);
  if ((from.distance + to.distance - length) / 2 >= best.place.distance - kNegligible) return;
  if (!(length > 0)) return;
  LinePoint middle = between(from, to, 0.5);
  note(middle, looked_at);
  const Surroundings around = look_around(middle);
  if (length <= 1) {
    search_beside(from, to, around, before, best, looked_at);
    return;
  }
  // The middle is at most as far from obstacles as from those that are seen; it is at least as far
  // as they leave empty around it.
  double most = std::numeric_limits<double>::max(), least = 0;
  for (const Cell& cell : around) {
    most = std::min(most, squared(middle.x - cell.site_x) + squared(middle.y - cell.site_y));
    least = std::max(
        least, cell.distance - std::sqrt(squared(middle.x - cell.x) + squared(middle.y - cell.y)));
  }
  middle.distance = std::sqrt(most);
  if (middle.distance < best.place.distance) best = {middle, before};
  middle.distance = least;
  search(from, middle, before, best, looked_at);
  search(middle, to, before, best, looked_at);
}

/// Obstacles whose nearest place of a short straight line lies between its ends.
void DistanceField::search_beside(const LinePoint& from, const LinePoint& to,
                                  const Surroundings& around, std::size_t before, Narrowest& best,
                                  LookedAt* looked_at) const {
  const double length = distance_between(from, to);
  const double along_x = (to.x - from.x) / length, along_y = (to.y - from.y) / length;
  const LinePoint middle = between(from, to, 0.5);
  const auto take = [&](double x, double y) {
    const double along = (x - middle.x) * along_x + (y - middle.y) * along_y;
    LinePoint foot = between(from, to, std::clamp(along / length + 0.5, 0.0, 1.0));
    foot.distance = std::sqrt(squared(x - foot.x) + squared(y - foot.y));
    if (foot.distance < best.place.distance - kNegligible) best = {foot, before};
  };
  for (const Cell& cell : around) take(cell.site_x, cell.site_y);
  for (const double side : {-1.0, 1.0}) {
    const double aside_x = -side * along_y, aside_y = side * along_x;
    // How far aside nothing can be, for each of the cells: it sees that far.
    double empty = 0;
    for (const Cell& cell : around) {
      const double dx = cell.x - middle.x, dy = cell.y - middle.y;
      const double along = std::abs(dx * along_x + dy * along_y) + length / 2;
      const double seen = squared(cell.distance) - squared(along);
      const double ahead = dx * aside_x + dy * aside_y;
      if (seen > 0 && ahead < std::sqrt(seen)) empty = std::max(empty, ahead + std::sqrt(seen));
    }
    const double most = best.place.distance;
    if (empty >= most) continue;
    const double near_x = middle.x + empty * aside_x, far_x = middle.x + most * aside_x;
    const double near_y = middle.y + empty * aside_y, far_y = middle.y + most * aside_y;
    const double half_x = std::abs(along_x) * length / 2, half_y = std::abs(along_y) * length / 2;
    const std::int32_t right = last_centre(std::max(near_x, far_x) + half_x);
    const std::int32_t top = last_centre(std::max(near_y, far_y) + half_y);
    for (std::int32_t row = first_centre(std::min(near_y, far_y) - half_y); row <= top; ++row) {
      for (std::int32_t column = first_centre(std::min(near_x, far_x) - half_x); column <= right;
           ++column) {
        const double dx = column + 0.5 - middle.x, dy = row + 0.5 - middle.y;
        const double aside = dx * aside_x + dy * aside_y;
        const double along = dx * along_x + dy * along_y;
        if (aside < empty - kRounding || aside >= most || std::abs(along) > length / 2 + kRounding)
          continue;
        if (probe(column, row, looked_at)) take(column + 0.5, row + 0.5);
      }
    }
  }
}

void DistanceField::measure(std::vector<LinePoint>& line, LookedAt* looked_at) const {
  for (LinePoint& point : line) point.distance = exactly_at(point, looked_at);
  Narrowest best{line.front(), 0};
  for (const LinePoint& point : line)
    if (point.distance < best.place.distance) best.place = point;
  for (std::size_t i = 1; i < line.size(); ++i) search(line[i - 1], line[i], i, best, looked_at);
  if (best.before > 0)
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(best.before), best.place);
}

}  // namespace stope::topology
