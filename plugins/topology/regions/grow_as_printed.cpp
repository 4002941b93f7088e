#include "plugins/topology/regions/grow_as_printed.hpp"

#include <algorithm>

namespace stope::topology {
namespace {

void take_cells(const Ground& ground, const std::vector<CellRun>& runs, std::int32_t region,
                RegionCells& regions, PaddedGrid<std::uint8_t>& open, std::size_t& covered) {
  for (const CellRun& run : runs) {
    for (CellIndex cell = run.first; cell < run.end(); ++cell) {
      if (regions[cell] != 0) continue;
      regions[cell] = region;
      open[cell] = 0;
      covered += ground.free(cell) ? 1 : 0;
    }
  }
}

}  // namespace

RegionCells grow_as_printed(const Ground& ground, std::vector<CellIndex> points,
                            const GrowthRule& rule, double coverage, double second_radius,
                            Random random, const Checkpoint& checkpoint, std::int32_t& count) {
  RegionCells regions = without_regions(ground);
  PaddedGrid<std::uint8_t> open(ground.width(), ground.height());
  for (std::size_t i = 0; i < open.size(); ++i)
    open.data()[i] = ground.free(static_cast<CellIndex>(i)) ? 1 : 0;
  const double wanted = coverage * static_cast<double>(ground.free_cells());
  std::size_t covered = 0;
  std::vector<CellIndex> centres;
  RegionGrower grower(rule);
  for (std::size_t left = points.size(); left > 0 && static_cast<double>(covered) < wanted;) {
    const auto drawn = static_cast<std::size_t>(random.below(left));
    std::swap(points[drawn], points[--left]);
    const CellIndex from = points[left];
    if (!open[from]) continue;
    checkpoint();
    centres.push_back(from);
    take_cells(ground, grower.grow(open, from).runs, static_cast<std::int32_t>(centres.size()),
               regions, open, covered);
  }
  GrowthRule second = rule;
  second.growth_radius = std::min(rule.growth_radius, second_radius);
  second.max_radius = second_radius;
  second.as_printed = false;  // bounded, or one region would take what is left of the map
  RegionGrower again(second);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    checkpoint();
    const auto region = static_cast<std::int32_t>(i) + 1;
    // Its own cells are no obstacle to a region that grows again.
    const std::vector<CellIndex> own = [&] {
      std::vector<CellIndex> cells;
      const auto reach = static_cast<std::int32_t>(second_radius) + 1;
      const std::int32_t column = ground.column(centres[i]), row = ground.row(centres[i]);
      for (std::int32_t y = std::max(row - reach, 0);
           y <= std::min(row + reach, ground.height() - 1); ++y)
        for (std::int32_t x = std::max(column - reach, 0);
             x <= std::min(column + reach, ground.width() - 1); ++x) {
          const CellIndex cell = ground.index(x, y);
          if (regions[cell] == region && ground.free(cell)) cells.push_back(cell);
        }
      return cells;
    }();
    for (const CellIndex cell : own) open[cell] = 1;
    const Growth grown = again.grow(open, centres[i]);
    for (const CellIndex cell : own) open[cell] = 0;
    take_cells(ground, grown.runs, region, regions, open, covered);
  }
  count = static_cast<std::int32_t>(centres.size());
  return regions;
}

}  // namespace stope::topology
