#include "plugins/topology/regions/finish_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

/// The cell of a region nearest to a point that has at least half the region's best clearance: a
/// bend's centre lies beside it or at its wall, where no road can start.
class NearestClearCell {
 public:
  NearestClearCell(const Ground& ground, const RegionCells& regions, std::int32_t count)
      : ground_(ground), regions_(regions), best_(static_cast<std::size_t>(count) + 1, 0) {
    for (std::size_t i = 0; i < regions.size(); ++i) {
      const auto cell = static_cast<CellIndex>(i);
      auto& best = best_[static_cast<std::size_t>(regions[cell])];
      best = std::max(best, ground.squared(cell));
    }
  }

  ShapePoint find(const ShapePoint& point, std::int32_t region, const RegionShape& shape) const {
    const auto column = static_cast<std::int32_t>(std::lround(point.x));
    const auto row = static_cast<std::int32_t>(std::lround(point.y));
    if (serves(column, row, region)) return point;
    std::int32_t left = shape.hull.front().x, right = left, bottom = shape.hull.front().y,
                 top = bottom;
    for (const HullPoint& corner : shape.hull) {
      left = std::min(left, corner.x);
      right = std::max(right, corner.x);
      bottom = std::min(bottom, corner.y);
      top = std::max(top, corner.y);
    }
    ShapePoint nearest{point};
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t y = bottom; y <= top; ++y) {
      for (std::int32_t x = left; x <= right; ++x) {
        const double off = (x - point.x) * (x - point.x) + (y - point.y) * (y - point.y);
        if (off >= least || !serves(x, y, region)) continue;
        least = off;
        nearest = {static_cast<double>(x), static_cast<double>(y)};
      }
    }
    return nearest;
  }

 private:
  bool serves(std::int32_t column, std::int32_t row, std::int32_t region) const {
    if (column < 0 || row < 0 || column >= ground_.width() || row >= ground_.height()) return false;
    const CellIndex cell = ground_.index(column, row);
    return regions_[cell] == region && ground_.free(cell) &&
           ground_.squared(cell) >= best_[static_cast<std::size_t>(region)] / 4;
  }
  const Ground& ground_;
  const RegionCells& regions_;
  std::vector<std::int32_t> best_;  ///< by region: its largest squared clearance
};

std::vector<std::size_t> order_of(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<Region> measured(const Ground& ground, const std::vector<RegionShape>& shapes,
                             const std::vector<ShapePoint>& centres) {
  const GridFrame& frame = ground.frame();
  std::vector<Region> regions;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Vector2 place = frame.to_map(centres[i].x + 0.5, centres[i].y + 0.5);
    const Axes axes = shapes[i].axes();
    regions.push_back({0, place.x(), place.y(), axes.major * frame.resolution,
                       axes.minor * frame.resolution, axes.yaw + frame.origin.yaw,
                       static_cast<double>(shapes[i].cells) * frame.resolution * frame.resolution});
  }
  return regions;
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

RegionsAndRoads finish_regions(const Ground& ground, const RegionCells& cells, std::int32_t count,
                               const RegionRoadsRule& rule, const Checkpoint& checkpoint) {
  const std::vector<RegionShape> shapes = shapes_of(ground, cells, count, checkpoint);
  const std::vector<Border> borders = find_borders(ground, cells, checkpoint);
  const NearestClearCell nearest(ground, cells, count);
  std::vector<ShapePoint> centres;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    centres.push_back(nearest.find(centre_of_gravity(shapes[i].hull, shapes[i].hull.front()),
                                   static_cast<std::int32_t>(i) + 1, shapes[i]));
  RegionsAndRoads result;
  result.roads = region_roads(ground, cells, centres, borders, rule, checkpoint);
  result.neighbours = borders.size();
  std::vector<Region> regions = measured(ground, shapes, centres);
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
    if (pieces.join(border.first - 1, border.second - 1)) --result.pieces;
    const auto a = static_cast<std::uint32_t>(label[static_cast<std::size_t>(border.first)] - 1);
    const auto b = static_cast<std::uint32_t>(label[static_cast<std::size_t>(border.second)] - 1);
    pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [a, b] : pairs) {
    result.map.adjacency.push_back(a);
    result.map.adjacency.push_back(b);
  }
  result.map.labels.frame = ground.frame();
  result.map.labels.cells.reserve(ground.frame().size());
  std::size_t covered = 0;
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      const CellIndex cell = ground.index(column, row);
      covered += cells[cell] != 0 && ground.free(cell) ? 1 : 0;
      result.map.labels.cells.push_back(label[static_cast<std::size_t>(cells[cell])]);
    }
  }
  result.covered = ground.free_cells() == 0
                       ? 0
                       : static_cast<double>(covered) / static_cast<double>(ground.free_cells());
  return result;
}

}  // namespace stope::topology
