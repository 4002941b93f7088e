#include "plugins/topology/regions/region_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stope::topology {
namespace {

/// The cell of a region nearest to a point that has most of the region's best clearance, and
/// enough for a road if any has: a bend's centre lies beside it or at its wall, where no road can
/// start.
class NearestClearCell {
 public:
  NearestClearCell(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                   const TileParts& tiles, const RegionSet& set, std::int32_t region,
                   const std::vector<std::int32_t>& own_tiles, const RegionRoadsRule& rule)
      : ground_(ground),
        names_(names),
        set_(set),
        region_(region),
        least_(rule.least_distance(ground.frame().resolution)) {
    for (const std::int32_t tile : own_tiles)
      for (const TilePart& part : tiles.parts(static_cast<std::size_t>(tile)))
        if (set.of(part.name) == region && !set.is_cut_off(part.name))
          widest_ = std::max(widest_, part.widest);
    wanted_ = std::max(share_of(widest_, rule.centre_share),
                       std::min(widest_, rule.least_squared(ground.frame().resolution)));
  }

  std::int32_t widest() const { return widest_; }

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
  double least_;                          ///< distance from obstacles where roads can be
  std::int32_t widest_ = 0, wanted_ = 0;  ///< squared clearance
};

}  // namespace

RegionCentre centre_of_region(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                              const TileParts& tiles, const RegionSet& set, std::int32_t region,
                              const std::vector<std::int32_t>& own_tiles, const RegionShape& shape,
                              const RegionRoadsRule& rule) {
  const NearestClearCell nearest(ground, names, tiles, set, region, own_tiles, rule);
  return {nearest.find(centre_of_gravity(shape.hull, shape.hull.front()), shape), nearest.widest()};
}

}  // namespace stope::topology
