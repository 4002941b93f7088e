#include "plugins/topology/regions/segment_by_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "plugins/topology/regions/absorb_rest.hpp"
#include "plugins/topology/regions/grow_as_printed.hpp"
#include "stope/error.hpp"

namespace stope::topology {
namespace {

GrowthRule growth_rule(const GrowingParams& params, const GridFrame& frame) {
  GrowthRule rule;
  // Beyond the map there is nothing to grow into.
  const double most =
      std::min<double>(RingTable::kMostRings, std::hypot(frame.width, frame.height));
  rule.growth_radius = std::min(most, params.growth_radius / frame.resolution);
  rule.max_radius =
      std::min(most, std::max(params.growth_radius, params.max_radius) / frame.resolution);
  rule.radius_weight = params.radius_weight;
  rule.addition_ratio = params.addition_ratio;
  rule.obstacle_ratio = params.obstacle_ratio;
  rule.as_printed = params.as_printed;
  return rule;
}

MergeRule merge_rule(const GrowingParams& params, const GridFrame& frame) {
  MergeRule rule;
  rule.radius = params.merge_radius / frame.resolution;
  rule.area = params.merge_area / (frame.resolution * frame.resolution);
  // Line 17 of Algorithm 2 compares with r_a where its text means a bound on the obstacles.
  rule.obstacle_ratio = params.as_printed ? params.addition_ratio : params.merge_obstacle_ratio;
  rule.as_printed = params.as_printed;
  return rule;
}

void check(const GrowingParams& params, const GridFrame& frame) {
  if (params.growth_radius >= frame.resolution) return;
  throw Error(fmt::format(
      "growth_radius is {} m, less than one cell of the map ({} m), so no region could grow; check "
      "the map's resolution or give a larger growth_radius",
      params.growth_radius, frame.resolution));
}

/// Where a ground differs from an earlier one for regions of at most `radius`.
ChangedTiles difference(const Ground& ground, const GroundChange& change, double radius) {
  ChangedTiles changed(ground.width(), ground.height());
  const auto bound = static_cast<std::int32_t>(std::min(radius * radius + 1, 1e9));
  // Whether a cell is a growth point depends on its neighbours, and on its square for what is open.
  const std::int32_t square = std::max(2, spacing_in_the_open(radius));
  for (const auto& [cell, squared] : change.cells) {
    const std::int32_t now = ground.squared(cell);
    if (std::min(bound, now) == std::min(bound, squared)) continue;
    changed.add(ground.column(cell), ground.row(cell),
                is_open(now, radius) == is_open(squared, radius) ? 2 : square);
  }
  return changed;
}

RegionCells cells_of(const Ground& ground, const std::vector<GrownRegion>& grown) {
  RegionCells regions = without_regions(ground);
  std::int32_t number = 0;
  for (const GrownRegion& region : grown) {
    ++number;
    for (const CellIndex cell : region.growth.cells) regions[cell] = number;
  }
  return regions;
}

std::vector<CellIndex> free_cells(const Ground& ground) {
  std::vector<CellIndex> cells;
  cells.reserve(ground.free_cells());
  for (std::size_t i = 0; i < ground.size(); ++i)
    if (ground.free(static_cast<CellIndex>(i))) cells.push_back(static_cast<CellIndex>(i));
  return cells;
}

std::vector<GrownRegion> grow(const Ground& ground, const std::vector<CellIndex>& visited,
                              const GrowthRule& rule, const Checkpoint& checkpoint,
                              GrowthMemory* memory, const GroundChange* change) {
  const std::vector<std::vector<GrowthPoint>> groups{
      points_at(ground, visited, rule.max_radius),
      middle_points(ground, rule.max_radius, checkpoint)};
  if (!memory || !change || memory->visited != visited)
    return grow_regions(ground, groups, rule, checkpoint);
  EarlierGrowth earlier{std::move(memory->regions), difference(ground, *change, rule.max_radius)};
  auto grown = grow_regions(ground, groups, rule, checkpoint, &earlier);
  memory->reused = earlier.reused;
  return grown;
}

/// Each grown region by itself, known by the point it grew from.
RegionSet set_of(const std::vector<GrownRegion>& grown) {
  RegionSet set;
  set.of_name.push_back(0);
  set.key_of_name.push_back(0);
  for (const GrownRegion& region : grown) {
    set.of_name.push_back(++set.count);
    set.key_of_name.push_back(region.point.cell);
  }
  return set;
}

/// Adds the tiles with cells that are in another region than before.
void add_moved_cells(const Ground& ground, const RegionCells& now, const RegionSet& set,
                     const RegionCells& before, const std::vector<CellIndex>& keys_before,
                     TileSet& changed) {
  for (const std::int32_t tile : all_tiles(ground)) {
    if (changed.has(tile)) continue;
    changed.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
      for (CellIndex cell = first; cell < first + count; ++cell)
        if (set.key_of_name[static_cast<std::size_t>(now[cell])] !=
            keys_before[static_cast<std::size_t>(before[cell])]) {
          changed.add(tile);
          return;
        }
    });
  }
}

}  // namespace

std::vector<CellIndex> cells_visited(const Ground& ground, const Trajectory& trajectory,
                                     std::size_t& outside, std::size_t& blocked) {
  std::vector<CellIndex> cells;
  outside = blocked = 0;
  for (const StampedPose& stamped : trajectory.poses) {
    const auto& place = stamped.T_map_lidar.translation;
    const auto cell = ground.frame().cell_at(place.x(), place.y());
    if (!cell) {
      ++outside;
      continue;
    }
    const CellIndex index = ground.index(cell->column, cell->row);
    if (ground.free(index)) {
      if (cells.empty() || cells.back() != index) cells.push_back(index);
    } else {
      ++blocked;
    }
  }
  return cells;
}

RegionsAndRoads segment_by_growth(const Ground& ground, std::vector<CellIndex> visited,
                                  const GrowingParams& params, const RegionRoadsRule& roads,
                                  Random random, const Checkpoint& checkpoint, GrowthMemory* memory,
                                  const GroundChange* change) {
  const GridFrame& frame = ground.frame();
  check(params, frame);
  const GrowthRule rule = growth_rule(params, frame);
  RegionRoadsRule roads_rule = roads;
  RegionCells regions = without_regions(ground);
  std::vector<GrownRegion> grown;
  RegionSet set;
  if (memory) memory->reused = 0;
  if (memory && (!change || !memory->names)) *memory = {}, change = nullptr;
  std::vector<CellIndex> keys_before;
  if (memory) keys_before = set_of(memory->regions).key_of_name;
  if (params.as_printed) {
    std::sort(visited.begin(), visited.end());
    visited.erase(std::unique(visited.begin(), visited.end()), visited.end());
    std::int32_t count = 0;
    regions = grow_as_printed(ground, visited.empty() ? free_cells(ground) : visited, rule,
                              params.coverage, params.second_radius / frame.resolution, random,
                              checkpoint, count);
    for (std::int32_t name = 0; name <= count; ++name) {
      set.of_name.push_back(name);
      set.key_of_name.push_back(name);
    }
    set.count = count;
    roads_rule.network = Network::kSpanningTree;
  } else {
    grown = grow(ground, visited, rule, checkpoint, memory, change);
    regions = cells_of(ground, grown);
    set = set_of(grown);
    if (!memory) grown = {};
    const double reach = std::min(1e9, params.second_radius / frame.resolution);
    absorb_rest(ground, regions, static_cast<std::int32_t>(reach), checkpoint);
  }
  TileParts tiles(ground.width(), ground.height());
  tiles.look_at(ground, regions, all_tiles(ground), checkpoint);
  const std::vector<Contact> contacts = all_contacts(tiles);
  merge_regions(ground, regions, tiles, contacts, set, merge_rule(params, frame), checkpoint);
  std::optional<TileSet> changed;
  if (change && !params.as_printed) {
    changed = change->tiles;
    add_moved_cells(ground, regions, set, *memory->names, keys_before, *changed);
  }
  RegionsAndRoads result =
      finish_regions(ground, regions, tiles, contacts, set,
                     params.min_region_area / (frame.resolution * frame.resolution), roads_rule,
                     checkpoint, memory ? &memory->memo : nullptr, changed ? &*changed : nullptr);
  if (memory && !params.as_printed) {
    memory->visited = std::move(visited);
    memory->regions = std::move(grown);
    memory->names = std::make_unique<RegionCells>(std::move(regions));
  }
  return result;
}

}  // namespace stope::topology
