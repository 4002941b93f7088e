// Problem: cover free space with regions, in an order that is fixed, does not depend on where in
// the map work is going on, and can be followed again after a change.
// Idea: points are tried by clearance; in the first round a point is taken only if a circle of its
// whole clearance is still without regions, in later rounds a smaller one. Each decision and each
// growth reads only cells near its point. So after a change, the old regions are followed in the
// same order: one that read no cell that differs is as it was, any other is grown again, and the
// cells of the old and of the new one differ from then on.
// Cost: the growth of the regions, and seventeen looks for each point and round.
#include "plugins/topology/regions/grow_regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace stope::topology {
namespace {

/// What share of its clearance a point must have for itself, by round.
constexpr std::array<double, 4> kOwnRoom{1.0, 0.6, 0.3, 0.0};
constexpr int kDirections = 16;
constexpr std::size_t kPointsBetweenCheckpoints = 4096;

class Growing {
 public:
  Growing(const Ground& ground, const GrowthRule& rule, EarlierGrowth* earlier)
      : open_(ground.width(), ground.height()), grower_(rule), earlier_(earlier) {
    for (std::size_t i = 0; i < open_.size(); ++i)
      open_.data()[i] = ground.free(static_cast<CellIndex>(i)) ? 1 : 0;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * 3.14159265358979323846 * i / kDirections;
      directions_[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
  }

  void grow_round(std::int32_t round, double own_room, const std::vector<GrowthPoint>& points,
                  const Checkpoint& checkpoint) {
    std::size_t tried = 0;
    for (const GrowthPoint& point : points) {
      if (tried++ % kPointsBetweenCheckpoints == 0) checkpoint();
      const double room = own_room * std::sqrt(static_cast<double>(point.squared));
      if (!earlier_) {
        if (has_room(point.cell, room)) keep({round, point, grower_.grow(open_, point.cell)});
      } else {
        grow_again(round, point, room);
      }
    }
  }

  std::vector<GrownRegion> take() { return std::move(regions_); }

 private:
  struct Direction {
    double x = 0, y = 0;
  };

  bool has_room(CellIndex cell, double room) const {
    if (!open_[cell]) return false;
    if (room < 1) return true;
    const std::int32_t column = open_.column(cell), row = open_.row(cell);
    for (const Direction& direction : directions_) {
      const auto x = column + static_cast<std::int32_t>(std::lround(0.95 * room * direction.x));
      const auto y = row + static_cast<std::int32_t>(std::lround(0.95 * room * direction.y));
      if (x < 0 || y < 0 || x >= open_.width() || y >= open_.height()) return false;
      if (!open_[open_.index(x, y)]) return false;
    }
    return true;
  }

  void keep(GrownRegion region) {
    for (const CellIndex cell : region.growth.cells) open_[cell] = 0;
    regions_.push_back(std::move(region));
  }

  void change(const GrownRegion& region) {
    for (const CellIndex cell : region.growth.cells)
      earlier_->changed.add(open_.column(cell), open_.row(cell));
  }

  bool changed_near(CellIndex cell, std::int32_t reach) {
    return earlier_->changed.touch(open_.column(cell), open_.row(cell), reach);
  }

  void grow_again(std::int32_t round, const GrowthPoint& point, double room) {
    const auto before = [&](const GrownRegion& old) {
      return old.round != round ? old.round < round : tried_before(old.point, point);
    };
    auto& old = earlier_->regions;
    while (next_ < old.size() && before(old[next_])) change(old[next_++]);
    const bool was = next_ < old.size() && old[next_].round == round && old[next_].point == point;
    if (!changed_near(point.cell, static_cast<std::int32_t>(room) + 1)) {
      if (!was) return;
      if (!changed_near(point.cell, old[next_].growth.scanned)) {
        keep(std::move(old[next_++]));
        ++earlier_->reused;
        return;
      }
    }
    const bool taken = has_room(point.cell, room);
    if (taken) {
      GrownRegion region{round, point, grower_.grow(open_, point.cell)};
      const bool same = was && old[next_].growth.cells == region.growth.cells;
      if (!same) change(region);
      if (was && !same) change(old[next_]);
      keep(std::move(region));
    } else if (was) {
      change(old[next_]);
    }
    if (was) ++next_;
  }

  PaddedGrid<std::uint8_t> open_;
  RegionGrower grower_;
  EarlierGrowth* earlier_;
  std::array<Direction, kDirections> directions_{};
  std::vector<GrownRegion> regions_;
  std::size_t next_ = 0;  ///< of the earlier regions
};

}  // namespace

std::vector<GrownRegion> grow_regions(const Ground& ground,
                                      const std::vector<std::vector<GrowthPoint>>& groups,
                                      const GrowthRule& rule, const Checkpoint& checkpoint,
                                      EarlierGrowth* earlier) {
  Growing growing(ground, rule, earlier);
  std::int32_t round = 0;
  for (const auto& points : groups)
    for (const double own_room : kOwnRoom)
      growing.grow_round(round++, own_room, points, checkpoint);
  return growing.take();
}

}  // namespace stope::topology
