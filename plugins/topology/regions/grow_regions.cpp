// Problem: cover free space with regions, in an order that is fixed, does not depend on where in
// the map work is going on, and can be followed again after a change (regrow_regions.cpp).
// Idea: points are tried by clearance; in the first round a point is taken only if a circle of its
// whole clearance is still without regions, in later rounds a smaller one. Each decision and each
// growth reads only cells near its point.
// Cost: the growth of the regions, and seventeen looks for each point and round.
#include "plugins/topology/regions/grow_regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kBandRows = 64;
constexpr std::size_t kPointsBetweenCheckpoints = 4096;

}  // namespace

GrownRegions::GrownRegions(const Ground& ground, const GrowthRule& rule,
                           const Checkpoint& checkpoint)
    : names(ground.width(), ground.height()), open(ground.width(), ground.height()), grower(rule) {
  const std::int32_t rows = ground.height() + 2;  // with the margin
  for_each_band((rows + kBandRows - 1) / kBandRows, checkpoint, [&] {
    return [&](std::int32_t band) {
      const CellIndex begin = band * kBandRows * ground.stride();
      const CellIndex end = std::min(rows, (band + 1) * kBandRows) * ground.stride();
      std::fill(names.data() + begin, names.data() + end, 0);
      for (CellIndex cell = begin; cell < end; ++cell) open[cell] = ground.free(cell) ? 1 : 0;
    };
  });
}

RoomToGrow::RoomToGrow() {
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const double angle = 2 * 3.14159265358979323846 * static_cast<double>(i) /
                         static_cast<double>(directions_.size());
    directions_[i] = {std::cos(angle), std::sin(angle)};
  }
}

bool RoomToGrow::operator()(const PaddedGrid<std::uint8_t>& open, CellIndex cell,
                            double room) const {
  if (!open[cell]) return false;
  if (room < 1) return true;
  const std::int32_t column = open.column(cell), row = open.row(cell);
  for (const Direction& direction : directions_) {
    const auto x = column + static_cast<std::int32_t>(std::lround(0.95 * room * direction.x));
    const auto y = row + static_cast<std::int32_t>(std::lround(0.95 * room * direction.y));
    if (x < 0 || y < 0 || x >= open.width() || y >= open.height()) return false;
    if (!open[open.index(x, y)]) return false;
  }
  return true;
}

GrownRegions grow_regions(const Ground& ground, const std::vector<std::vector<GrowthPoint>>& groups,
                          const GrowthRule& rule, bool keep_cells, const Checkpoint& checkpoint) {
  GrownRegions grown(ground, rule, checkpoint);
  const RoomToGrow has_room;
  std::int32_t round = 0;
  std::size_t tried = 0;
  for (const auto& points : groups) {
    for (const double own_room : kOwnRoom) {
      for (const GrowthPoint& point : points) {
        if (tried++ % kPointsBetweenCheckpoints == 0) checkpoint();
        const double room = own_room * std::sqrt(static_cast<double>(point.squared));
        if (!has_room(grown.open, point.cell, room)) continue;
        GrownRegion region{++grown.names_given, round, point,
                           grown.grower.grow(grown.open, point.cell)};
        for (const CellRun& run : region.growth.runs) {
          std::fill_n(grown.open.data() + run.first, run.count, std::uint8_t{0});
          std::fill_n(grown.names.data() + run.first, run.count, region.name);
        }
        if (!keep_cells) region.growth.runs = {};
        grown.list.push_back(std::move(region));
      }
      ++round;
    }
  }
  return grown;
}

}  // namespace stope::topology
