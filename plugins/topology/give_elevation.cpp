#include "plugins/topology/give_elevation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plugins/topology/check_frame.hpp"
#include "stope/error.hpp"

namespace stope::topology {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 1.0;  // metres

class Ground {
 public:
  explicit Ground(const ElevationGrid& grid) : grid_(grid), frame_(grid.frame) {
    check_frame(frame_, grid.cells.size(), "elevation");
  }

  double at(double x, double y) const {
    const Vector2 place = frame_.to_grid(x, y);
    if (!(place.x() >= 0 && place.y() >= 0 && place.x() <= frame_.width &&
          place.y() <= frame_.height))
      return kUnknown;
    const double u = std::clamp(place.x() - 0.5, 0.0, frame_.width - 1.0);
    const double v = std::clamp(place.y() - 0.5, 0.0, frame_.height - 1.0);
    const auto column = static_cast<std::int32_t>(u), row = static_cast<std::int32_t>(v);
    const double s = u - column, t = v - row;
    const double low = mix(cell(column, row), s > 0 ? cell(column + 1, row) : 0, s);
    const double high =
        t > 0 ? mix(cell(column, row + 1), s > 0 ? cell(column + 1, row + 1) : 0, s) : 0;
    return mix(low, high, t);
  }

 private:
  double cell(std::int32_t column, std::int32_t row) const {
    return grid_.cells[frame_.place({column, row})];
  }
  static double mix(double a, double b, double share) { return a + share * (b - a); }

  const ElevationGrid& grid_;
  const GridFrame& frame_;
};

RoadVertex between(const RoadVertex& a, const RoadVertex& b, double share, const Ground& ground) {
  RoadVertex vertex{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), 0,
                    a.clearance + share * (b.clearance - a.clearance)};
  vertex.z = ground.at(vertex.x, vertex.y);
  return vertex;
}

/// Marks the places between two known ones that lie off the straight profile; NaN are not among
/// them.
void keep_bends(const std::vector<RoadVertex>& places, std::size_t begin, std::size_t end,
                double tolerance, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{begin, end}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t bend = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double share = static_cast<double>(i - first) / static_cast<double>(last - first);
      const double line = places[first].z + share * (places[last].z - places[first].z);
      const double off = std::abs(places[i].z - line);
      if (!(off > worst)) continue;
      worst = off;
      bend = i;
    }
    if (bend == first) continue;
    kept[bend] = true;
    open.emplace_back(first, bend);
    open.emplace_back(bend, last);
  }
}

/// Appends the places between a and b where a profile through straight pieces must bend.
void add_bends(const RoadVertex& a, const RoadVertex& b, const Ground& ground, double tolerance,
               std::vector<RoadVertex>& out) {
  const auto parts = static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / kStep));
  std::vector<RoadVertex> places{a};
  for (int i = 1; i < parts; ++i)
    places.push_back(between(a, b, static_cast<double>(i) / parts, ground));
  places.push_back(b);
  std::vector<bool> kept(places.size(), false);
  // Both sides of the known ground's border.
  for (std::size_t i = 1; i < places.size(); ++i)
    if (std::isnan(places[i - 1].z) != std::isnan(places[i].z)) kept[i - 1] = kept[i] = true;
  std::size_t first = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (!kept[i] && i + 1 < places.size()) continue;
    if (!std::isnan(places[first].z)) keep_bends(places, first, i, tolerance, kept);
    first = i;
  }
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
    if (kept[i]) out.push_back(places[i]);
}

}  // namespace

void give_elevation(RoadGraph& roads, const ElevationGrid& elevation, double tolerance) {
  const Ground ground(elevation);
  for (RoadNode& node : roads.nodes) node.z = ground.at(node.x, node.y);
  for (RoadVertex& vertex : roads.vertices) vertex.z = ground.at(vertex.x, vertex.y);
  std::vector<RoadVertex> vertices;
  for (RoadEdge& edge : roads.edges) {
    const auto line = roads.polyline(edge);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) add_bends(line[i - 1], line[i], ground, tolerance, vertices);
      vertices.push_back(line[i]);
    }
    edge.first_vertex = first;
    edge.vertex_count = static_cast<std::uint32_t>(vertices.size()) - first;
  }
  roads.vertices = std::move(vertices);
  canonicalize(roads);
}

}  // namespace stope::topology
