#include "plugins/topology/to_road_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "plugins/topology/assemble_roads.hpp"
#include "plugins/topology/simplify_line.hpp"

namespace stope::topology {
namespace {

constexpr double kNoElevation = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmoothingReach = 3.0;  // cells

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

/// The distance from any point to the nearest obstacle cell's centre, as the cells around see it.
class DistanceField {
 public:
  DistanceField(const Outlines& outlines, const EdgeGrid& edges, const FreeSpace& space)
      : outlines_(outlines), edges_(edges), space_(space) {}
  double at(const LinePoint& point) const {
    const auto column = static_cast<std::int32_t>(std::floor(point.x));
    const auto row = static_cast<std::int32_t>(std::floor(point.y));
    double least = point.distance;
    bool seen = false;
    for (std::int32_t y = std::max(row - 1, 0); y <= std::min(row + 1, space_.height() - 1); ++y) {
      for (std::int32_t x = std::max(column - 1, 0); x <= std::min(column + 1, space_.width() - 1);
           ++x) {
        const CellIndex cell = space_.index(x, y);
        if (space_[cell] & kObstacle) continue;
        const auto place = outlines_.place[static_cast<std::size_t>(edges_[cell])];
        const double there = distance_between(point, {place.column + 0.5, place.row + 0.5, 0});
        least = seen ? std::min(least, there) : there;
        seen = true;
      }
    }
    return least;
  }

 private:
  const Outlines& outlines_;
  const EdgeGrid& edges_;
  const FreeSpace& space_;
};

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
  std::vector<const FinishedRoad*> roads;
  std::vector<std::unique_ptr<FinishedRoad>> made;
  const auto finish = [&](const Line& line) {
    const std::vector<LinePoint> points = network.points(line).copy();
    std::vector<LinePoint> smooth = smooth_line(points, kSmoothingReach, style.smoothing);
    for (LinePoint& point : smooth) point.distance = field.at(point);
    std::vector<RoadVertex> vertices;
    for (const LinePoint& point : simplify_line(smooth, style.tolerance / frame.resolution))
      vertices.push_back(to_vertex(point, frame));
    const double width = 2 * median_clearance(smooth) * frame.resolution;
    FinishedRoad road = settle_road(std::move(vertices), width, line.from == line.to);
    if (memo) return &memo->add(network.courses->name(line.course), std::move(road), smooth);
    made.push_back(std::make_unique<FinishedRoad>(std::move(road)));
    return static_cast<const FinishedRoad*>(made.back().get());
  };
  for (const Line& line : network.lines) {
    checkpoint();
    const FinishedRoad* known = memo ? memo->find(network.courses->name(line.course)) : nullptr;
    roads.push_back(known ? known : finish(line));
  }
  return assemble_roads(network, nodes, roads);
}

}  // namespace stope::topology
