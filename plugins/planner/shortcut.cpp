// Problem: roads of a graph run along the middle between obstacles; in open ground the way that a
// driver takes is shorter, and it may be another one altogether.
// Idea: A* over the cells of free ground finds a way that is no longer than any other over cells,
// whichever side of whatever obstacle it takes; then it is pulled straight wherever a line of sight
// allows. It looks only where a way no longer than that by road can lead.
// Cost: O(n) in the cells looked at, as costs are whole numbers and the queue is buckets of equal
// keys; the lines of sight add some hundred cells each.
#include "plugins/planner/shortcut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "plugins/planner/bucket_queue.hpp"
#include "plugins/planner/pulled_straight.hpp"
#include "plugins/planner/shortcut_ground.hpp"

namespace stope::planner {
namespace {

// A step to the side and across, 1 : sqrt(2) to six digits, in whole numbers.
constexpr std::uint32_t kStraight = 408, kDiagonal = 577, kUnknown = 0xFFFFFFFF;

struct Step {
  std::int32_t dx, dy;
};
constexpr std::array<Step, 8> kSteps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

std::uint32_t step_cost(const RoadGround& roads, const Step& step, Cell to) {
  const std::uint32_t cost = step.dx != 0 && step.dy != 0 ? kDiagonal : kStraight;
  return roads.slow() ? static_cast<std::uint32_t>(std::ceil(cost * roads.factor(to))) : cost;
}

/// The cheapest way over cells, both ends among them; none if there is none.
std::vector<Cell> cheapest_cells(ShortcutGround& ground, Cell from, Cell to) {
  const RoadGround& roads = ground.roads();
  const CellBox& box = ground.box();
  const auto bound = [&](Cell cell) {
    const auto dx = static_cast<std::uint32_t>(std::abs(cell.column - to.column));
    const auto dy = static_cast<std::uint32_t>(std::abs(cell.row - to.row));
    return kStraight * (std::max(dx, dy) - std::min(dx, dy)) + kDiagonal * std::min(dx, dy);
  };
  const auto dearest =
      static_cast<std::uint32_t>(roads.slow() ? RoadGround::kMostFactor : 1.0) * kDiagonal;
  BucketQueue queue(dearest + kDiagonal);
  std::vector<std::uint32_t> costs(box.size(), kUnknown);
  std::vector<std::uint8_t> by(box.size(), 0);
  const std::uint32_t first = box.place(from), last = box.place(to);
  costs[first] = 0;
  queue.start(bound(from));
  queue.push(bound(from), first);
  while (!queue.empty()) {
    const std::uint32_t at = queue.pop();
    const Cell here = box.cell(at);
    const std::uint32_t cost = costs[at];
    if (at == last) break;
    if (queue.key() > cost + bound(here)) continue;
    // Beyond this whole numbers of 32 bits would not do.
    if (cost > kUnknown - 3 * dearest - bound(here)) continue;
    for (std::uint8_t i = 0; i < kSteps.size(); ++i) {
      const Step& step = kSteps[i];
      const Cell next{here.column + step.dx, here.row + step.dy};
      if (!ground.drivable(next)) continue;
      const std::uint32_t place = box.place(next), further = cost + step_cost(roads, step, next);
      if (further >= costs[place]) continue;
      if (step.dx != 0 && step.dy != 0 &&
          (!ground.drivable({next.column, here.row}) || !ground.drivable({here.column, next.row})))
        continue;
      if (!roads.passable(here, next, Vector2(step.dx, step.dy))) continue;
      costs[place] = further;
      by[place] = i;
      queue.push(further + bound(next), place);
    }
  }
  std::vector<Cell> cells;
  if (costs[last] == kUnknown) return cells;
  for (Cell at = to; !(at == from);) {
    cells.push_back(at);
    const Step& step = kSteps[by[box.place(at)]];
    at = {at.column - step.dx, at.row - step.dy};
  }
  cells.push_back(from);
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace

CellBox cells_within_reach(const GridFrame& frame, const std::vector<RoadVertex>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  // An ellipse, the line's ends in its foci. Over cells ways are up to 8 % longer.
  constexpr double kOverCells = 1.0824;
  const Vector2 a = frame.to_grid(line.front().x, line.front().y);
  const Vector2 b = frame.to_grid(line.back().x, line.back().y);
  const double half = kOverCells * length / frame.resolution / 2;
  const Vector2 middle = (a + b) / 2, focus = (b - a) / 2;
  const double minor = std::max(0.0, half * half - focus.squaredNorm());
  constexpr double kBeside = 2;  // cells
  const Vector2 reach(std::sqrt(focus.x() * focus.x() + minor) + kBeside,
                      std::sqrt(focus.y() * focus.y() + minor) + kBeside);
  const auto cell = [](double value, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp<double>(std::floor(value), 0, count - 1));
  };
  const Vector2 low = middle - reach, high = middle + reach;
  CellBox box{cell(low.x(), frame.width), cell(low.y(), frame.height), 0, 0};
  box.width = cell(high.x(), frame.width) - box.left + 1;
  box.height = cell(high.y(), frame.height) - box.bottom + 1;
  return box;
}

std::optional<std::vector<Vector2>> shortcut(const DrivableGrid& grid, const RoadGround& roads,
                                             const CellBox& box,
                                             const std::vector<RoadVertex>& line,
                                             double min_clearance) {
  if (line.empty() || box.size() > kMostShortcutCells) return std::nullopt;
  const Vector2 start(line.front().x, line.front().y), goal(line.back().x, line.back().y);
  const auto from = grid.frame().cell_at(start.x(), start.y());
  const auto to = grid.frame().cell_at(goal.x(), goal.y());
  if (!from || !to || !box.contains(*from) || !box.contains(*to)) return std::nullopt;
  ShortcutGround ground(grid, roads, box, line, min_clearance);
  if (!roads.slow() && ground.cost_of_sight(start, goal)) return std::vector<Vector2>{start, goal};
  const auto cells = cheapest_cells(ground, *from, *to);
  if (cells.empty()) return std::nullopt;
  std::vector<Vector2> points{start};
  for (std::size_t i = 1; i + 1 < cells.size(); ++i)
    points.push_back(grid.frame().centre(cells[i]));
  points.push_back(goal);
  return pulled_straight(ground, std::move(points));
}

}  // namespace stope::planner
