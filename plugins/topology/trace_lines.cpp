// Problem: make lines of the steps between divided cells, the same ones in the same order whatever
// was traced before.
// Idea: a line starts at its lower end, in the first of the four directions that leads along it;
// so where it starts, which way its points run and its place among all lines are matters of
// geometry, and lines traced anew in a part of the map fit between those that stayed.
// Cost: linear in the lines' length.
#include "plugins/topology/trace_lines.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {

LineTracer::Steps LineTracer::steps(CellIndex corner, bool untraced_only) const {
  const std::array<Divide, 4> all{
      {{corner + stride_, false}, {corner + 1, true}, {corner, false}, {corner, true}}};
  Steps result;
  for (std::size_t way = 0; way < all.size(); ++way) {
    const Divide step = all[way];
    if (!(space_[step.cell] & (step.north ? kDividedNorth : kDividedEast))) continue;
    if (untraced_only && traced(step)) continue;
    result.way[result.count] = static_cast<std::int32_t>(way);
    result.list[result.count++] = step;
  }
  return result;
}

bool LineTracer::traced(Divide step) const {
  return space_[step.cell] & (step.north ? kTracedNorth : kTracedEast);
}

bool LineTracer::ends_at(CellIndex corner) const {
  return (space_[corner] & kEndsHere) || steps(corner, false).count != 2;
}

CellIndex LineTracer::other_end(Divide step, CellIndex corner) const {
  const CellIndex lower = step.north ? step.cell - 1 : step.cell - stride_;
  return corner == lower ? step.cell : lower;
}

LinePoint LineTracer::centre(CellIndex cell, double distance) const {
  return {edges_.column(cell) + 0.5, edges_.row(cell) + 0.5, distance};
}

/// How much further the first edge is than the second, squared; linear along a line.
double LineTracer::excess(CellIndex cell, OutlineEdge first, OutlineEdge second) const {
  return static_cast<double>(squared_distance(edges_, outlines_, cell, first) -
                             squared_distance(edges_, outlines_, cell, second));
}

/// The place between the centres of the two cells that is equally far from their obstacles.
LinePoint LineTracer::point(Divide step) const {
  const CellIndex a = step.cell, b = a + (step.north ? stride_ : 1);
  // Beside an obstacle the free cell is the whole road.
  if (space_[a] & kObstacle) return centre(b, 1.0);
  if (space_[b] & kObstacle) return centre(a, 1.0);
  const double excess_at_a = excess(a, edges_[a], edges_[b]);
  const double excess_at_b = excess(b, edges_[a], edges_[b]);
  double part = 0.5;
  if (excess_at_b > excess_at_a)
    part = std::clamp(-excess_at_a / (excess_at_b - excess_at_a), 0.0, 1.0);
  LinePoint result = centre(a, 0);
  (step.north ? result.y : result.x) += part;
  const Outlines::Place place = outlines_.place[static_cast<std::size_t>(edges_[a])];
  result.distance = distance_between(result, {place.column + 0.5, place.row + 0.5, 0});
  return result;
}

LinePoint LineTracer::node(CellIndex corner) const {
  const Steps around = steps(corner, false);
  LinePoint mean;
  for (std::size_t i = 0; i < around.count; ++i) {
    const LinePoint next = point(around.list[i]);
    mean.x += next.x / static_cast<double>(around.count);
    mean.y += next.y / static_cast<double>(around.count);
    mean.distance += next.distance / static_cast<double>(around.count);
  }
  return mean;
}

/// Of a free cell the edge it sees, of an obstacle the edge on one of its sides.
OutlineEdge LineTracer::edge_towards(CellIndex cell, int side) const {
  if (!(space_[cell] & kObstacle)) return edges_[cell];
  return outlines_.sides[static_cast<std::size_t>(edges_[cell])][static_cast<std::size_t>(side)];
}

/// What the two cells beside a step see.
std::array<OutlineEdge, 2> LineTracer::seen_from(Divide step) const {
  return {edge_towards(step.cell, step.north ? kNorth : kEast),
          edge_towards(step.cell + (step.north ? stride_ : 1), step.north ? kSouth : kWest)};
}

bool LineTracer::narrow(Divide step) const {
  const auto [a, b] = seen_from(step);
  const Outlines::Place first = outlines_.place[static_cast<std::size_t>(a)];
  const Outlines::Place second = outlines_.place[static_cast<std::size_t>(b)];
  const double dx = first.column - second.column, dy = first.row - second.row;
  return dx * dx + dy * dy < least_apart_ * least_apart_;
}

void LineTracer::trace_from(CellIndex start, std::vector<TracedLine>& lines) {
  const Steps starts = steps(start, true);
  for (std::size_t i = 0; i < starts.count; ++i) {
    Divide step = starts.list[i];
    if (traced(step)) continue;  // a ring came back
    TracedLine line;
    line.way = starts.way[i];
    line.sides = seen_from(step);
    std::vector<LinePoint> points{node(start)};
    line.corners.push_back(start);
    CellIndex corner = start;
    while (true) {
      space_[step.cell] |= step.north ? kTracedNorth : kTracedEast;
      if (least_apart_ > 0 && narrow(step)) {
        const auto steps_before = static_cast<std::int32_t>(points.size()) - 1;
        if (line.narrow.empty() || line.narrow.back().end < steps_before)
          line.narrow.push_back({steps_before, steps_before});
        ++line.narrow.back().end;
      }
      points.push_back(point(step));
      corner = other_end(step, corner);
      line.corners.push_back(corner);
      if (corner == start || ends_at(corner)) break;
      step = steps(corner, true).list[0];
    }
    points.push_back(node(corner));
    if (corner < start) turn_round(line, points, step);
    line.course = courses_.add(std::move(points));
    lines.push_back(std::move(line));
  }
}

/// Lets a line start at its other end, with what was its last step.
void LineTracer::turn_round(TracedLine& line, std::vector<LinePoint>& points, Divide last) const {
  std::reverse(points.begin(), points.end());
  std::reverse(line.corners.begin(), line.corners.end());
  std::reverse(line.narrow.begin(), line.narrow.end());
  const auto count = static_cast<std::int32_t>(line.corners.size()) - 1;
  for (StepRange& stretch : line.narrow) stretch = {count - stretch.end, count - stretch.begin};
  const Steps around = steps(line.from(), false);
  for (std::size_t i = 0; i < around.count; ++i)
    if (around.list[i].cell == last.cell && around.list[i].north == last.north)
      line.way = around.way[i];
}

/// The lower end of the line that passes a corner which is no node; of a ring its lowest corner.
CellIndex LineTracer::ring_start(CellIndex corner) const {
  std::array<CellIndex, 2> ends{corner, corner};
  CellIndex lowest = corner;
  const Steps starts = steps(corner, false);
  for (std::size_t i = 0; i < 2; ++i) {
    Divide step = starts.list[i];
    while (true) {
      ends[i] = other_end(step, ends[i]);
      lowest = std::min(lowest, ends[i]);
      if (ends[i] == corner) return lowest;
      if (ends_at(ends[i])) break;
      const Steps on = steps(ends[i], false);
      const bool first = on.list[0].cell == step.cell && on.list[0].north == step.north;
      step = on.list[first ? 1 : 0];
    }
  }
  return std::min(ends[0], ends[1]);
}

void LineTracer::trace(const std::vector<CellIndex>& corners, std::vector<TracedLine>& lines) {
  std::vector<CellIndex> starts;
  for (const CellIndex corner : corners)
    if (ends_at(corner) && steps(corner, true).count > 0) starts.push_back(corner);
  std::sort(starts.begin(), starts.end());
  for (const CellIndex start : starts) trace_from(start, lines);
  for (const CellIndex corner : corners)
    if (steps(corner, true).count > 0) trace_from(ring_start(corner), lines);
}

TracedLine LineTracer::link(const Link& link, std::int32_t rank) {
  constexpr std::int32_t kWaysOfSteps = 4;
  TracedLine line;
  line.corners = {link.from, link.to};
  line.way = kWaysOfSteps + rank;
  line.sides = {-1, -1};
  line.narrow = {{0, static_cast<std::int32_t>(link.cells.size())}};
  std::vector<LinePoint> points{node(link.from)};
  for (const CellIndex cell : link.cells) {
    const std::int64_t squared = squared_distance(edges_, outlines_, cell, edges_[cell]);
    points.push_back(centre(cell, std::sqrt(static_cast<double>(squared))));
  }
  points.push_back(node(link.to));
  line.course = courses_.add(std::move(points));
  return line;
}

void LineTracer::forget(const TracedLine& line) {
  for (std::size_t i = 1; i < line.corners.size(); ++i) {
    const CellIndex high = std::max(line.corners[i - 1], line.corners[i]);
    const CellIndex low = std::min(line.corners[i - 1], line.corners[i]);
    const int bit = high - low == 1 ? kTracedNorth : kTracedEast;
    space_[high] &= static_cast<std::uint8_t>(~bit);
  }
}

std::vector<TracedLine> trace_lines(LineTracer& tracer, const std::vector<CellIndex>& corners) {
  std::vector<TracedLine> lines;
  tracer.trace(corners, lines);
  std::sort(lines.begin(), lines.end(), comes_first);
  return lines;
}

LineEnds::LineEnds(const std::vector<const TracedLine*>& lines) {
  for (const TracedLine* line : lines) {
    corner.push_back(line->from());
    corner.push_back(line->to());
  }
  std::sort(corner.begin(), corner.end());
  corner.erase(std::unique(corner.begin(), corner.end()), corner.end());
  const auto place_of = [&](CellIndex end) {
    return static_cast<std::int32_t>(std::lower_bound(corner.begin(), corner.end(), end) -
                                     corner.begin());
  };
  for (const TracedLine* line : lines)
    of_line.emplace_back(place_of(line->from()), place_of(line->to()));
}

LineNetwork to_network(const std::vector<const TracedLine*>& lines, Courses& courses) {
  return to_network(lines, LineEnds(lines), courses);
}

LineNetwork to_network(const std::vector<const TracedLine*>& lines, const LineEnds& ends,
                       Courses& courses) {
  LineNetwork network(courses);
  network.nodes.resize(ends.corner.size());
  network.lines.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::int32_t from = ends.of_line[i].first, to = ends.of_line[i].second;
    const CourseId course = lines[i]->course;
    network.nodes[static_cast<std::size_t>(from)].point = courses.front(course);
    network.nodes[static_cast<std::size_t>(to)].point = courses.back(course);
    network.lines.push_back({from, to, course, courses.length(course)});
  }
  return network;
}

std::vector<const TracedLine*> list_of(const std::vector<TracedLine>& lines) {
  std::vector<const TracedLine*> list;
  for (const TracedLine& line : lines) list.push_back(&line);
  return list;
}

}  // namespace stope::topology
