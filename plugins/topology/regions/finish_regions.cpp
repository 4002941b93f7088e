#include "plugins/topology/regions/finish_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/regions/space_pieces.hpp"

namespace stope::topology {
namespace {

/// The cell of a region nearest to a point that has most of the region's best clearance, and
/// enough for a road if any has: a bend's centre lies beside it or at its wall, where no road can
/// start.
class NearestClearCell {
 public:
  NearestClearCell(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                   const RegionSet& set, std::int32_t region,
                   const std::vector<std::int32_t>& tiles, const RegionRoadsRule& rule)
      : ground_(ground),
        names_(names),
        set_(set),
        region_(region),
        least_(rule.least_distance(ground.frame().resolution)) {
    const TileSet geometry(ground.width(), ground.height());
    std::int32_t best = 0;
    for (const std::int32_t tile : tiles)
      geometry.for_each_row(tile, [&](CellIndex first, std::int32_t count) {
        for (CellIndex cell = first; cell < first + count; ++cell)
          if (ground.squared(cell) > best && is_own(cell)) best = ground.squared(cell);
      });
    wanted_ = std::max(share_of(best, rule.centre_share),
                       std::min(best, rule.least_squared(ground.frame().resolution)));
  }

  ShapePoint find(const ShapePoint& point, const RegionShape& shape) const {
    const auto column = static_cast<std::int32_t>(std::lround(point.x));
    const auto row = static_cast<std::int32_t>(std::lround(point.y));
    if (serves(column, row)) {
      // Beside a cell's centre the clearance is another.
      if (ground_.distance_at(point.x + 0.5, point.y + 0.5) >= least_) return point;
      return {static_cast<double>(column), static_cast<double>(row)};
    }
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
        if (off >= least || !serves(x, y)) continue;
        least = off;
        nearest = {static_cast<double>(x), static_cast<double>(y)};
      }
    }
    return nearest;
  }

 private:
  bool serves(std::int32_t column, std::int32_t row) const {
    if (column < 0 || row < 0 || column >= ground_.width() || row >= ground_.height()) return false;
    const CellIndex cell = ground_.index(column, row);
    return is_own(cell) && ground_.free(cell) && ground_.squared(cell) >= wanted_;
  }
  bool is_own(CellIndex cell) const {
    return set_.of(names_[cell]) == region_ && !set_.is_cut_off(names_[cell]);
  }
  const Ground& ground_;
  const PaddedGrid<std::int32_t>& names_;
  const RegionSet& set_;
  std::int32_t region_;
  double least_;             ///< distance from obstacles where roads can be
  std::int32_t wanted_ = 0;  ///< squared clearance
};

std::vector<std::size_t> order_of(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

std::vector<Region> measured(const GridFrame& frame, const std::vector<RegionMemo::Known>& known) {
  std::vector<Region> regions;
  for (const RegionMemo::Known& region : known) {
    const Vector2 place = frame.to_map(region.centre.x + 0.5, region.centre.y + 0.5);
    regions.push_back({0, place.x(), place.y(), region.axes.major * frame.resolution,
                       region.axes.minor * frame.resolution, region.axes.yaw + frame.origin.yaw,
                       static_cast<double>(region.cells) * frame.resolution * frame.resolution});
  }
  return regions;
}

/// Leaves out the parts of free space that are too small, all but the largest one.
void drop_small(RegionSet& set, const std::vector<Border>& borders,
                const std::vector<std::int64_t>& free_cells, double least_area,
                RegionsAndRoads& result) {
  DisjointSets pieces(free_cells.size());
  for (const Border& border : borders) pieces.join(border.a - 1, border.b - 1);
  std::vector<std::int64_t> area(free_cells.size(), 0);
  const auto piece_of = [&](std::size_t region) {
    return static_cast<std::size_t>(pieces.find(static_cast<std::int32_t>(region)));
  };
  for (std::size_t i = 0; i < area.size(); ++i) area[piece_of(i)] += free_cells[i];
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
  for (std::int32_t& region : set.of_name) region = number[static_cast<std::size_t>(region)];
  set.count = count;
}

/// What is known of the regions: from the memo if all about a region is the same, else measured.
std::vector<RegionMemo::Known> know(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                    const RegionSet& set, RegionParts& parts, RegionMemo& memo,
                                    const TileSet* changed, const RegionRoadsRule& rule,
                                    std::vector<std::uint8_t>& same, const Checkpoint& checkpoint) {
  std::vector<RegionMemo::Known> known(static_cast<std::size_t>(set.count));
  const std::int32_t reach = rule.reach(ground.frame().resolution);
  TileSet near(ground.width(), ground.height());
  if (changed)
    for (const std::int32_t tile : changed->list())
      changed->for_each_row(tile, [&](CellIndex first, std::int32_t count) {
        near.add(ground.column(first) - reach, ground.row(first) - reach,
                 ground.column(first) + count + reach, ground.row(first) + reach);
      });
  memo.reused = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto found = memo.regions.find(parts.members[i].front());
    same[i] = changed && found != memo.regions.end() && found->second.members == parts.members[i] &&
              found->second.cut_off == parts.cut_off[i] &&
              std::none_of(parts.tiles[i].begin(), parts.tiles[i].end(),
                           [&](std::int32_t tile) { return near.has(tile); });
    if (same[i]) {
      known[i] = std::move(found->second);
      ++memo.reused;
    } else {
      known[i].members = std::move(parts.members[i]);
      known[i].cut_off = std::move(parts.cut_off[i]);
    }
  }
  for_each_band(set.count, checkpoint, [&] {
    return [&](std::int32_t band) {
      const auto i = static_cast<std::size_t>(band);
      if (same[i]) return;
      const RegionShape shape = shape_of(ground, names, set, band + 1, parts.tiles[i]);
      known[i].cells = shape.cells;
      known[i].axes = shape.axes();
      known[i].centre = NearestClearCell(ground, names, set, band + 1, parts.tiles[i], rule)
                            .find(centre_of_gravity(shape.hull, shape.hull.front()), shape);
    };
  });
  return known;
}

/// Gives each region the id of its node, which the graph has in the order of x and y.
void identify(std::vector<Region>& regions, const RoadGraph& roads) {
  std::vector<std::size_t> order = order_of(regions.size());
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(regions[a].x, regions[a].y) < std::tie(regions[b].x, regions[b].y);
  });
  for (std::size_t i = 0; i < order.size(); ++i) regions[order[i]].id = roads.nodes[i].id;
}

void write_labels(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                  const std::vector<std::int32_t>& label_of_name, LabelGrid& labels,
                  const Checkpoint& checkpoint) {
  constexpr std::int32_t kBandRows = 64;
  labels.frame = ground.frame();
  labels.cells.resize(ground.frame().size());
  for_each_band((ground.height() + kBandRows - 1) / kBandRows, checkpoint, [&] {
    return [&](std::int32_t band) {
      for (std::int32_t row = band * kBandRows;
           row < std::min(ground.height(), (band + 1) * kBandRows); ++row) {
        const std::int32_t* from = names.padded_row(row) + 1;
        std::int32_t* to = labels.cells.data() + ground.frame().place({0, row});
        for (std::int32_t column = 0; column < ground.width(); ++column)
          to[column] = label_of_name[static_cast<std::size_t>(from[column])];
      }
    };
  });
}

void remember(std::vector<RegionMemo::Known> known, std::vector<RegionRoad> roads,
              const std::vector<Border>& borders, RegionMemo& memo) {
  const auto key = [&](std::int32_t region) {
    return known[static_cast<std::size_t>(region) - 1].members.front();
  };
  memo.roads.clear();
  for (std::size_t i = 0; i < borders.size(); ++i)
    memo.roads[std::minmax({key(borders[i].a), key(borders[i].b)})] = std::move(roads[i]);
  memo.regions.clear();
  for (RegionMemo::Known& region : known) {
    const CellIndex lowest = region.members.front();
    memo.regions[lowest] = std::move(region);
  }
}

}  // namespace

RegionsAndRoads finish_regions(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const TileParts& tiles, const std::vector<Contact>& contacts,
                               RegionSet set, double least_area, const RegionRoadsRule& rule,
                               const Checkpoint& checkpoint, RegionMemo* memo,
                               const TileSet* changed) {
  RegionsAndRoads result;
  RegionMemo fresh;
  RegionMemo& before = memo ? *memo : fresh;
  RegionParts parts = parts_of_regions(tiles, set);
  std::vector<Border> borders = find_borders(contacts, set);
  drop_small(set, borders, parts.free_cells, least_area, result);
  if (result.dropped > 0) {
    parts = parts_of_regions(tiles, set);
    borders = find_borders(contacts, set);
  }
  result.neighbours = borders.size();
  std::vector<std::uint8_t> same(static_cast<std::size_t>(set.count), 0);
  std::vector<RegionMemo::Known> known =
      know(ground, names, set, parts, before, changed, rule, same, checkpoint);
  std::vector<RegionRoad> roads =
      region_roads(ground, names, set, parts, borders, known, same, rule, before, checkpoint);
  result.roads = graph_of_roads(ground.frame(), known, borders, roads, rule);
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
  std::vector<std::int32_t> label_of_name;
  for (const std::int32_t region : set.of_name)
    label_of_name.push_back(label[static_cast<std::size_t>(region)]);
  write_labels(ground, names, label_of_name, result.map.labels, checkpoint);
  const std::int64_t covered =
      std::accumulate(parts.free_cells.begin(), parts.free_cells.end(), std::int64_t{0});
  result.covered = ground.free_cells() == 0
                       ? 0
                       : static_cast<double>(covered) / static_cast<double>(ground.free_cells());
  // Where every free cell has a region, the regions' pieces are those of free space.
  result.space_pieces = result.pieces > 1 && covered + result.dropped_cells <
                                                 static_cast<std::int64_t>(ground.free_cells())
                            ? count_space_pieces(ground, names, set, checkpoint)
                            : result.pieces;
  if (memo) remember(std::move(known), std::move(roads), borders, before);
  return result;
}

}  // namespace stope::topology
