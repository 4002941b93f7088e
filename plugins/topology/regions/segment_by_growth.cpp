#include "plugins/topology/regions/segment_by_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "plugins/topology/regions/absorb_rest.hpp"
#include "plugins/topology/regions/grow_as_printed.hpp"
#include "plugins/topology/regions/regrow_regions.hpp"
#include "plugins/topology/regions/write_labels.hpp"
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

/// Where growth of at most `radius` sees another ground than before, or other points on it.
ChangedSquares difference(const Ground& ground, const GroundChange& change, double radius,
                          const std::vector<CellIndex>& visited,
                          const std::vector<CellIndex>& visited_before) {
  ChangedSquares changed(ground.width(), ground.height());
  const auto bound = static_cast<std::int32_t>(std::min(radius * radius + 1, 1e9));
  // Whether a cell is a growth point depends on its neighbours, and on its square for what is open.
  const std::int32_t square = std::max(1, spacing_in_the_open(radius));
  for (const auto& [cell, squared] : change.cells) {
    const std::int32_t now = ground.squared(cell);
    if (std::min(bound, now) == std::min(bound, squared)) continue;
    changed.add(ground.column(cell), ground.row(cell),
                is_open(now, radius) == is_open(squared, radius) ? 1 : square);
  }
  std::vector<CellIndex> differs;
  std::set_symmetric_difference(visited.begin(), visited.end(), visited_before.begin(),
                                visited_before.end(), std::back_inserter(differs));
  for (const CellIndex cell : differs) changed.add(ground.column(cell), ground.row(cell));
  return changed;
}

std::vector<CellIndex> free_cells(const Ground& ground) {
  std::vector<CellIndex> cells;
  cells.reserve(ground.free_cells());
  for (std::size_t i = 0; i < ground.size(); ++i)
    if (ground.free(static_cast<CellIndex>(i))) cells.push_back(static_cast<CellIndex>(i));
  return cells;
}

std::vector<CellIndex> sorted(std::vector<CellIndex> cells) {
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// Each grown region by itself, known by the point it grew from.
RegionSet set_of(const GrownRegions& grown) {
  RegionSet set;
  set.of_name.resize(static_cast<std::size_t>(grown.names_given) + 1, 0);
  set.key_of_name.resize(set.of_name.size(), 0);
  for (const GrownRegion& region : grown.list) {
    set.of_name[static_cast<std::size_t>(region.name)] = ++set.count;
    set.key_of_name[static_cast<std::size_t>(region.name)] = region.point.cell;
  }
  return set;
}

std::int32_t steps_of(double length, const GridFrame& frame) {
  return static_cast<std::int32_t>(std::min(1e9, length / frame.resolution));
}

/// Grows all regions, or after a change those that see it, and looks at what they are; gives the
/// cells that have moved.
std::optional<MovedCells> grow(const Ground& ground, std::vector<CellIndex> visited,
                               const GrowingParams& params, bool keep, GrowthMemory& memory,
                               const GroundChange* change, const Checkpoint& checkpoint) {
  const GrowthRule rule = growth_rule(params, ground.frame());
  const std::int32_t reach = steps_of(params.second_radius, ground.frame());
  visited = sorted(std::move(visited));
  std::vector<std::vector<GrowthPoint>> groups{points_at(ground, visited, rule.max_radius), {}};
  if (!change) {
    groups[1] = middle_points(ground, rule.max_radius, checkpoint);
    memory.grown = grow_regions(ground, groups, rule, keep, checkpoint);
    if (keep) memory.middle = std::move(groups[1]), memory.visited = std::move(visited);
    groups.clear();
    absorb_rest(ground, *memory.grown, reach, checkpoint);
    memory.tiles.emplace(ground.width(), ground.height());
    memory.tiles->look_at(ground, memory.grown->names, all_tiles(ground), checkpoint);
    if (keep) memory.names.emplace(memory.grown->names, checkpoint);
    return {};
  }
  ChangedSquares seen = difference(ground, *change, rule.max_radius, visited, memory.visited);
  groups[1] = std::move(memory.middle);
  update_middle_points(ground, rule.max_radius, seen, groups[1]);
  MovedCells moved(change->squares);
  memory.reused = regrow_regions(ground, groups, rule, checkpoint, *memory.grown, seen, moved);
  memory.middle = std::move(groups[1]), memory.visited = std::move(visited);
  absorb_again(ground, *memory.grown, reach, seen, moved, checkpoint);
  memory.tiles->look_at(ground, memory.grown->names, tiles_that_see(moved.squares()), checkpoint);
  memory.names->update(memory.grown->names, moved.squares(), checkpoint);
  return moved;
}

RegionsAndRoads grow_and_finish(const Ground& ground, const std::vector<CellIndex>& visited,
                                const GrowingParams& params, const RegionRoadsRule& roads,
                                bool keep, GrowthMemory& memory, const GroundChange* change,
                                const Checkpoint& checkpoint) {
  const GridFrame& frame = ground.frame();
  const std::optional<MovedCells> moved =
      grow(ground, visited, params, keep, memory, change, checkpoint);
  RegionSet set = set_of(*memory.grown);
  const RegionCells& names = memory.grown->names;
  const std::vector<Contact> contacts = all_contacts(*memory.tiles);
  const std::vector<std::int32_t> stale = update_shapes(
      ground, names, set, *memory.tiles, moved ? &*moved : nullptr, memory.shapes, checkpoint);
  if (keep) memory.merges.renew(stale, memory.shapes.size());
  merge_regions(ground, names, memory.shapes, contacts, set, merge_rule(params, frame), checkpoint,
                keep ? &memory.merges : nullptr);
  const double least_area = params.min_region_area / (frame.resolution * frame.resolution);
  return finish_regions(ground, names, *memory.tiles, contacts, set, least_area, roads, checkpoint,
                        &memory.memo, moved ? &moved->squares() : nullptr);
}

/// `mode: paper`, up to the labels.
RegionsAndRoads segment_as_printed(const Ground& ground, std::vector<CellIndex> visited,
                                   const GrowingParams& params, RegionRoadsRule roads,
                                   Random random, RegionCells& names,
                                   const Checkpoint& checkpoint) {
  const GridFrame& frame = ground.frame();
  visited = sorted(std::move(visited));
  RegionSet set;
  names = grow_as_printed(ground, visited.empty() ? free_cells(ground) : visited,
                          growth_rule(params, frame), params.coverage,
                          params.second_radius / frame.resolution, random, checkpoint, set.count);
  for (std::int32_t name = 0; name <= set.count; ++name) {
    set.of_name.push_back(name);
    set.key_of_name.push_back(name);
  }
  set.in_one_piece = false;
  roads.network = Network::kSpanningTree;
  TileParts tiles(ground.width(), ground.height());
  tiles.look_at(ground, names, all_tiles(ground), checkpoint);
  const std::vector<Contact> contacts = all_contacts(tiles);
  std::vector<RegionShape> shapes;
  update_shapes(ground, names, set, tiles, nullptr, shapes, checkpoint);
  merge_regions(ground, names, shapes, contacts, set, merge_rule(params, frame), checkpoint);
  return finish_regions(ground, names, tiles, contacts, set,
                        params.min_region_area / (frame.resolution * frame.resolution), roads,
                        checkpoint);
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

RegionsAndRoads segment_by_growth(Ground&& ground, const std::vector<CellIndex>& visited,
                                  const GrowingParams& params, const RegionRoadsRule& roads,
                                  Random random, const Checkpoint& checkpoint) {
  const GridFrame frame = ground.frame();
  check(params, frame);
  RegionCells names(0, 0);
  RegionsAndRoads result;
  if (params.as_printed) {
    result = segment_as_printed(ground, visited, params, roads, random, names, checkpoint);
  } else {
    GrowthMemory memory;
    result = grow_and_finish(ground, visited, params, roads, false, memory, nullptr, checkpoint);
    names = std::move(memory.grown->names);
  }
  { const Ground gone = std::move(ground); }
  write_labels(frame, names, result.label_of_name, result.map.labels, checkpoint);
  return result;
}

RegionsAndRoads segment_by_growth(const Ground& ground, const std::vector<CellIndex>& visited,
                                  const GrowingParams& params, const RegionRoadsRule& roads,
                                  GrowthMemory& memory, const GroundChange* change,
                                  const Checkpoint& checkpoint) {
  check(params, ground.frame());
  if (!change || !memory.grown) memory = {}, change = nullptr;
  memory.reused = 0;
  RegionsAndRoads result =
      grow_and_finish(ground, visited, params, roads, true, memory, change, checkpoint);
  result.map.labels.frame = ground.frame();
  result.map.labels.cells = memory.names->labelled(std::move(result.label_of_name));
  return result;
}

}  // namespace stope::topology
