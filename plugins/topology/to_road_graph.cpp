#include "plugins/topology/to_road_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "plugins/topology/assemble_roads.hpp"
#include "plugins/topology/distance_field.hpp"
#include "plugins/topology/simplify_line.hpp"

namespace stope::topology {
namespace {

constexpr double kNoElevation = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmoothingReach = 3.0;  // cells
// How far the clearance drawn straight between two vertices may be off, or the line's tolerance.
constexpr double kClearanceShare = 0.1;

/// The clearance that half of the line's length has at most, in cells: junctions, where more room
/// is, and pinches do not sway it.
double median_clearance(const std::vector<LinePoint>& points) {
  std::vector<std::pair<double, double>> parts;  // distance, length
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = distance_between(points[i - 1], points[i]);
    parts.emplace_back((points[i - 1].distance + points[i].distance) / 2, step);
    length += step;
  }
  // Halves that part are halved again: a sort would cost more than all the rest of the line.
  double below = 0;
  auto begin = parts.begin(), end = parts.end();
  while (end - begin > 1) {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    double sum = below;
    for (auto part = begin; part != middle; ++part) sum += part->second;
    if (2 * sum >= length) {
      end = middle;
    } else {
      below = sum;
      begin = middle;
    }
  }
  return begin == parts.end() ? 0 : std::max(0.0, begin->first - 0.5);
}

/// With steps no longer than from cell to cell, also where a line was drawn straight.
std::vector<LinePoint> with_short_steps(const std::vector<LinePoint>& points) {
  std::vector<LinePoint> result{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const LinePoint &a = points[i - 1], &b = points[i];
    const double parts = std::ceil(distance_between(a, b) / std::numbers::sqrt2 - 1e-9);
    for (double k = 1; k < parts; ++k) {
      const double part = k / parts;
      result.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
                        a.distance + part * (b.distance - a.distance)});
    }
    result.push_back(b);
  }
  return result;
}

RoadVertex to_vertex(const LinePoint& point, const GridFrame& frame) {
  const Vector2 place = frame.to_map(point.x, point.y);
  return {place.x(), place.y(), kNoElevation,
          std::max(0.0, point.distance - 0.5) * frame.resolution};
}

}  // namespace

RoadGraph to_road_graph(const LineNetwork& network, const Outlines& outlines, const EdgeGrid& edges,
                        const FreeSpace& space, const GridFrame& frame, const LineStyle& style,
                        const Checkpoint& checkpoint, RoadMemo* memo) {
  const DistanceField field(outlines, edges, space);
  std::vector<RoadNode> nodes;
  for (const auto& node : network.nodes) {
    const RoadVertex vertex = to_vertex(node.point, frame);
    nodes.push_back({0, vertex.x, vertex.y, vertex.z});
  }
  std::vector<SettledRoad> roads;
  std::vector<std::unique_ptr<FinishedRoad>> made;
  const auto finish = [&](const Line& line) {
    const std::vector<LinePoint> points = network.points(line).copy();
    std::vector<LinePoint> smooth =
        smooth_line(with_short_steps(points), kSmoothingReach, style.smoothing);
    field.estimate(smooth);
    const double width = 2 * median_clearance(smooth) * frame.resolution;
    std::vector<LinePoint> simple =
        simplify_line(smooth, style.tolerance / frame.resolution, kClearanceShare);
    LookedAt looked_at{memo ? std::move(smooth) : std::vector<LinePoint>(), {}};
    field.measure(simple, memo ? &looked_at : nullptr);
    std::vector<RoadVertex> vertices;
    for (const LinePoint& point : simple) vertices.push_back(to_vertex(point, frame));
    FinishedRoad road = settle_road(std::move(vertices), width, line.from == line.to);
    if (memo) return &memo->add(network.courses->name(line.course), std::move(road), looked_at);
    made.push_back(std::make_unique<FinishedRoad>(std::move(road)));
    return static_cast<const FinishedRoad*>(made.back().get());
  };
  for (const Line& line : network.lines) {
    checkpoint();
    const FinishedRoad* known = memo ? memo->find(network.courses->name(line.course)) : nullptr;
    roads.push_back({line.from, line.to, known ? known : finish(line)});
  }
  return assemble_roads(nodes, roads);
}

}  // namespace stope::topology
