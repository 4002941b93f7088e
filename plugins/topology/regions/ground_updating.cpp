// Problem: obstacles change within a window; bring the clearance of all cells up to date.
// Idea: the steps that the road extractors take (road_updater.cpp), as far as the nearest obstacle:
// cells that flip, their outlines, the rows in which the nearest obstacle can be another.
// Cost: linear in the window, in the cells that see it, and in the length of the outlines.
#include "plugins/topology/regions/ground_updating.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/topology/update_free_space.hpp"
#include "plugins/topology/update_nearest_outline.hpp"

namespace stope::topology {
namespace {

constexpr std::size_t kFewNames = 100000;

/// The part of a window that lies on the grid.
CellWindow on_grid(const CellWindow& window, const GridFrame& frame) {
  const auto end = [](std::int32_t begin, std::int32_t length, std::int32_t least,
                      std::int32_t most) {
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(std::int64_t{begin} + length, least, most));
  };
  CellWindow part;
  part.column = std::clamp(window.column, 0, frame.width);
  part.row = std::clamp(window.row, 0, frame.height);
  part.width = end(window.column, window.width, part.column, frame.width) - part.column;
  part.height = end(window.row, window.height, part.row, frame.height) - part.row;
  return part;
}

CellWindow box_of(const std::vector<CellIndex>& cells, const FreeSpace& space) {
  std::int32_t left = INT32_MAX, right = -1;
  for (const CellIndex cell : cells) {
    left = std::min(left, space.column(cell));
    right = std::max(right, space.column(cell));
  }
  const std::int32_t bottom = space.row(cells.front()), top = space.row(cells.back());
  return {left, bottom, right + 1 - left, top + 1 - bottom};
}

}  // namespace

Ground::Updating::Updating(const FreeSpace& space, const Outlines& traced, const EdgeGrid& edges,
                           const Checkpoint& checkpoint)
    : outlines(traced, edges),
      reach(space, checkpoint),
      scratch(space.width(), space.height()),
      names_at_first(outlines.number.size()) {
  std::fill_n(scratch.data(), scratch.size(), std::uint8_t{0});
}

bool Ground::update(const OccupancyGrid& grid, const CellWindow& window, GroundChange& change,
                    const Checkpoint& checkpoint) {
  if (!(frame_ == grid.frame) || grid.cells.size() != frame_.size() || !ColumnReach::fits(space_))
    return false;
  if (!updating_) {
    updating_ = std::make_unique<Updating>(space_, outlines_, edges_, checkpoint);
    outlines_ = {};
  }
  NamedOutlines& outlines = updating_->outlines;
  if (outlines.number.size() > 2 * updating_->names_at_first + kFewNames) return false;
  const std::vector<CellIndex> flipped = find_flipped_cells(
      grid, rule_, least_obstacle_, on_grid(window, frame_), space_, updating_->scratch);
  if (flipped.empty()) return true;
  checkpoint();
  const auto note = [&](CellIndex cell, std::int32_t column, std::int32_t row) {
    change.cells.push_back({cell, squared_[cell]});
    change.squares.add(column, row);
  };
  for (const CellIndex cell : flipped) {
    space_[cell] ^= kObstacle;
    note(cell, column(cell), row(cell));
    if (free(cell)) {
      ++free_cells_;
    } else {
      --free_cells_;
      squared_[cell] = 0;
    }
  }
  if (free_cells_ == 0) return false;
  const CellWindow box = box_of(flipped, space_);
  const auto spans =
      find_stale_spans(box, updating_->reach.update(space_, box), edges_, outlines.by_name, space_);
  std::vector<OutlineEdge> before;
  for (const StaleSpan& span : spans) {
    const OutlineEdge* row = edges_.padded_row(span.cells.row) + 1;
    before.insert(before.end(), row + span.cells.begin, row + span.cells.end);
  }
  update_outlines(outlines, space_, edges_, box);
  update_nearest_outline(spans, updating_->reach, space_, outlines.by_name, edges_);
  auto old = before.cbegin();
  for (const StaleSpan& span : spans) {
    const auto [row, begin, end] = span.cells;
    const CellIndex first = index(begin, row);
    for (std::int32_t i = 0; i < end - begin; ++i, ++old)
      if (*old != edges_[first + i] && free(first + i)) note(first + i, begin + i, row);
    measure(first, begin, end - begin, row);
  }
  return true;
}

}  // namespace stope::topology
