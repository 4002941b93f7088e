#include "plugins/topology/regions/region_roads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "plugins/topology/assemble_roads.hpp"
#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/regions/draw_region_road.hpp"
#include "plugins/topology/regions/network.hpp"
#include "plugins/topology/regions/ways_to_doors.hpp"

namespace stope::topology {
namespace {

constexpr double kNoElevation = std::numeric_limits<double>::quiet_NaN();

CellIndex cell_of(const Ground& ground, const ShapePoint& point) {
  return ground.index(static_cast<std::int32_t>(std::lround(point.x)),
                      static_cast<std::int32_t>(std::lround(point.y)));
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
  const bool many = WaysToDoors::are_many(doors.size());
  if (many != WaysToDoors::are_many(region.doors.size())) region.doors.clear();
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
  std::vector<std::vector<CellIndex>> found =
      finder.find(centre, wanted, many, region.widest, tiles);
  for (std::size_t k = 0; k < wanted.size(); ++k) ways[wanted_at[k]] = std::move(found[k]);
  region.doors = std::move(doors);
  region.ways = std::move(ways);
}

std::vector<std::size_t> chosen(std::size_t count, const std::vector<RegionLink>& links,
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
             std::min(1e6, std::ceil(reach_of_region_road(tolerance / resolution)))) +
         2;
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
      if (!out.empty() && !in.empty())
        road = draw_region_road(ground, first.centre, out, in, second.centre, tolerance,
                                least_distance);
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
  std::vector<RegionLink> links;
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
