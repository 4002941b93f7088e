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

#include "plugins/planner/cell_line.hpp"

namespace stope::planner {
namespace {

// A step to the side and across, 1 : sqrt(2) to six digits, in whole numbers.
constexpr std::uint32_t kStraight = 408, kDiagonal = 577, kUnknown = 0xFFFFFFFF;

struct Step {
  std::int32_t dx, dy;
};
constexpr std::array<Step, 8> kSteps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// Places by keys that never fall below the last one taken, nor rise above it by `most` or more.
class BucketQueue {
 public:
  explicit BucketQueue(std::uint32_t most) {
    std::size_t count = 1;
    while (count <= most) count *= 2;
    buckets_.resize(count);
  }
  void start(std::uint32_t key) { now_ = key; }
  void push(std::uint32_t key, std::uint32_t place) {
    buckets_[key & (buckets_.size() - 1)].push_back(place);
    ++size_;
  }
  bool empty() const { return size_ == 0; }
  /// One with the least key; of several the last that came.
  std::uint32_t pop() {
    while (buckets_[now_ & (buckets_.size() - 1)].empty()) ++now_;
    auto& bucket = buckets_[now_ & (buckets_.size() - 1)];
    const std::uint32_t place = bucket.back();
    bucket.pop_back();
    --size_;
    return place;
  }
  std::uint32_t key() const { return now_; }

 private:
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::uint32_t now_ = 0;
  std::size_t size_ = 0;
};

class Shortcut {
 public:
  Shortcut(const DrivableGrid& grid, const RoadGround& ground, const CellBox& box,
           const std::vector<RoadVertex>& line, double min_clearance)
      : grid_(grid),
        ground_(ground),
        box_(box),
        min_clearance_(min_clearance),
        drivable_(box.size(), 0),
        start_(line.front().x, line.front().y),
        goal_(line.back().x, line.back().y) {
    // The route is driven by road however narrow it is there.
    for (std::size_t i = 0; i < line.size(); ++i) {
      const RoadVertex &a = line[i], &b = line[std::min(i + 1, line.size() - 1)];
      walk_line_in(box_, grid.frame().to_grid(a.x, a.y), grid.frame().to_grid(b.x, b.y),
                   [&](Cell cell) { drivable_[box_.place(cell)] = grid.free(cell) ? 1 : 2; });
    }
  }

  std::optional<std::vector<Vector2>> way() {
    const auto from = grid_.frame().cell_at(start_.x(), start_.y());
    const auto to = grid_.frame().cell_at(goal_.x(), goal_.y());
    if (!from || !to || !box_.contains(*from) || !box_.contains(*to)) return std::nullopt;
    if (!ground_.slow() && cost_of_sight(start_, goal_)) return std::vector<Vector2>{start_, goal_};
    const auto cells = search(*from, *to);
    if (cells.empty()) return std::nullopt;
    std::vector<Vector2> points{start_};
    for (std::size_t i = 1; i + 1 < cells.size(); ++i)
      points.push_back(grid_.frame().centre(cells[i]));
    points.push_back(goal_);
    return pulled_straight(std::move(points));
  }

 private:
  /// Whether a cell is free and far enough from those that are not; asked once a cell.
  bool drivable(Cell cell) {
    if (!box_.contains(cell)) return false;
    std::uint8_t& known = drivable_[box_.place(cell)];
    if (known == 0) {
      const Vector2 centre = grid_.frame().centre(cell);
      known = grid_.free(cell) && (min_clearance_ <= 0 ||
                                   grid_.clearance(centre, min_clearance_) >= min_clearance_)
                  ? 1
                  : 2;
    }
    return known == 1;
  }

  /// Metres, as dear as the ground is, of a straight line that may be driven; none if it may not.
  std::optional<double> cost_of_sight(const Vector2& a, const Vector2& b) {
    const GridFrame& frame = grid_.frame();
    const Vector2 from = frame.to_grid(a.x(), a.y()), to = frame.to_grid(b.x(), b.y());
    std::optional<Cell> before;
    double count = 0, sum = 0;
    const bool clear = walk_line(from, to, [&](Cell cell) {
      if (!drivable(cell)) return false;
      if (!ground_.open()) {
        if (before && !ground_.passable(*before, cell, to - from)) return false;
        before = cell;
        sum += ground_.factor(cell), count += 1;
      }
      return true;
    });
    if (!clear) return std::nullopt;
    return (b - a).norm() * (count > 0 ? sum / count : 1);
  }

  std::uint32_t step_cost(const Step& step, Cell to) const {
    const std::uint32_t cost = step.dx != 0 && step.dy != 0 ? kDiagonal : kStraight;
    return ground_.slow() ? static_cast<std::uint32_t>(std::ceil(cost * ground_.factor(to))) : cost;
  }

  std::vector<Cell> search(Cell from, Cell to) {
    const auto bound = [&](Cell cell) {
      const auto dx = static_cast<std::uint32_t>(std::abs(cell.column - to.column));
      const auto dy = static_cast<std::uint32_t>(std::abs(cell.row - to.row));
      return kStraight * (std::max(dx, dy) - std::min(dx, dy)) + kDiagonal * std::min(dx, dy);
    };
    const auto dearest =
        static_cast<std::uint32_t>(ground_.slow() ? RoadGround::kMostFactor : 1.0) * kDiagonal;
    BucketQueue queue(dearest + kDiagonal);
    std::vector<std::uint32_t> costs(box_.size(), kUnknown);
    std::vector<std::uint8_t> by(box_.size(), 0);
    const std::uint32_t first = box_.place(from), last = box_.place(to);
    costs[first] = 0;
    queue.start(bound(from));
    queue.push(bound(from), first);
    while (!queue.empty()) {
      const std::uint32_t at = queue.pop();
      const Cell here = box_.cell(at);
      const std::uint32_t cost = costs[at];
      if (at == last) break;
      if (queue.key() > cost + bound(here)) continue;
      // Beyond this whole numbers of 32 bits would not do.
      if (cost > kUnknown - 3 * dearest - bound(here)) continue;
      for (std::uint8_t i = 0; i < kSteps.size(); ++i) {
        const Step& step = kSteps[i];
        const Cell next{here.column + step.dx, here.row + step.dy};
        if (!drivable(next)) continue;
        const std::uint32_t place = box_.place(next), further = cost + step_cost(step, next);
        if (further >= costs[place]) continue;
        if (step.dx != 0 && step.dy != 0 &&
            (!drivable({next.column, here.row}) || !drivable({here.column, next.row})))
          continue;
        if (!ground_.passable(here, next, Vector2(step.dx, step.dy))) continue;
        costs[place] = further;
        by[place] = i;
        queue.push(further + bound(next), place);
      }
    }
    std::vector<Cell> cells;
    if (costs[last] == kUnknown) return cells;
    for (Cell at = to; !(at == from);) {
      cells.push_back(at);
      const Step& step = kSteps[by[box_.place(at)]];
      at = {at.column - step.dx, at.row - step.dy};
    }
    cells.push_back(from);
    std::reverse(cells.begin(), cells.end());
    return cells;
  }

  /// Whether a line from one point of a chain to a later one may take the place of what is between.
  bool straight(const std::vector<Vector2>& points, const std::vector<double>& until,
                std::size_t from, std::size_t to) {
    const auto cost = cost_of_sight(points[from], points[to]);
    return cost && *cost <= until[to] - until[from] + 1e-9 * until.back();
  }

  /// From point to point, each time to one as far ahead as is seen.
  std::vector<Vector2> pulled(const std::vector<Vector2>& points) {
    std::vector<double> until{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
      // A piece of a chain may be driven already, so it is seen.
      const auto cost = ground_.slow() ? cost_of_sight(points[i - 1], points[i])
                                       : std::optional((points[i] - points[i - 1]).norm());
      until.push_back(until.back() + cost.value_or((points[i] - points[i - 1]).norm()));
    }
    std::vector<Vector2> kept{points.front()};
    for (std::size_t i = 0; i + 1 < points.size();) {
      // Twice as far while it sees, then half as far until it is one point.
      std::size_t reached = i + 1, stride = 1;
      while (reached + stride < points.size() && straight(points, until, i, reached + stride))
        reached += stride, stride *= 2;
      for (; stride > 0; stride /= 2)
        if (reached + stride < points.size() && straight(points, until, i, reached + stride))
          reached += stride;
      kept.push_back(points[reached]);
      i = reached;
    }
    return kept;
  }

  /// Points of the same lines, about `apart` metres from each other.
  static std::vector<Vector2> divided(const std::vector<Vector2>& points, double apart) {
    std::vector<Vector2> all{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vector2 way = points[i] - points[i - 1];
      const auto count = std::max(1.0, std::ceil(way.norm() / apart));
      for (double k = 1; k < count; ++k) all.push_back(points[i - 1] + (k / count) * way);
      all.push_back(points[i]);
    }
    return all;
  }

  std::vector<Vector2> pulled_straight(std::vector<Vector2> points) {
    constexpr int kRounds = 4;
    points = pulled(points);
    for (int round = 0; round < kRounds && points.size() > 2; ++round)
      points = pulled(divided(points, grid_.frame().resolution));
    return points;
  }

  const DrivableGrid& grid_;
  const RoadGround& ground_;
  const CellBox box_;
  double min_clearance_;
  std::vector<std::uint8_t> drivable_;  // 0 not asked yet, 1 yes, 2 no
  Vector2 start_, goal_;
};

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

std::optional<std::vector<Vector2>> shortcut(const DrivableGrid& grid, const RoadGround& ground,
                                             const CellBox& box,
                                             const std::vector<RoadVertex>& line,
                                             double min_clearance) {
  if (line.empty() || box.size() > kMostShortcutCells) return std::nullopt;
  return Shortcut(grid, ground, box, line, min_clearance).way();
}

}  // namespace stope::planner
