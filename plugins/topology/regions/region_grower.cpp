// Problem: grow a region from a point, ring by ring, into cells that are open and seen from the
// point, while the region stays about convex.
// Idea (Wang et al. 2019, Algorithm 1): a cell of the next ring qualifies if the Bresenham ray to
// it is open, and is kept if the hull with it holds few enough unqualified cells; the region is
// done when a ring adds too small a share of itself. As long as every ring is open throughout, no
// ray and no hull is needed; from then on rays are walked from where the open disc ends, and a cell
// adds to the hull one triangle, which is the only place where unqualified cells are counted.
// Cost: a look at each cell of the disc, the part of its ray outside of the open disc, and the
// triangles, which are a few cells each.
#include "plugins/topology/regions/region_grower.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "plugins/topology/regions/visit_convex.hpp"

namespace stope::topology {

struct RegionGrower::Site {
  const PaddedGrid<std::uint8_t>& cells;
  CellIndex from;
  std::int32_t column, row;

  bool holds(std::int32_t dx, std::int32_t dy) const {
    return column + dx >= 0 && column + dx < cells.width() && row + dy >= 0 &&
           row + dy < cells.height();
  }
  CellIndex at(std::int32_t dx, std::int32_t dy) const { return from + dy * cells.stride() + dx; }
  bool open(std::int32_t dx, std::int32_t dy) const { return holds(dx, dy) && cells[at(dx, dy)]; }
};

Growth RegionGrower::grow(const PaddedGrid<std::uint8_t>& open, CellIndex from) {
  const Site site{open, from, open.column(from), open.row(from)};
  const double bound = std::min<double>(
      RingTable::kMostRings,
      rule_.as_printed ? std::hypot(open.width(), open.height()) : rule_.max_radius);
  Growth growth;
  growth.cells.push_back(from);
  clear_ = 0;
  failed_in_hull_ = 0;
  bool clear = true;
  double radius = std::min(rule_.growth_radius, bound);
  for (std::int32_t r = 1; rule_.as_printed ? r < radius : r <= radius; ++r) {
    const auto ring = rings_.ring(r);
    growth.scanned = r;
    std::size_t qualified = 0;
    if (clear && ring_is_open(site, r)) {
      clear_ = r;
      qualified = ring.size();
      for (const CellOffset& cell : ring) growth.cells.push_back(site.at(cell.dx, cell.dy));
    } else {
      if (clear) {
        std::vector<HullPoint> rim;
        for (const CellOffset& cell : rings_.ring(clear_)) rim.push_back({cell.dx, cell.dy});
        hull_.start(rim);
      }
      clear = false;
      qualified = scan_ring(site, r, growth);
    }
    if (static_cast<double>(qualified) < rule_.addition_ratio * static_cast<double>(ring.size()))
      break;
    const double pass_ratio =
        static_cast<double>(growth.cells.size()) / static_cast<double>(rings_.cells_within(r));
    radius = std::min(bound, radius + rule_.radius_weight * pass_ratio * radius);
  }
  if (!clear) {
    if (!rule_.as_printed) keep_connected(site, growth);
    forget_marks(growth.scanned);
  }
  return growth;
}

bool RegionGrower::ring_is_open(const Site& site, std::int32_t radius) {
  for (const CellOffset& cell : rings_.ring(radius))
    if (!site.open(cell.dx, cell.dy)) return false;
  return true;
}

/// Bresenham's line (1965) from the growth point; its start within the open disc is left out.
bool RegionGrower::ray_is_open(const Site& site, const CellOffset& to) const {
  const std::int32_t ax = std::abs(to.dx), ay = std::abs(to.dy);
  const std::int32_t steps = std::max(ax, ay), minor = std::min(ax, ay);
  const double length = std::sqrt(static_cast<double>(ax) * ax + static_cast<double>(ay) * ay);
  std::int32_t step =
      std::max(1, static_cast<std::int32_t>((clear_ - 1) * static_cast<double>(steps) / length));
  const CellIndex sx = to.dx < 0 ? -1 : 1, sy = (to.dy < 0 ? -1 : 1) * site.cells.stride();
  const CellIndex along = ax >= ay ? sx : sy, aside = ax >= ay ? sy : sx;
  // Cell of a step: the minor coordinate is step * minor / steps, halves rounded up.
  std::int32_t sum = 2 * step * minor + steps;
  std::int32_t off = sum / (2 * steps);
  sum -= off * 2 * steps;
  CellIndex cell = site.from + step * along + off * aside;
  for (; step < steps; ++step) {
    if (!site.cells[cell]) return false;
    cell += along;
    sum += 2 * minor;
    if (sum >= 2 * steps) {
      sum -= 2 * steps;
      cell += aside;
    }
  }
  return true;
}

std::size_t RegionGrower::scan_ring(const Site& site, std::int32_t radius, Growth& growth) {
  prepare_marks(radius);
  const auto ring = rings_.ring(radius);
  std::size_t qualified = 0;
  for (const CellOffset& cell : ring) {
    if (!site.open(cell.dx, cell.dy) || !ray_is_open(site, cell)) {
      fail(cell);
      continue;
    }
    if (!fits_hull(cell, growth.cells.size() + 1)) {
      fail(cell);
      continue;
    }
    mark(cell.dx, cell.dy) |= kQualified;
    ++qualified;
    if (!rule_.as_printed) growth.cells.push_back(site.at(cell.dx, cell.dy));
  }
  if (rule_.as_printed) {  // line 20 adds the ring, not the points of it that qualify
    for (const CellOffset& cell : ring)
      if (site.holds(cell.dx, cell.dy)) growth.cells.push_back(site.at(cell.dx, cell.dy));
  }
  return qualified;
}

void RegionGrower::fail(const CellOffset& cell) {
  std::uint8_t& state = mark(cell.dx, cell.dy);
  state |= kFailed;
  if (state & kInHull) ++failed_in_hull_;
}

/// Whether the hull may take the cell in; if so it has.
bool RegionGrower::fits_hull(const CellOffset& cell, std::size_t qualified) {
  if (mark(cell.dx, cell.dy) & kInHull) return true;
  GrowingHull::Addition addition;
  const HullPoint point{cell.dx, cell.dy};
  if (!hull_.see(point, addition)) return true;
  std::size_t failed = failed_in_hull_;
  visit_convex(addition.triangle, [&](std::int32_t y, std::int32_t first, std::int32_t last) {
    const std::uint8_t* state = &mark(first, y);
    for (std::int32_t x = first; x <= last; ++x, ++state)
      failed += (*state & (kFailed | kInHull)) == kFailed ? 1 : 0;
  });
  // The paper's Algorithm 1 compares with r_a here where its text means r_o.
  const double most = rule_.as_printed ? rule_.addition_ratio : rule_.obstacle_ratio;
  if (static_cast<double>(failed) > most * static_cast<double>(qualified)) return false;
  failed_in_hull_ = failed;
  visit_convex(addition.triangle, [&](std::int32_t y, std::int32_t first, std::int32_t last) {
    std::uint8_t* state = &mark(first, y);
    for (std::int32_t x = first; x <= last; ++x, ++state) *state |= kInHull;
  });
  hull_.add(point, addition);
  return true;
}

/// Cells whose ray is open can still be cut off, where the hull refused what lies between.
void RegionGrower::keep_connected(const Site& site, Growth& growth) {
  constexpr std::uint8_t kReached = 8;
  for (std::int32_t r = 0; r <= clear_; ++r)
    for (const CellOffset& cell : rings_.ring(r)) mark(cell.dx, cell.dy) |= kQualified;
  std::vector<HullPoint> open{{0, 0}};
  mark(0, 0) |= kReached;
  while (!open.empty()) {
    const HullPoint at = open.back();
    open.pop_back();
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const HullPoint next{at.x + dx, at.y + dy};
        if (std::max(std::abs(next.x), std::abs(next.y)) > growth.scanned) continue;
        std::uint8_t& state = mark(next.x, next.y);
        if ((state & (kQualified | kReached)) != kQualified) continue;
        state |= kReached;
        open.push_back(next);
      }
    }
  }
  std::erase_if(growth.cells, [&](CellIndex cell) {
    const std::int32_t dy = site.cells.row(cell) - site.row;
    const std::int32_t dx = site.cells.column(cell) - site.column;
    return !(mark(dx, dy) & kReached);
  });
}

void RegionGrower::prepare_marks(std::int32_t radius) {
  if (radius <= reach_) return;
  const std::int32_t old = reach_;
  const std::vector<std::uint8_t> kept = std::move(marks_);
  reach_ = std::max(2 * old, radius + 8);
  const auto side = static_cast<std::size_t>(2 * reach_ + 1);
  marks_.assign(side * side, 0);
  if (kept.empty()) return;
  for (std::int32_t dy = -old; dy <= old; ++dy)
    std::copy_n(kept.data() + static_cast<std::size_t>((dy + old) * (2 * old + 1)), 2 * old + 1,
                &mark(-old, dy));
}

void RegionGrower::forget_marks(std::int32_t radius) {
  for (std::int32_t dy = -radius; dy <= radius; ++dy)
    std::fill_n(&mark(-radius, dy), 2 * radius + 1, std::uint8_t{0});
}

}  // namespace stope::topology
