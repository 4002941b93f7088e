// Problem: grow a region from a point, ring by ring, into cells that are open and seen from the
// point, while the region stays about convex.
// Idea (Wang et al. 2019, Algorithm 1): a cell of the next ring qualifies if the Bresenham ray to
// it is open, and is kept if the hull with it holds few enough unqualified cells; the region is
// done when a ring adds too small a share of itself. As long as every ring is open throughout, no
// ray and no hull is needed. From then on the slopes are kept of the rays that cells of earlier
// rings block, so no ray is walked (blocked_slopes.cpp), and what a cell beside the hull would
// bring in is mostly itself alone (growing_hull.cpp).
// Cost: a look at each cell of the disc outside of its open part, and a copy of the square around.
#include "plugins/topology/regions/region_grower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stope::topology {
namespace {

/// The steps along and aside of the octants, in the order of their angle. Every other one is
/// scanned from its diagonal to its axis, which both are its neighbours'.
struct Octant {
  std::int32_t along_x, along_y, aside_x, aside_y;
};
constexpr std::array<Octant, BlockedSlopes::kOctants> kOctants{{{1, 0, 0, 1},
                                                                {0, 1, 1, 0},
                                                                {0, 1, -1, 0},
                                                                {-1, 0, 0, 1},
                                                                {-1, 0, 0, -1},
                                                                {0, -1, -1, 0},
                                                                {0, -1, 1, 0},
                                                                {1, 0, 0, -1}}};

constexpr std::uint32_t kDirectionShift = kSlopeBits - 8, kDirections = 1 << 8;  ///< of an octant

}  // namespace

Growth RegionGrower::grow(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                          GrowthWindow::BeforeReading before_reading) {
  const double bound = std::min<double>(
      RingTable::kMostRings,
      rule_.as_printed ? std::hypot(open.width(), open.height()) : rule_.max_radius);
  window_.start(open, from, std::move(before_reading));
  Growth growth;
  taken_ = 1;
  bool clear = true;
  double radius = std::min(rule_.growth_radius, bound);
  for (std::int32_t r = 1; rule_.as_printed ? r < radius : r <= radius; ++r) {
    const std::size_t cells = rings_.cells_in(r);
    growth.scanned = r;
    std::size_t qualified = cells;
    if (clear && window_.ring_is_open(r)) {
      taken_ += cells;
    } else {
      if (clear) start_scanning(r);
      clear = false;
      qualified = scan_ring(open, from, r);
    }
    if (static_cast<double>(qualified) < rule_.addition_ratio * static_cast<double>(cells)) break;
    const double pass_ratio =
        static_cast<double>(taken_) / static_cast<double>(rings_.cells_within(r));
    radius = std::min(bound, radius + rule_.radius_weight * pass_ratio * radius);
  }
  growth.runs = clear || rule_.as_printed ? disc(open, from, growth.scanned)
                                          : qualified_cells(open, from, growth.scanned);
  return growth;
}

/// Ring `radius` is the first that is not open throughout.
void RegionGrower::start_scanning(std::int32_t radius) {
  hull_.start(radius - 1);
  slopes_.clear(radius);
  failed_in_hull_ = 0;
  refusals_.assign(kOctants.size() * kDirections, Refusal());
}

std::size_t RegionGrower::scan_ring(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                                    std::int32_t radius) {
  window_.reach(radius);
  hull_.reach(radius);
  slopes_.reach(radius);
  blocked_.clear();
  std::size_t qualified = 0;
  [&]<std::size_t... kOctant>(std::index_sequence<kOctant...>) {
    ((qualified += scan_octant<kOctant>(radius, rule_.as_printed ? 0 : qualified)), ...);
  }
  (std::make_index_sequence<kOctants.size()>());
  block_rays();
  // Line 20 adds the ring, not the points of it that qualify.
  taken_ = rule_.as_printed ? count_cells(disc(open, from, radius)) : taken_ + qualified;
  return qualified;
}

/// Of a ring that has `more` cells taken in other octants before.
template <std::size_t kOctant>
std::size_t RegionGrower::scan_octant(std::int32_t radius, std::size_t more) {
  constexpr Octant kSteps = kOctants[kOctant];
  constexpr bool kFromDiagonal = kOctant % 2 == 1;
  std::span<const OctantCell> cells = rings_.octant(radius);
  if (kFromDiagonal) {
    cells = cells.subspan(1);
    if (!cells.empty() && cells.back().along == cells.back().aside)
      cells = cells.first(cells.size() - 1);
  }
  const std::ptrdiff_t along = kSteps.along_x + kSteps.along_y * window_.stride();
  const std::ptrdiff_t aside = kSteps.aside_x + kSteps.aside_y * window_.stride();
  const BlockedSlopes::Bins bins = slopes_.bins(kOctant);
  std::uint8_t* const middle = window_.middle();
  std::size_t qualified = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const OctantCell& cell = cells[kFromDiagonal ? cells.size() - 1 - i : i];
    std::uint8_t* const state = middle + cell.along * along + cell.aside * aside;
    const HullPoint point{cell.along * kSteps.along_x + cell.aside * kSteps.aside_x,
                          cell.along * kSteps.along_y + cell.aside * kSteps.aside_y};
    if (*state & GrowthWindow::kOpen) {
      // The cell before it on the ray may be in this ring, whose cells are not in `bins` yet.
      const std::uint8_t before = state[-along - (2 * cell.aside > cell.along ? aside : 0)];
      if ((before & GrowthWindow::kOpen) && !bins.block(cell.slope) &&
          (hull_.holds(point) ||
           fits_hull(point, taken_ + (rule_.as_printed ? 0 : more + qualified) + 1,
                     refusals_[kOctant * kDirections + (cell.slope >> kDirectionShift)]))) {
        ++qualified;
        continue;
      }
    } else if ((state[-along] | state[-along - aside]) & GrowthWindow::kOpen) {
      // Else all rays to it are blocked before.
      blocked_.push_back({kOctant, cell.along, cell.aside});
    }
    *state |= GrowthWindow::kFailed;
    failed_in_hull_ += hull_.holds(point) ? 1 : 0;
  }
  return qualified;
}

/// Whether the hull may take in a cell that it does not hold; if so it has.
bool RegionGrower::fits_hull(const HullPoint& cell, std::size_t qualified, Refusal& refusal) {
  // The paper's Algorithm 1 compares with r_a here where its text means r_o.
  const double most = (rule_.as_printed ? rule_.addition_ratio : rule_.obstacle_ratio) *
                      static_cast<double>(qualified);
  std::size_t failed = failed_in_hull_;
  if (static_cast<double>(failed) > most) return false;
  // The hull with this cell holds the hull with one that lies between.
  if (static_cast<double>(refusal.failed) > most && lies_behind(cell, refusal.cell)) {
    refusal.cell = cell;
    return false;
  }
  GrowingHull::Addition addition = hull_.see(cell);
  if (!addition.is_alone) {
    hull_.take_cells(cell, addition, [&](std::int32_t y, std::int32_t first, std::int32_t last) {
      const std::uint8_t* const cells = window_.row(y) + first;
      if (first == last) {  // nearly always
        failed += *cells / GrowthWindow::kFailed;
      } else {
        failed += count_failed(cells, last - first + 1);
      }
    });
    if (static_cast<double>(failed) > most) {
      hull_.give_back();
      refusal = {cell, failed};
      return false;
    }
    failed_in_hull_ = failed;
  }
  hull_.add(cell, addition);
  return true;
}

/// Whether the line from a cell through another one surely ends in the hull.
bool RegionGrower::lies_behind(const HullPoint& cell, const HullPoint& between) const {
  const std::int32_t dx = between.x - cell.x, dy = between.y - cell.y;
  const std::int32_t reach = std::max(std::abs(cell.x), std::abs(cell.y));
  HullPoint at{cell.x + 2 * dx, cell.y + 2 * dy};
  for (std::int32_t steps = 2; std::max(std::abs(at.x), std::abs(at.y)) <= reach; steps *= 2) {
    if (hull_.holds(at)) return true;
    at = {cell.x + 2 * steps * dx, cell.y + 2 * steps * dy};
  }
  return false;
}

void RegionGrower::block_rays() {
  for (const BlockedCell& cell : blocked_) {
    slopes_.block(cell.octant, cell.along, cell.aside);
    // On an axis or a diagonal it is in two octants.
    if (cell.aside == 0) slopes_.block((cell.octant + 7U) % 8, cell.along, cell.aside);
    if (cell.aside == cell.along) slopes_.block(cell.octant + 1U, cell.along, cell.aside);
  }
}

std::vector<CellRun> RegionGrower::disc(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                                        std::int32_t radius) const {
  const std::int32_t column = open.column(from), row = open.row(from);
  std::vector<CellRun> runs;
  for (std::int32_t dy = std::max(-radius, -row); dy <= std::min(radius, open.height() - 1 - row);
       ++dy) {
    const std::int32_t width = disc_reach(radius, dy);
    const std::int32_t first = std::max(-width, -column);
    const std::int32_t last = std::min(width, open.width() - 1 - column);
    runs.push_back({from + dy * open.stride() + first, last - first + 1});
  }
  return runs;
}

/// Cells whose ray is open can still be cut off, where the hull refused what lies between.
std::vector<CellRun> RegionGrower::qualified_cells(const PaddedGrid<std::uint8_t>& open,
                                                   CellIndex from, std::int32_t radius) {
  connected_.clear();
  std::size_t middle = 0;
  for (std::int32_t dy = -radius; dy <= radius; ++dy) {
    connected_.start_row();
    const std::uint8_t* const cells = window_.row(dy);
    const std::int32_t width = disc_reach(radius, dy);
    for (std::int32_t x = -width; x <= width;) {
      x += length_of_failed(cells + x, width + 1 - x);
      const std::int32_t length = length_of_open(cells + x, width + 1 - x);
      if (length > 0) connected_.add(dy, x, x + length - 1);
      if (dy == 0 && x <= 0 && x + length > 0) middle = connected_.runs().size() - 1;
      x += length;
    }
  }
  const std::size_t piece = connected_.piece(middle);
  std::vector<CellRun> runs;
  for (std::size_t i = 0; i < connected_.runs().size(); ++i) {
    const ConnectedRuns::Run& run = connected_.runs()[i];
    if (connected_.piece(i) == piece)
      runs.push_back({from + run.row * open.stride() + run.first, run.last - run.first + 1});
  }
  return runs;
}

}  // namespace stope::topology
