#include "plugins/source/synthetic_pit/truth.hpp"

#include <algorithm>
#include <cmath>

namespace stope::source {
namespace {

constexpr double kWidestPlace = 60;  // metres: no clearance is larger

/// Searches squares of growing size around a place, at most as far as the nearest obstacle found.
double clearance(const Terrain& terrain, const Vector2& place) {
  const GridFrame& frame = terrain.frame;
  const Vector2 centre = frame.to_grid(place.x(), place.y());
  const auto column = static_cast<std::int32_t>(centre.x()),
             row = static_cast<std::int32_t>(centre.y());
  const auto widest = static_cast<std::int32_t>(kWidestPlace / frame.resolution);
  double nearest = widest;  // cells
  const auto look = [&](std::int32_t c, std::int32_t r) {
    if (frame.contains({c, r}) && terrain.drivable[frame.place({c, r})]) return;
    nearest = std::min(nearest, std::hypot(c + 0.5 - centre.x(), r + 0.5 - centre.y()) - 0.5);
  };
  for (std::int32_t ring = 0; ring < nearest + 2; ++ring) {
    for (std::int32_t k = -ring; k <= ring; ++k) {
      look(column + k, row - ring);
      look(column + k, row + ring);
      look(column - ring, row + k);
      look(column + ring, row + k);
    }
  }
  return std::max(0.0, nearest) * frame.resolution;
}

}  // namespace

OccupancyGrid true_grid(const Terrain& terrain) {
  OccupancyGrid grid;
  grid.frame = terrain.frame;
  grid.cells.resize(terrain.drivable.size());
  std::transform(terrain.drivable.begin(), terrain.drivable.end(), grid.cells.begin(),
                 [](std::uint8_t drivable) {
                   return drivable ? OccupancyGrid::kFree : OccupancyGrid::kOccupied;
                 });
  return grid;
}

ElevationGrid true_elevation(const Terrain& terrain) {
  ElevationGrid grid;
  grid.frame = terrain.frame;
  grid.cells = terrain.height;
  return grid;
}

RoadGraph true_roads(const NetworkGraph& graph, const Terrain& terrain,
                     const Checkpoint& checkpoint) {
  RoadGraph roads;
  for (const auto& node : graph.nodes)
    roads.nodes.push_back({0, node.place.x(), node.place.y(), node.elevation});
  for (const auto& edge : graph.edges) {
    RoadEdge road;
    road.from = static_cast<std::uint32_t>(edge.from);
    road.to = static_cast<std::uint32_t>(edge.to);
    road.first_vertex = static_cast<std::uint32_t>(roads.vertices.size());
    road.vertex_count = static_cast<std::uint32_t>(edge.points.size());
    road.width = edge.width;
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      checkpoint();
      roads.vertices.push_back({edge.points[i].x(), edge.points[i].y(), edge.elevation[i],
                                clearance(terrain, edge.points[i])});
    }
    roads.edges.push_back(road);
  }
  canonicalize(roads);
  return roads;
}

}  // namespace stope::source
