#include "plugins/topology/regions/finish_regions.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/regions/doors.hpp"
#include "plugins/topology/regions/known_regions.hpp"
#include "plugins/topology/regions/space_pieces.hpp"

namespace stope::topology {
namespace {

std::vector<std::size_t> order_of(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<Region> measured(const GridFrame& frame, const std::vector<KnownRegion>& known) {
  std::vector<Region> regions;
  for (const KnownRegion& region : known) {
    const Vector2 place = frame.to_map(region.centre.x + 0.5, region.centre.y + 0.5);
    regions.push_back({0, place.x(), place.y(), region.axes.major * frame.resolution,
                       region.axes.minor * frame.resolution, region.axes.yaw + frame.origin.yaw,
                       static_cast<double>(region.cells) * frame.resolution * frame.resolution});
  }
  return regions;
}

/// Leaves out the parts of free space that are too small, all but the largest one.
void drop_small(RegionSet& set, RegionParts& parts, std::vector<Border>& borders, double least_area,
                RegionsAndRoads& result) {
  DisjointSets pieces(parts.free_cells.size());
  for (const Border& border : borders) pieces.join(border.a - 1, border.b - 1);
  std::vector<std::int64_t> area(parts.free_cells.size(), 0);
  const auto piece_of = [&](std::size_t region) {
    return static_cast<std::size_t>(pieces.find(static_cast<std::int32_t>(region)));
  };
  for (std::size_t i = 0; i < area.size(); ++i) area[piece_of(i)] += parts.free_cells[i];
  const auto largest =
      static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
  std::vector<std::int32_t> number(area.size() + 1, 0);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const std::size_t piece = piece_of(i);
    if (piece == largest || static_cast<double>(area[piece]) >= least_area) {
      number[i + 1] = ++count;
    } else if (piece == i) {
      ++result.dropped;
      result.dropped_cells += area[piece];
    }
  }
  if (count == set.count) return;
  const auto now = [&](std::int32_t region) { return number[static_cast<std::size_t>(region)]; };
  for (std::int32_t& region : set.of_name) region = now(region);
  set.count = count;
  parts.keep([&](std::size_t region) { return number[region + 1] != 0; });
  // Regions that touch are left out together.
  std::erase_if(borders, [&](const Border& border) { return now(border.a) == 0; });
  for (Border& border : borders) border.a = now(border.a), border.b = now(border.b);
}

/// Gives each region the id of its node, which the graph has in the order of x and y.
void identify(std::vector<Region>& regions, const RoadGraph& roads) {
  std::vector<std::size_t> order = order_of(regions.size());
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(regions[a].x, regions[a].y) < std::tie(regions[b].x, regions[b].y);
  });
  for (std::size_t i = 0; i < order.size(); ++i) regions[order[i]].id = roads.nodes[i].id;
}

}  // namespace

RegionsAndRoads finish_regions(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const TileParts& tiles, const std::vector<Contact>& contacts,
                               RegionSet set, double least_area, const RegionRoadsRule& rule,
                               const Checkpoint& checkpoint, RegionMemo* memo,
                               const ChangedSquares* changed) {
  RegionsAndRoads result;
  RegionMemo fresh;
  RegionMemo& before = memo ? *memo : fresh;
  RegionParts parts = parts_of_regions(tiles, set);
  std::vector<Border> borders = find_borders(contacts, set);
  drop_small(set, parts, borders, least_area, result);
  result.neighbours = borders.size();
  SameRegions same;
  std::vector<KnownRegion> known =
      know_regions(ground, names, tiles, set, parts, before, changed, rule, same, checkpoint);
  const std::vector<Door> doors =
      rule.every_door
          ? find_doors(ground, names, set, contacts, rule.least_squared(ground.frame().resolution),
                       same, before, checkpoint)
          : doors_at_borders(borders, same, before);
  std::vector<RegionRoad> roads =
      region_roads(ground, names, tiles, set, parts, doors, known, rule, before, checkpoint);
  result.roads = graph_of_roads(ground.frame(), known, doors, roads, rule);
  std::vector<Region> regions = measured(ground.frame(), known);
  identify(regions, result.roads);
  std::vector<std::size_t> order = order_of(regions.size());
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(regions[a].id, a) < std::tie(regions[b].id, b);
  });
  std::vector<std::int32_t> label(regions.size() + 1, 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    label[order[i] + 1] = static_cast<std::int32_t>(i) + 1;
    result.map.regions.push_back(regions[order[i]]);
    // Ids are made to the centimetre; a finer map may have two centres in one.
    auto& placed = result.map.regions;
    if (i > 0 && placed[i].id <= placed[i - 1].id) placed[i].id = placed[i - 1].id + 1;
  }
  DisjointSets pieces(regions.size());
  result.pieces = regions.size();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Border& border : borders) {
    if (pieces.join(border.a - 1, border.b - 1)) --result.pieces;
    const auto a = static_cast<std::uint32_t>(label[static_cast<std::size_t>(border.a)] - 1);
    const auto b = static_cast<std::uint32_t>(label[static_cast<std::size_t>(border.b)] - 1);
    pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [a, b] : pairs) {
    result.map.adjacency.push_back(a);
    result.map.adjacency.push_back(b);
  }
  for (const std::int32_t region : set.of_name)
    result.label_of_name.push_back(label[static_cast<std::size_t>(region)]);
  const std::int64_t covered =
      std::accumulate(parts.free_cells.begin(), parts.free_cells.end(), std::int64_t{0});
  result.covered = ground.free_cells() == 0
                       ? 0
                       : static_cast<double>(covered) / static_cast<double>(ground.free_cells());
  // Where every free cell has a region, the regions' pieces are those of free space.
  result.space_pieces = result.pieces > 1 && covered + result.dropped_cells <
                                                 static_cast<std::int64_t>(ground.free_cells())
                            ? count_space_pieces(ground, names, tiles, contacts, set, checkpoint)
                            : result.pieces;
  if (memo) remember_regions(std::move(known), doors, std::move(roads), before);
  return result;
}

}  // namespace stope::topology
