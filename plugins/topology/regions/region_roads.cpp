#include "plugins/topology/regions/region_roads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plugins/topology/regions/network.hpp"
#include "plugins/topology/regions/ways_to_doors.hpp"
#include "plugins/topology/simplify_line.hpp"

namespace stope::topology {
namespace {

constexpr double kNoElevation = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmoothingReach = 3.0;  // cells
constexpr double kSmoothingShare = 0.4;  // of the distance to the obstacle
constexpr double kRasterSteps = 0.75;    // cells a straight line of cells is off at most

LinePoint at_cell(const Ground& ground, CellIndex cell) {
  return {ground.column(cell) + 0.5, ground.row(cell) + 0.5,
          std::sqrt(static_cast<double>(ground.squared(cell)))};
}

CellIndex cell_of(const Ground& ground, const ShapePoint& point) {
  return ground.index(static_cast<std::int32_t>(std::lround(point.x)),
                      static_cast<std::int32_t>(std::lround(point.y)));
}

bool is_free(const Ground& ground, const LinePoint& point) {
  const double x = std::floor(point.x), y = std::floor(point.y);
  if (x < 0 || y < 0 || x >= ground.width() || y >= ground.height()) return false;
  return ground.free(ground.index(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)));
}

bool stays_free(const Ground& ground, const std::vector<LinePoint>& line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = distance_between(line[i - 1], line[i]);
    const auto samples = static_cast<std::int32_t>(std::ceil(4 * length)) + 1;
    for (std::int32_t k = 0; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      if (!is_free(ground, {line[i - 1].x + part * (line[i].x - line[i - 1].x),
                            line[i - 1].y + part * (line[i].y - line[i - 1].y), 0}))
        return false;
    }
  }
  return true;
}

/// Simplified on both sides of its narrowest point, which stays.
std::vector<LinePoint> simplified(const std::vector<LinePoint>& line, double tolerance) {
  const auto narrowest = std::min_element(
      line.begin(), line.end(),
      [](const LinePoint& a, const LinePoint& b) { return a.distance < b.distance; });
  std::vector<LinePoint> result = simplify_line({line.begin(), narrowest + 1}, tolerance);
  const std::vector<LinePoint> rest = simplify_line({narrowest, line.end()}, tolerance);
  result.insert(result.end(), rest.begin() + 1, rest.end());
  return result;
}

struct Road {
  std::vector<LinePoint> line;
  double narrowest = 0, median = 0;  ///< distance in cells
};

Road road_along(const Ground& ground, const std::vector<LinePoint>& cells, double tolerance) {
  std::vector<LinePoint> smooth = smooth_line(cells, kSmoothingReach, kSmoothingShare);
  for (LinePoint& point : smooth) point.distance = ground.distance_at(point.x, point.y);
  Road road;
  road.line = simplified(smooth, std::max(tolerance, kRasterSteps));
  if (!stays_free(ground, road.line)) {
    smooth = cells;
    road.line = simplified(cells, 0);
  }
  std::vector<double> distances;
  for (const LinePoint& point : smooth) distances.push_back(point.distance);
  std::sort(distances.begin(), distances.end());
  road.narrowest = distances.front();
  road.median = distances[distances.size() / 2];
  return road;
}

/// Roads before they are chosen among, beside the borders they cross.
std::vector<Road> all_roads(const Ground& ground, const RegionCells& regions,
                            const std::vector<ShapePoint>& centres,
                            const std::vector<Border>& borders, double tolerance,
                            const Checkpoint& checkpoint) {
  std::vector<std::vector<CellIndex>> doors(centres.size());
  for (const Border& border : borders) {
    doors[static_cast<std::size_t>(border.first) - 1].push_back(border.first_door);
    doors[static_cast<std::size_t>(border.second) - 1].push_back(border.second_door);
  }
  WaysToDoors finder(ground, regions);
  std::vector<std::vector<std::vector<CellIndex>>> ways;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (i % 64 == 0) checkpoint();
    ways.push_back(finder.find(cell_of(ground, centres[i]), doors[i]));
  }
  std::vector<std::size_t> used(centres.size(), 0);
  std::vector<Road> roads;
  for (const Border& border : borders) {
    if (roads.size() % 64 == 0) checkpoint();
    const auto first = static_cast<std::size_t>(border.first) - 1;
    const auto second = static_cast<std::size_t>(border.second) - 1;
    const auto& out = ways[first][used[first]++];
    const auto& in = ways[second][used[second]++];
    std::vector<LinePoint> cells;
    for (auto cell = out.rbegin(); cell != out.rend(); ++cell)
      cells.push_back(at_cell(ground, *cell));
    for (const CellIndex cell : in) cells.push_back(at_cell(ground, cell));
    const auto centre_at = [&](LinePoint& point, const ShapePoint& centre) {
      point = {centre.x + 0.5, centre.y + 0.5, 0};
      point.distance = ground.distance_at(point.x, point.y);
    };
    centre_at(cells.front(), centres[first]);
    centre_at(cells.back(), centres[second]);
    roads.push_back(road_along(ground, cells, tolerance));
  }
  return roads;
}

std::vector<std::size_t> chosen(std::size_t count, const std::vector<Link>& links,
                                const RegionRoadsRule& rule) {
  if (rule.network == Network::kSpanningTree)
    return spanning_tree(static_cast<std::int32_t>(count), links);
  if (rule.network == Network::kSpanner)
    return spanner(static_cast<std::int32_t>(count), links, rule.stretch);
  std::vector<std::size_t> all(links.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

}  // namespace

RoadGraph region_roads(const Ground& ground, const RegionCells& regions,
                       const std::vector<ShapePoint>& centres, const std::vector<Border>& borders,
                       const RegionRoadsRule& rule, const Checkpoint& checkpoint) {
  const GridFrame& frame = ground.frame();
  RoadGraph graph;
  for (const ShapePoint& centre : centres) {
    const Vector2 place = frame.to_map(centre.x + 0.5, centre.y + 0.5);
    graph.nodes.push_back({0, place.x(), place.y(), kNoElevation});
  }
  std::vector<Road> roads =
      all_roads(ground, regions, centres, borders, rule.tolerance / frame.resolution, checkpoint);
  std::vector<Link> links;
  std::vector<std::size_t> wide;
  for (std::size_t i = 0; i < roads.size(); ++i) {
    if ((roads[i].narrowest - 0.5) * frame.resolution < rule.min_clearance) continue;
    double length = 0;
    for (std::size_t k = 1; k < roads[i].line.size(); ++k)
      length += distance_between(roads[i].line[k - 1], roads[i].line[k]);
    links.push_back({borders[i].first - 1, borders[i].second - 1, length});
    wide.push_back(i);
  }
  for (const std::size_t i : chosen(centres.size(), links, rule)) {
    const Road& road = roads[wide[i]];
    RoadEdge edge;
    edge.from = static_cast<std::uint32_t>(links[i].from);
    edge.to = static_cast<std::uint32_t>(links[i].to);
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = static_cast<std::uint32_t>(road.line.size());
    for (const LinePoint& point : road.line) {
      const Vector2 place = frame.to_map(point.x, point.y);
      graph.vertices.push_back({place.x(), place.y(), kNoElevation,
                                std::max(0.0, point.distance - 0.5) * frame.resolution});
    }
    edge.width = 2 * std::max(0.0, road.median - 0.5) * frame.resolution;
    graph.edges.push_back(edge);
  }
  canonicalize(graph);
  return graph;
}

}  // namespace stope::topology
