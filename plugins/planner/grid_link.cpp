// Problem: a truck stands off the road's centre line, perhaps behind a stockpile; which place of
// which road does it drive to?
// Idea: most trucks see the nearest road, so lines of sight are tried first, road by road. If none
// is free, Dijkstra's search grows over the free cells of a window until it meets a cell that a
// road runs through; diagonal steps do not cut corners.
// Cost: a line per road, then O(n log n) in the window's cells, of which there are at most 2049².
#include "plugins/planner/grid_link.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>

#include "plugins/planner/cell_box.hpp"

namespace stope::planner {
namespace {

constexpr std::int32_t kWindowRadius = 1024;  // cells

/// The cells of a grid around one of them.
CellBox window_around(const GridFrame& frame, Cell centre, std::int32_t radius) {
  CellBox box{std::max(0, centre.column - radius), std::max(0, centre.row - radius), 0, 0};
  box.width = std::min(frame.width, centre.column + radius + 1) - box.left;
  box.height = std::min(frame.height, centre.row + radius + 1) - box.bottom;
  return box;
}

using RoadCells = std::vector<std::optional<RoadPlace>>;

/// Marks the window's cells that roads run through with the place; the first road wins.
RoadCells mark_roads(const CellBox& window, const GridFrame& frame, const RoadNetwork& network,
                     const std::vector<SnappedPlace>& candidates, double most) {
  RoadCells marks(window.size());
  for (const SnappedPlace& candidate : candidates) {
    if (candidate.distance > most) break;
    const std::uint32_t edge = candidate.place.edge;
    const double length = network.length(edge);
    const double steps = std::ceil(length / (0.5 * frame.resolution));
    for (double i = 0; i <= steps; ++i) {
      const RoadPlace place{edge, steps > 0 ? length * i / steps : 0};
      const RoadVertex vertex = network.at(place);
      const auto cell = frame.cell_at(vertex.x, vertex.y);
      if (!cell || !window.contains(*cell)) continue;
      auto& mark = marks[window.place(*cell)];
      if (!mark) mark = place;
    }
  }
  return marks;
}

std::vector<Vector2> pull_straight(const DrivableGrid& grid, const std::vector<Vector2>& points) {
  std::vector<Vector2> kept{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    std::size_t next = i + 1;
    while (next + 1 < points.size() && grid.line_free(points[i], points[next + 1])) ++next;
    kept.push_back(points[next]);
    i = next;
  }
  return kept;
}

std::optional<Link> search_cells(const DrivableGrid& grid, const RoadNetwork& network,
                                 const Vector2& point, Cell start,
                                 const std::vector<SnappedPlace>& candidates, double most) {
  const GridFrame& frame = grid.frame();
  const auto radius = static_cast<std::int32_t>(
      std::min<double>(kWindowRadius, std::ceil(most / frame.resolution)));
  const CellBox window = window_around(frame, start, radius);
  const auto free = [&](Cell cell) { return window.contains(cell) && grid.free(cell); };
  const RoadCells marks = mark_roads(window, frame, network, candidates, most);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::vector<float> costs(window.size(), kInfinity);
  std::vector<std::uint32_t> previous(window.size());
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  const std::uint32_t first = window.place(start);
  costs[first] = 0;
  heap.push({0.0F, first});
  while (!heap.empty()) {
    const auto [cost, place] = heap.top();
    heap.pop();
    if (cost > costs[place]) continue;
    if (static_cast<double>(cost) * frame.resolution > most) break;
    if (marks[place]) {
      const RoadVertex end = network.at(*marks[place]);
      std::vector<Vector2> points{Vector2(end.x, end.y)};
      for (std::uint32_t at = place; at != first; at = previous[at])
        points.push_back(frame.centre(window.cell(at)));
      points.push_back(point);
      std::reverse(points.begin(), points.end());
      return Link{*marks[place], pull_straight(grid, points)};
    }
    const Cell cell = window.cell(place);
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.column + dx, cell.row + dy};
        if (!free(next)) continue;
        const bool diagonal = dx != 0 && dy != 0;
        if (diagonal &&
            (!free({cell.column + dx, cell.row}) || !free({cell.column, cell.row + dy})))
          continue;
        const float longer = cost + (diagonal ? std::numbers::sqrt2_v<float> : 1.0F);
        const std::uint32_t there = window.place(next);
        if (longer >= costs[there]) continue;
        costs[there] = longer;
        previous[there] = place;
        heap.push({longer, there});
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Link> link_to_road(const DrivableGrid& grid, const RoadNetwork& network,
                                 const Vector2& point, const std::vector<SnappedPlace>& candidates,
                                 double most) {
  for (const SnappedPlace& candidate : candidates) {
    if (candidate.distance > most) break;
    if (grid.line_free(point, candidate.position))
      return Link{candidate.place, {point, candidate.position}};
  }
  const auto cell = grid.frame().cell_at(point.x(), point.y());
  if (!cell || !grid.free(*cell)) return std::nullopt;
  return search_cells(grid, network, point, *cell, candidates, most);
}

}  // namespace stope::planner
