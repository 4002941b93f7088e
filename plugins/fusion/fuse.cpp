#include "plugins/fusion/fuse.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "stope/error.hpp"

namespace stope::fusion {
namespace {

constexpr double kSameLattice = 1e-6;  // cells
constexpr double kMostCells = 4e9;

/// Where the live grid's corner (0, 0) lies on the prior grid's lattice, in whole cells; none if
/// the lattices differ.
std::optional<Cell> lattice_offset(const GridFrame& prior, const GridFrame& live) {
  const Vector2 at = prior.to_grid(live.origin.x, live.origin.y);
  const Vector2 far = prior.to_grid(live.to_map(live.width, live.height).x(),
                                    live.to_map(live.width, live.height).y());
  const double column = std::round(at.x()), row = std::round(at.y());
  const Vector2 expected(column + live.width, row + live.height);
  const bool same =
      (at - Vector2(column, row)).norm() < kSameLattice && (far - expected).norm() < kSameLattice;
  if (!same) return std::nullopt;
  return Cell{static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)};
}

/// The prior grid's frame, widened by whole cells to span the live grid; `shift` becomes the place
/// of its old corner in it.
GridFrame union_of(const GridFrame& prior, const GridFrame& live, Cell& shift) {
  double left = 0, bottom = 0, right = prior.width, top = prior.height;
  for (int corner = 0; corner < 4; ++corner) {
    const Vector2 map =
        live.to_map(corner % 2 == 0 ? 0 : live.width, corner / 2 == 0 ? 0 : live.height);
    const Vector2 at = prior.to_grid(map.x(), map.y());
    left = std::min(left, std::floor(at.x() + kSameLattice));
    bottom = std::min(bottom, std::floor(at.y() + kSameLattice));
    right = std::max(right, std::ceil(at.x() - kSameLattice));
    top = std::max(top, std::ceil(at.y() - kSameLattice));
  }
  if (!((right - left) * (top - bottom) <= kMostCells)) {
    throw Error(fmt::format(
        "the prior and the live grid lie so far apart that both together span {:.0f} x {:.0f} "
        "cells: are they in the same frame?",
        right - left, top - bottom));
  }
  shift = {static_cast<std::int32_t>(-left), static_cast<std::int32_t>(-bottom)};
  GridFrame frame = prior;
  frame.width = static_cast<std::int32_t>(right - left);
  frame.height = static_cast<std::int32_t>(top - bottom);
  const Vector2 corner = prior.to_map(left, bottom);
  frame.origin.x = corner.x();
  frame.origin.y = corner.y();
  return frame;
}

/// The live grid's value in a cell of another lattice.
class LiveLookup {
 public:
  LiveLookup(const OccupancyGrid& live, const GridFrame& frame)
      : live_(live),
        frame_(frame),
        samples_(std::max(
            1, static_cast<int>(std::ceil(frame.resolution / live.frame.resolution - 1e-9)))) {}

  std::uint8_t at(Cell cell) const {
    std::uint8_t highest = OccupancyGrid::kUnknown;
    for (int i = 0; i < samples_; ++i) {
      for (int j = 0; j < samples_; ++j) {
        const Vector2 point =
            frame_.to_map(cell.column + (j + 0.5) / samples_, cell.row + (i + 0.5) / samples_);
        const auto there = live_.frame.cell_at(point.x(), point.y());
        if (!there) continue;
        const std::uint8_t value = live_.cells[live_.frame.place(*there)];
        if (value == OccupancyGrid::kUnknown) continue;
        highest = highest == OccupancyGrid::kUnknown ? value : std::max(highest, value);
      }
    }
    return highest;
  }

 private:
  const OccupancyGrid& live_;
  const GridFrame& frame_;
  int samples_;
};

/// The window that holds both grids' changes; none if one of them may differ anywhere, if they are
/// compared with different items, or if the result's frame is not the prior grid's own.
std::optional<ChangedWindow> changed_of(const OccupancyGrid& prior, const OccupancyGrid& live,
                                        const GridFrame& frame, const std::optional<Cell>& offset) {
  if (!prior.changed || !live.changed || !offset || frame != prior.frame ||
      prior.changed->since != live.changed->since)
    return std::nullopt;
  const ChangedWindow &a = *prior.changed, &b = *live.changed;
  const std::int32_t column = b.column + offset->column, row = b.row + offset->row;
  if (b.width == 0 || b.height == 0) return a;
  if (a.width == 0 || a.height == 0) return ChangedWindow{column, row, b.width, b.height, b.since};
  ChangedWindow both = a;
  both.column = std::min(a.column, column);
  both.row = std::min(a.row, row);
  both.width = std::max(a.column + a.width, column + b.width) - both.column;
  both.height = std::max(a.row + a.height, row + b.height) - both.row;
  return both;
}

}  // namespace

OccupancyGrid fuse(const OccupancyGrid& prior, const OccupancyGrid& live, const CellTable& table) {
  if (prior.cells.empty() || live.cells.empty())
    throw Error("one of the grids has no cells, so there is nothing to join");
  OccupancyGrid result;
  Cell shift;
  result.frame = union_of(prior.frame, live.frame, shift);
  result.cells.resize(result.frame.size());
  const std::optional<Cell> offset = lattice_offset(prior.frame, live.frame);
  const LiveLookup lookup(live, result.frame);
  tbb::parallel_for(0, result.frame.height, [&](std::int32_t row) {
    for (std::int32_t column = 0; column < result.frame.width; ++column) {
      const Cell of_prior{column - shift.column, row - shift.row};
      const std::uint8_t before = prior.frame.contains(of_prior)
                                      ? prior.cells[prior.frame.place(of_prior)]
                                      : OccupancyGrid::kUnknown;
      std::uint8_t now = OccupancyGrid::kUnknown;
      if (offset) {
        const Cell of_live{of_prior.column - offset->column, of_prior.row - offset->row};
        if (live.frame.contains(of_live)) now = live.cells[live.frame.place(of_live)];
      } else {
        now = lookup.at({column, row});
      }
      result.cells[result.frame.place({column, row})] =
          table[static_cast<std::size_t>(before) * 256 + now];
    }
  });
  result.changed = changed_of(prior, live, result.frame, offset);
  return result;
}

}  // namespace stope::fusion
