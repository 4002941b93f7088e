// Problem: divide free space into rooms where it is narrow.
// Idea: the doors of the Voronoi diagram are the saddles of the clearance. Cells are flooded from
// the clearest down; a cell without a flooded neighbour starts a basin, and a cell where two basins
// meet is the saddle between them. They become one unless the saddle is a door: clearly narrower
// than both. From a saddle the border falls along the shortest ways to both walls, which is the
// critical line that Thrun (1998) cuts at.
// Cost: a radix sort of the free cells by clearance, and one look at each one's neighbours.
#include "plugins/topology/regions/clearance_basins.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/regions/borders.hpp"

namespace stope::topology {
namespace {

/// Free cells, the clearest first, equal ones by index.
std::vector<CellIndex> clearest_first(const Ground& ground, const Checkpoint& checkpoint) {
  constexpr std::int32_t kBits = 11, kBuckets = 1 << kBits;
  std::vector<CellIndex> cells;
  cells.reserve(ground.free_cells());
  std::int32_t most = 0;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    const auto cell = static_cast<CellIndex>(i);
    if (!ground.free(cell)) continue;
    cells.push_back(cell);
    most = std::max(most, ground.squared(cell));
  }
  std::vector<CellIndex> sorted(cells.size());
  for (std::int32_t shift = 0; shift < 31 && (most >> shift) > 0; shift += kBits) {
    checkpoint();
    const auto bucket = [&](CellIndex cell) {
      const std::int32_t part = (ground.squared(cell) >> shift) & (kBuckets - 1);
      return static_cast<std::size_t>(kBuckets - 1 - part);
    };
    std::vector<std::size_t> begin(kBuckets + 1, 0);
    for (const CellIndex cell : cells) ++begin[bucket(cell) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (const CellIndex cell : cells) sorted[begin[bucket(cell)]++] = cell;
    std::swap(cells, sorted);
  }
  return cells;
}

/// Basins while they are flooded: sets that remember the clearance of their clearest cell.
class Basins {
 public:
  std::int32_t start(std::int32_t squared) {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    peak_.push_back(squared);
    return parent_.back();
  }
  std::int32_t find(std::int32_t basin) {
    while (parent_[at(basin)] != basin) {
      parent_[at(basin)] = parent_[at(parent_[at(basin)])];
      basin = parent_[at(basin)];
    }
    return basin;
  }
  std::int32_t peak(std::int32_t root) const { return peak_[at(root)]; }
  void join(std::int32_t a, std::int32_t b) {
    const std::int32_t low = std::min(a, b), high = std::max(a, b);  // the older is the clearer
    parent_[at(high)] = low;
    peak_[at(low)] = std::max(peak_[at(low)], peak_[at(high)]);
  }
  std::size_t size() const { return parent_.size(); }

 private:
  static std::size_t at(std::int32_t basin) { return static_cast<std::size_t>(basin); }
  std::vector<std::int32_t> parent_, peak_;
};

/// Half the free width where the clearance is as given: to the obstacle's edge, not its centre.
double half_width(std::int32_t squared) { return std::sqrt(static_cast<double>(squared)) - 0.5; }

/// Regions too small to be rooms join the neighbour they are most open to.
void join_small(const Ground& ground, const RegionCells& regions, double least_area,
                std::vector<std::int32_t>& now, const Checkpoint& checkpoint) {
  std::vector<std::int64_t> area(now.size(), 0);
  for (std::size_t i = 0; i < regions.size(); ++i)
    ++area[static_cast<std::size_t>(regions.data()[i])];
  std::vector<Border> borders = find_borders(ground, regions, checkpoint);
  std::vector<std::map<std::int32_t, std::int64_t>> open(now.size());
  for (const Border& border : borders) {
    open[static_cast<std::size_t>(border.first)][border.second] = border.steps;
    open[static_cast<std::size_t>(border.second)][border.first] = border.steps;
  }
  std::vector<std::pair<std::int64_t, std::int32_t>> order;
  for (std::size_t i = 1; i < now.size(); ++i)
    if (static_cast<double>(area[i]) < least_area)
      order.emplace_back(area[i], static_cast<std::int32_t>(i));
  std::sort(order.begin(), order.end());
  const auto find = [&](std::int32_t region) {
    while (now[static_cast<std::size_t>(region)] != region)
      region = now[static_cast<std::size_t>(region)];
    return region;
  };
  for (const auto& [cells, region] : order) {
    const auto own = static_cast<std::size_t>(region);
    if (find(region) != region || static_cast<double>(area[own]) >= least_area) continue;
    std::int32_t target = 0;
    std::int64_t widest = 0;
    for (const auto& [other, steps] : open[own])
      if (steps > widest) target = other, widest = steps;
    if (target == 0) continue;
    const auto to = static_cast<std::size_t>(target);
    now[own] = target;
    area[to] += area[own];
    for (const auto& [other, steps] : open[own]) {
      const auto there = static_cast<std::size_t>(other);
      open[there].erase(region);
      if (other == target) continue;
      open[to][other] += steps;
      open[there][target] += steps;
    }
    open[own].clear();
  }
  for (std::size_t i = 1; i < now.size(); ++i) now[i] = find(static_cast<std::int32_t>(i));
}

}  // namespace

RegionCells divide_at_doors(const Ground& ground, const DoorRule& rule, std::int32_t& count,
                            const Checkpoint& checkpoint) {
  constexpr std::size_t kCellsBetweenCheckpoints = 1 << 20;
  const std::vector<CellIndex> order = clearest_first(ground, checkpoint);
  const auto steps = neighbour_steps(ground.stride());
  RegionCells regions = without_regions(ground);  // basin + 1
  Basins basins;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % kCellsBetweenCheckpoints == 0) checkpoint();
    const CellIndex cell = order[i];
    const std::int32_t squared = ground.squared(cell);
    std::int32_t best = -1, steepest = -1;
    std::array<std::int32_t, 8> roots{};
    std::size_t met = 0;
    for (const CellIndex step : steps) {
      const std::int32_t there = regions[cell + step];
      if (there == 0) continue;
      const std::int32_t root = basins.find(there - 1);
      const std::int32_t clearance = ground.squared(cell + step);
      if (clearance > steepest) steepest = clearance, best = root;
      if (std::find(roots.begin(), roots.begin() + static_cast<std::ptrdiff_t>(met), root) ==
          roots.begin() + static_cast<std::ptrdiff_t>(met))
        roots[met++] = root;
    }
    if (met == 0) best = basins.start(squared);
    for (std::size_t k = 0; k < met; ++k) {
      const std::int32_t own = basins.find(best), other = basins.find(roots[k]);
      if (own == other) continue;
      const double first = half_width(basins.peak(own)), second = half_width(basins.peak(other));
      const double saddle = half_width(squared);
      const bool door = saddle <= rule.door_ratio * std::min(first, second) &&
                        saddle <= rule.similar_ratio * std::sqrt(first * second);
      if (!door) basins.join(own, other);
    }
    regions[cell] = basins.find(best) + 1;
  }
  std::vector<std::int32_t> now(basins.size() + 1);
  for (std::size_t i = 1; i < now.size(); ++i)
    now[i] = basins.find(static_cast<std::int32_t>(i) - 1) + 1;
  for (std::size_t i = 0; i < regions.size(); ++i)
    regions.data()[i] = now[static_cast<std::size_t>(regions.data()[i])];
  for (std::size_t i = 0; i < now.size(); ++i) now[i] = static_cast<std::int32_t>(i);
  join_small(ground, regions, rule.least_area, now, checkpoint);
  std::vector<std::int32_t> number(now.size(), 0);
  count = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::int32_t& region = regions.data()[i];
    region = now[static_cast<std::size_t>(region)];
    if (region == 0) continue;
    std::int32_t& place = number[static_cast<std::size_t>(region)];
    if (place == 0) place = ++count;
    region = place;
  }
  return regions;
}

}  // namespace stope::topology
