// Problem: a grid of millions of cells changes within a small window; give the road graph that a
// computation of everything would give, in milliseconds.
// Idea: each step keeps what it made and is told which part of its input has changed: cells that
// flip, edges of outlines cut and spliced, rows in which the nearest obstacle can differ, tiles in
// which dividing lines are marked anew, lines that pass these tiles. All steps break ties by
// geometry alone, so nothing depends on what was there before. What follows works on some thousand
// lines and is done for all of them.
// Cost: see docs/topology.md.
#include "plugins/topology/road_updater.hpp"

#include <algorithm>

#include "plugins/topology/connect_pieces.hpp"
#include "plugins/topology/felt_changes.hpp"
#include "plugins/topology/finish_roads.hpp"
#include "plugins/topology/line_store.hpp"
#include "plugins/topology/named_outlines.hpp"
#include "plugins/topology/seen_from.hpp"
#include "plugins/topology/terrain.hpp"
#include "plugins/topology/update_dividing_lines.hpp"
#include "plugins/topology/update_free_space.hpp"
#include "plugins/topology/update_nearest_outline.hpp"

namespace stope::topology {

namespace {

constexpr std::size_t kFewNames = 100000;

CellWindow box_of(const std::vector<CellIndex>& cells, const FreeSpace& space) {
  std::int32_t left = INT32_MAX, bottom = INT32_MAX, right = -1, top = -1;
  for (const CellIndex cell : cells) {
    left = std::min(left, space.column(cell)), right = std::max(right, space.column(cell));
    bottom = std::min(bottom, space.row(cell)), top = std::max(top, space.row(cell));
  }
  return {left, bottom, right + 1 - left, top + 1 - bottom};
}

}  // namespace

struct RoadUpdater::State {
  State(const ExtractionMethod& method, const GridFrame& grid_frame, Terrain terrain,
        std::vector<ReplacedEdge> replaced_edges, std::unique_ptr<Courses> courses_of_lines,
        std::vector<TracedLine> lines, const Checkpoint& checkpoint)
      : frame(grid_frame),
        space(std::move(terrain.space)),
        edges(std::move(terrain.edges)),
        outlines(terrain.outlines, edges),
        rule(method, frame, outlines.by_number, outlines.side_by_number),
        reach(space, checkpoint),
        replaced(std::move(replaced_edges)),
        seen(space, edges, outlines.by_name, replaced),
        scratch(space.width(), space.height()),
        stale(space.width(), space.height()),
        touched(space.width(), space.height()),
        flipped(space.width(), space.height()),
        courses(std::move(courses_of_lines)),
        store(std::move(lines), stale),
        names_at_first(outlines.number.size()) {
    memo.use_tiles(touched, space.stride());
    std::fill_n(scratch.data(), scratch.size(), std::uint8_t{0});
    for (std::size_t cell = 0; cell < space.size(); ++cell)
      free_cells += space.data()[cell] & kObstacle ? 0 : 1;
  }

  /// Free space, outlines, nearest edges, dividing lines and their centre lines as they are now.
  /// False if no free cell is left.
  bool update(const ExtractionMethod& method, const std::vector<CellIndex>& cells);

  GridFrame frame;
  FreeSpace space;
  EdgeGrid edges;
  NamedOutlines outlines;
  DividingRule rule;
  ColumnReach reach;
  std::vector<ReplacedEdge> replaced;
  SeenFrom seen;
  PaddedGrid<std::uint8_t> scratch;
  TileSet stale, touched, flipped;
  std::unique_ptr<Courses> courses;
  LineStore store;
  RoadMemo memo;
  std::int64_t free_cells = 0;
  std::size_t names_at_first;
};

bool RoadUpdater::State::update(const ExtractionMethod& method,
                                const std::vector<CellIndex>& cells) {
  const CellWindow window = box_of(cells, space);
  // The nearest edges of all cells, as they were.
  std::vector<OutlineEdge> replacement;
  for (const ReplacedEdge& cell : replaced) {
    replacement.push_back(edges[cell.cell]);
    edges[cell.cell] = cell.nearest;
  }
  for (const CellIndex cell : cells) {
    space[cell] ^= kObstacle;
    free_cells += space[cell] & kObstacle ? -1 : 1;
  }
  if (free_cells == 0) return false;
  const auto spans =
      find_stale_spans(window, reach.update(space, window), edges, outlines.by_name, space);
  std::vector<OutlineEdge> before;
  for (const StaleSpan& span : spans) {
    const OutlineEdge* row = edges.padded_row(span.cells.row) + 1;
    before.insert(before.end(), row + span.cells.begin, row + span.cells.end);
  }
  const OutlineChange change = update_outlines(outlines, space, edges, window);
  rule.renew(change, outlines.side_by_number);
  update_nearest_outline(spans, reach, space, outlines.by_name, edges);

  stale.clear();
  touched.clear();
  flipped.clear();
  for (const CellIndex cell : cells) {
    flipped.add(flipped.tile_of(cell));
    const std::int32_t column = space.column(cell), row = space.row(cell);
    stale.add(column - 1, row - 1, column + 1, row + 1);
    touched.add(column - 1, row - 1, column + 1, row + 1);
  }
  auto old = before.cbegin();
  for (const StaleSpan& span : spans) {
    const std::int32_t row = span.cells.row;
    const OutlineEdge* now = edges.padded_row(row) + 1;
    const std::uint8_t* bits = space.padded_row(row) + 1;
    std::int32_t first = INT32_MAX, last = 0;  // of a run of cells that see something else now
    const auto end_run = [&] {
      if (first > last) return;
      stale.add(first - 1, row - 1, last + 1, row + 1);
      touched.add(first - 1, row - 1, last + 1, row + 1);
      first = INT32_MAX;
    };
    std::int32_t begin = 0, end = 0;  // of some side by side that see edges beside each other
    const auto see = [&] {
      if (begin < end) seen.add(outlines.by_name, now[begin], now[end - 1], begin, end - 1, row);
    };
    for (std::int32_t column = span.cells.begin; column < span.cells.end; ++column, ++old) {
      if (*old == now[column] || (bits[column] & kObstacle)) continue;
      if (column > last + TileSet::kSide) end_run();
      if (first > column) first = column;
      last = column;
      if (begin == end || end != column || !SeenFrom::together(now[begin], now[column])) {
        see();
        begin = column;
      }
      end = column + 1;
    }
    see();
    end_run();
  }
  add_tiles_of_felt_changes(method, outlines, rule, change, seen, stale);
  update_dividing_lines(space, outlines, rule.rule(), edges, stale, replacement, replaced, touched);
  for (const ReplacedEdge& cell : replaced)
    seen.add(outlines.by_name, edges[cell.cell], edges[cell.cell], edges.column(cell.cell),
             edges.column(cell.cell), edges.row(cell.cell));
  LineTracer tracer(space, outlines.by_name, edges, *courses, method.least_apart(frame));
  store.update(tracer, space, touched, *courses);
  return true;
}

RoadUpdater::RoadUpdater(const ExtractionMethod& method) : method_(method) {}
RoadUpdater::~RoadUpdater() = default;
RoadUpdater::RoadUpdater(RoadUpdater&&) noexcept = default;
RoadUpdater& RoadUpdater::operator=(RoadUpdater&&) noexcept = default;

RoadGraph RoadUpdater::full(const OccupancyGrid& grid, const Checkpoint& checkpoint) {
  state_.reset();
  Terrain terrain(grid, method_, checkpoint);
  std::vector<ReplacedEdge> replaced;
  std::vector<CellIndex> corners;
  {
    const DividingRule rule(method_, grid.frame, terrain.outlines);
    corners = find_dividing_lines(terrain.space, terrain.outlines, rule.rule(), terrain.edges,
                                  checkpoint, &replaced);
  }
  auto courses = std::make_unique<Courses>(!ColumnReach::fits(terrain.space));
  LineTracer tracer(terrain.space, terrain.outlines, terrain.edges, *courses,
                    method_.least_apart(grid.frame));
  std::vector<TracedLine> lines = trace_lines(tracer, corners);
  checkpoint();
  if (!ColumnReach::fits(terrain.space))
    return finish_roads(terrain.space, terrain.outlines, terrain.edges, replaced, list_of(lines),
                        LineEnds(list_of(lines)), *courses, method_, grid.frame, nullptr,
                        checkpoint);
  state_ = std::make_unique<State>(method_, grid.frame, std::move(terrain), std::move(replaced),
                                   std::move(courses), std::move(lines), checkpoint);
  return finish(checkpoint);
}

RoadGraph RoadUpdater::finish(const Checkpoint& checkpoint) {
  // Whoever stops half way must not leave half a state.
  std::unique_ptr<State> state = std::move(state_);
  RoadGraph roads = finish_roads(state->space, state->outlines.by_name, state->edges,
                                 state->replaced, state->store.list(), state->store.ends(),
                                 *state->courses, method_, state->frame, &state->memo, checkpoint);
  state->courses->forget_unused(state->store.courses());
  state_ = std::move(state);
  return roads;
}

RoadGraph RoadUpdater::update(const OccupancyGrid& grid, const CellWindow& window,
                              const Checkpoint& checkpoint) {
  if (!state_ || state_->frame != grid.frame || grid.cells.size() != grid.frame.size() ||
      state_->outlines.number.size() > 2 * state_->names_at_first + kFewNames)
    return full(grid, checkpoint);
  CellWindow inside;
  inside.column = std::clamp(window.column, 0, grid.frame.width);
  inside.row = std::clamp(window.row, 0, grid.frame.height);
  inside.width = static_cast<std::int32_t>(std::clamp<std::int64_t>(
                     std::int64_t{window.column} + window.width, inside.column, grid.frame.width)) -
                 inside.column;
  inside.height = static_cast<std::int32_t>(std::clamp<std::int64_t>(
                      std::int64_t{window.row} + window.height, inside.row, grid.frame.height)) -
                  inside.row;
  State& s = *state_;
  const std::vector<CellIndex> flipped = find_flipped_cells(
      grid, method_.occupancy(), method_.least_obstacle(grid.frame), inside, s.space, s.scratch);
  if (flipped.empty()) return finish(checkpoint);
  std::unique_ptr<State> state = std::move(state_);
  if (!state->update(method_, flipped)) return full(grid, checkpoint);
  state_ = std::move(state);
  state_->memo.forget(state_->touched, state_->flipped);
  return finish(checkpoint);
}

}  // namespace stope::topology
