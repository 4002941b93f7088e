#include "plugins/topology/regions/region_roads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "plugins/topology/assemble_roads.hpp"
#include "plugins/topology/for_each_band.hpp"
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

/// Whether a line is at least this far from the centres of obstacle cells everywhere.
bool stays_clear(const Ground& ground, const std::vector<LinePoint>& line, double least) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = distance_between(line[i - 1], line[i]);
    const auto samples = static_cast<std::int32_t>(std::ceil(4 * length)) + 1;
    for (std::int32_t k = 0; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      const double x = line[i - 1].x + part * (line[i].x - line[i - 1].x);
      const double y = line[i - 1].y + part * (line[i].y - line[i - 1].y);
      if (!is_free(ground, {x, y, 0}) || ground.distance_at(x, y) < least) return false;
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

/// A distance from the centre of an obstacle cell, as metres from its edge.
double clearance_at(double distance, const GridFrame& frame) {
  return std::max(0.0, distance - 0.5) * frame.resolution;
}

RegionRoad settled(const std::vector<LinePoint>& line, double median, const GridFrame& frame) {
  std::vector<RoadVertex> vertices;
  vertices.reserve(line.size());
  for (const LinePoint& point : line) {
    const Vector2 at = frame.to_map(point.x, point.y);
    vertices.push_back({at.x(), at.y(), kNoElevation, clearance_at(point.distance, frame)});
  }
  return {settle_road(std::move(vertices), 2 * clearance_at(median, frame), false),
          length_of(line)};
}

/// The line along these cells, as smooth as it may be without getting nearer than `least` to an
/// obstacle where the cells do not.
RegionRoad road_along(const Ground& ground, const std::vector<LinePoint>& cells, double tolerance,
                      double least) {
  std::vector<LinePoint> smooth, line;
  const auto drawn = [&](double share) {
    smooth = smooth_line(cells, kSmoothingReach, share);
    for (LinePoint& point : smooth) point.distance = ground.distance_at(point.x, point.y);
    line = simplified(smooth, std::max(tolerance, kRasterSteps));
    return stays_clear(ground, line, least);
  };
  if (!drawn(kSmoothingShare) && !drawn(0)) {
    smooth = cells;
    line = simplified(cells, 0);
  }
  std::vector<double> distances;
  for (const LinePoint& point : smooth) distances.push_back(point.distance);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return settled(line, *middle, ground.frame());
}

std::size_t place(std::int32_t region) { return static_cast<std::size_t>(region) - 1; }

/// The cell of a border's clearest pair that lies in the region.
CellIndex door_of(const Border& border, std::int32_t region, const RegionSet& set,
                  const PaddedGrid<std::int32_t>& names) {
  return set.of(names[border.low]) == region ? border.low : border.high;
}

/// Finds the ways to the doors of a region; those it knows already are taken as they are.
template <class Tiles>
void find_ways(WaysToDoors& finder, CellIndex centre, std::vector<CellIndex> doors, Tiles tiles,
               KnownRegion& region) {
  std::vector<std::vector<CellIndex>> ways(doors.size());
  std::vector<CellIndex> wanted;
  std::vector<std::size_t> wanted_at;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    const auto known = std::find(region.doors.begin(), region.doors.end(), doors[i]);
    if (known == region.doors.end()) {
      wanted.push_back(doors[i]);
      wanted_at.push_back(i);
    } else {
      ways[i] = region.ways[static_cast<std::size_t>(known - region.doors.begin())];
    }
  }
  std::vector<std::vector<CellIndex>> found = finder.find(centre, wanted, region.widest, tiles);
  for (std::size_t k = 0; k < wanted.size(); ++k) ways[wanted_at[k]] = std::move(found[k]);
  region.doors = std::move(doors);
  region.ways = std::move(ways);
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

std::int32_t RegionRoadsRule::reach(double resolution) const {
  return static_cast<std::int32_t>(
      std::min(1e6, std::ceil(std::max(tolerance / resolution, kRasterSteps) + kSmoothingReach)) +
      2);
}

double RegionRoadsRule::least_distance(double resolution) const {
  // Clearance counts from an obstacle's edge, distance from its cell's centre.
  constexpr double kRounding = 1e-9, kMost = 30000;
  return std::min(kMost, min_clearance / resolution + 0.5 - kRounding);
}

std::int32_t RegionRoadsRule::least_squared(double resolution) const {
  const double distance = least_distance(resolution);
  return std::max(1, static_cast<std::int32_t>(std::ceil(distance * distance)));
}

std::vector<RegionRoad> region_roads(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                     const TileParts& tiles, const RegionSet& set,
                                     const RegionParts& parts, const std::vector<Door>& doors,
                                     std::vector<KnownRegion>& known, const RegionRoadsRule& rule,
                                     RegionMemo& memo, const Checkpoint& checkpoint) {
  const std::size_t count = known.size();
  std::vector<std::vector<CellIndex>> cells_of(count);
  struct Use {
    std::size_t first = 0, second = 0;  ///< regions; the one with the lower key first
    std::size_t out = 0, in = 0;        ///< of their ways
  };
  std::vector<Use> uses;
  uses.reserve(doors.size());
  for (const Door& door : doors) {
    const Border& border = door.border;
    const auto key = [&](std::int32_t region) { return known[place(region)].members.front(); };
    const bool swapped = key(border.b) < key(border.a);
    const std::int32_t first = swapped ? border.b : border.a,
                       second = swapped ? border.a : border.b;
    uses.push_back({place(first), place(second), cells_of[place(first)].size(),
                    cells_of[place(second)].size()});
    cells_of[place(first)].push_back(door_of(border, first, set, names));
    cells_of[place(second)].push_back(door_of(border, second, set, names));
  }
  const std::int32_t least = rule.least_squared(ground.frame().resolution);
  for_each_band(static_cast<std::int32_t>(count), checkpoint, [&] {
    return [&, finder = std::make_shared<WaysToDoors>(ground, names, set, least)](std::int32_t i) {
      const auto region = static_cast<std::size_t>(i);
      KnownRegion& now = known[region];
      if (now.doors == cells_of[region]) return;
      find_ways(
          *finder, cell_of(ground, now.centre), std::move(cells_of[region]),
          [&] { return parts.tiles_of(tiles, region); }, now);
    };
  });
  std::vector<RegionRoad> roads(doors.size());
  const double least_distance = rule.least_distance(ground.frame().resolution);
  const double tolerance = rule.tolerance / ground.frame().resolution;
  for_each_band(static_cast<std::int32_t>(doors.size()), checkpoint, [&] {
    return [&](std::int32_t i) {
      RegionRoad& road = roads[static_cast<std::size_t>(i)];
      if (const std::int32_t before = doors[static_cast<std::size_t>(i)].before; before >= 0) {
        road = std::move(memo.roads[static_cast<std::size_t>(before)]);
        return;
      }
      const Use& use = uses[static_cast<std::size_t>(i)];
      const KnownRegion &first = known[use.first], &second = known[use.second];
      const auto& out = first.ways[use.out];
      const auto& in = second.ways[use.in];
      if (out.empty() || in.empty()) return;
      std::vector<LinePoint> cells;
      for (auto cell = out.rbegin(); cell != out.rend(); ++cell)
        cells.push_back(at_cell(ground, *cell));
      for (const CellIndex cell : in) cells.push_back(at_cell(ground, cell));
      const auto centre_at = [&](LinePoint& point, const ShapePoint& centre) {
        point = {centre.x + 0.5, centre.y + 0.5, 0};
        point.distance = ground.distance_at(point.x, point.y);
      };
      centre_at(cells.front(), first.centre);
      centre_at(cells.back(), second.centre);
      road = road_along(ground, cells, tolerance, least_distance);
    };
  });
  return roads;
}

RoadGraph graph_of_roads(const GridFrame& frame, const std::vector<KnownRegion>& known,
                         const std::vector<Door>& doors, const std::vector<RegionRoad>& roads,
                         const RegionRoadsRule& rule) {
  std::vector<RoadNode> nodes;
  nodes.reserve(known.size());
  for (const KnownRegion& region : known) {
    const Vector2 at = frame.to_map(region.centre.x + 0.5, region.centre.y + 0.5);
    nodes.push_back({0, at.x(), at.y(), kNoElevation});
  }
  std::vector<Link> links;
  std::vector<std::size_t> wide;
  for (std::size_t i = 0; i < roads.size(); ++i) {
    if (!roads[i].exists()) continue;
    links.push_back({doors[i].border.a - 1, doors[i].border.b - 1, roads[i].length});
    wide.push_back(i);
  }
  std::vector<SettledRoad> kept;
  for (const std::size_t i : chosen(known.size(), links, rule))
    kept.push_back({links[i].from, links[i].to, &roads[wide[i]].settled});
  return assemble_roads(nodes, kept);
}

}  // namespace stope::topology
