#include "plugins/topology/regions/segment_by_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Where this ground differs from an earlier one for regions of at most `radius`.
ChangedTiles difference(const Ground& now, const Ground& before, double radius) {
  ChangedTiles changed(now.width(), now.height());
  const auto bound = static_cast<std::int32_t>(std::min(radius * radius + 1, 1e9));
  for (std::int32_t row = 0; row < now.height(); ++row) {
    for (std::int32_t column = 0; column < now.width(); ++column) {
      const CellIndex cell = now.index(column, row);
      if (std::min(bound, now.squared(cell)) != std::min(bound, before.squared(cell)))
        changed.add(column, row, 2);
    }
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
                              GrowthMemory* memory) {
  const std::vector<std::vector<GrowthPoint>> groups{
      points_at(ground, visited, rule.max_radius),
      middle_points(ground, rule.max_radius, checkpoint)};
  if (memory) memory->reused = 0;
  if (!memory || !memory->ground || memory->visited != visited ||
      !(memory->ground->frame() == ground.frame()))
    return grow_regions(ground, groups, rule, checkpoint);
  EarlierGrowth earlier{std::move(memory->regions),
                        difference(ground, *memory->ground, rule.max_radius)};
  memory->ground.reset();  // a memory half used is none
  auto grown = grow_regions(ground, groups, rule, checkpoint, &earlier);
  memory->reused = earlier.reused;
  return grown;
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

RegionsAndRoads segment_by_growth(std::unique_ptr<Ground> ground, std::vector<CellIndex> visited,
                                  const GrowingParams& params, const RegionRoadsRule& roads,
                                  Random random, const Checkpoint& checkpoint,
                                  GrowthMemory* memory) {
  const GridFrame& frame = ground->frame();
  check(params, frame);
  const GrowthRule rule = growth_rule(params, frame);
  RegionRoadsRule roads_rule = roads;
  RegionCells regions = without_regions(*ground);
  std::vector<GrownRegion> grown;
  std::int32_t count = 0;
  if (params.as_printed) {
    std::sort(visited.begin(), visited.end());
    visited.erase(std::unique(visited.begin(), visited.end()), visited.end());
    regions = grow_as_printed(*ground, visited.empty() ? free_cells(*ground) : visited, rule,
                              params.coverage, params.second_radius / frame.resolution, random,
                              checkpoint, count);
    roads_rule.network = Network::kSpanningTree;
  } else {
    grown = grow(*ground, visited, rule, checkpoint, memory);
    regions = cells_of(*ground, grown);
    count = static_cast<std::int32_t>(grown.size());
    const double reach = std::min(1e9, params.second_radius / frame.resolution);
    absorb_rest(*ground, regions, static_cast<std::int32_t>(reach), checkpoint);
  }
  count = merge_regions(*ground, regions, count, merge_rule(params, frame), checkpoint);
  RegionsAndRoads result = finish_regions(*ground, regions, count, roads_rule, checkpoint);
  if (memory && !params.as_printed)
    *memory = {std::move(ground), std::move(visited), std::move(grown), memory->reused};
  return result;
}

}  // namespace stope::topology
