// Problem: roads of a graph run along the middle between obstacles; in open ground the way that a
// driver takes is shorter.
// Idea: the discs of clearance around a few good routes hold the ground they run through. Within
// that tube A* over cells (eight neighbours, corners are not cut) finds the shortest way, which may
// change from one route to another; then it is pulled straight wherever a line of sight allows.
// Cost: O(n log n) in the cells of the tube; the lines of sight add some hundred cells each.
#include "plugins/planner/shortcut.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "plugins/planner/search_labels.hpp"

namespace stope::planner {
namespace {

// A step to the side and across, 1 : sqrt(2) to six digits, in whole numbers.
constexpr WayCost kStraight = 408'000, kDiagonal = 576'999;
constexpr std::size_t kMostCells = 64'000'000;

/// Visits the cells a line touches, from a to b, while `visit` says so; both cells beside a corner
/// it runs through. Coordinates in cells.
template <class Visit>
bool walk_line(const Vector2& a, const Vector2& b, const Visit& visit) {
  auto column = static_cast<std::int32_t>(std::floor(a.x()));
  auto row = static_cast<std::int32_t>(std::floor(a.y()));
  const auto last_column = static_cast<std::int32_t>(std::floor(b.x()));
  const auto last_row = static_cast<std::int32_t>(std::floor(b.y()));
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  const std::int32_t across = dx > 0 ? 1 : -1, along = dy > 0 ? 1 : -1;
  if (!visit(Cell{column, row})) return false;
  while (column != last_column || row != last_row) {
    // How far along the line the next boundary in x and in y lies, times |dx dy|.
    const double next_x = column == last_column
                              ? HUGE_VAL
                              : (across > 0 ? column + 1 - a.x() : a.x() - column) * std::abs(dy);
    const double next_y =
        row == last_row ? HUGE_VAL : (along > 0 ? row + 1 - a.y() : a.y() - row) * std::abs(dx);
    if (std::abs(next_x - next_y) <= 1e-9 * (1 + std::abs(dx) + std::abs(dy))) {
      if (!visit(Cell{column + across, row}) || !visit(Cell{column, row + along})) return false;
      column += across;
      row += along;
    } else if (next_x < next_y) {
      column += across;
    } else {
      row += along;
    }
    if (!visit(Cell{column, row})) return false;
  }
  return true;
}

class Tube {
 public:
  Tube(const DrivableGrid& grid, const std::vector<std::vector<RoadVertex>>& lines,
       double min_clearance)
      : grid_(grid), min_clearance_(min_clearance) {
    const GridFrame& frame = grid.frame();
    Vector2 low(HUGE_VAL, HUGE_VAL), high(-HUGE_VAL, -HUGE_VAL);
    for_discs(lines, [&](const Vector2& at, double radius) {
      low = low.cwiseMin(Vector2(at.x() - radius, at.y() - radius));
      high = high.cwiseMax(Vector2(at.x() + radius, at.y() + radius));
    });
    const auto cell = [](double value, std::int32_t count) {
      return static_cast<std::int32_t>(std::clamp<double>(std::floor(value), 0, count - 1));
    };
    left_ = cell(low.x(), frame.width), bottom_ = cell(low.y(), frame.height);
    width_ = cell(high.x(), frame.width) - left_ + 1;
    height_ = cell(high.y(), frame.height) - bottom_ + 1;
    if (size() > kMostCells) return;
    inside_.assign(size(), false);
    drivable_.assign(size(), 0);
    for_discs(lines, [&](const Vector2& at, double radius) { mark(at, radius); });
    const RoadVertex &first = lines.front().front(), &last = lines.front().back();
    start_ = Vector2(first.x, first.y), goal_ = Vector2(last.x, last.y);
  }

  std::optional<std::vector<Vector2>> way() {
    if (inside_.empty()) return std::nullopt;
    const auto from = grid_.frame().cell_at(start_.x(), start_.y());
    const auto to = grid_.frame().cell_at(goal_.x(), goal_.y());
    if (!from || !to || !contains(*from) || !contains(*to)) return std::nullopt;
    // Start and goal are where they are, however narrow it is there.
    for (const Cell end : {*from, *to}) {
      inside_[place(end)] = true;
      if (grid_.free(end)) drivable_[place(end)] = 1;
    }
    if (sees(start_, goal_)) return std::vector<Vector2>{start_, goal_};
    const auto cells = search(*from, *to);
    if (cells.empty()) return std::nullopt;
    std::vector<Vector2> points{start_};
    for (std::size_t i = 1; i + 1 < cells.size(); ++i)
      points.push_back(grid_.frame().centre(cells[i]));
    points.push_back(goal_);
    return pulled_straight(points);
  }

 private:
  /// Discs along all lines, in cells, no farther apart than a cell.
  template <class Visit>
  void for_discs(const std::vector<std::vector<RoadVertex>>& lines, const Visit& visit) const {
    const GridFrame& frame = grid_.frame();
    for (const auto& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const RoadVertex &a = line[i], &b = line[std::min(i + 1, line.size() - 1)];
        const double steps =
            std::max(1.0, std::ceil(std::hypot(b.x - a.x, b.y - a.y) / frame.resolution));
        for (double k = 0; k < steps; ++k) {
          const double f = k / steps;
          const double clearance = a.clearance + f * (b.clearance - a.clearance);
          const double radius = std::isfinite(clearance) ? clearance / frame.resolution : 0;
          visit(frame.to_grid(a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)), radius + 2);
        }
      }
    }
  }

  std::size_t size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  bool contains(Cell cell) const {
    return cell.column >= left_ && cell.row >= bottom_ && cell.column < left_ + width_ &&
           cell.row < bottom_ + height_;
  }
  std::uint32_t place(Cell cell) const {
    return static_cast<std::uint32_t>(cell.row - bottom_) * static_cast<std::uint32_t>(width_) +
           static_cast<std::uint32_t>(cell.column - left_);
  }
  Cell cell(std::uint32_t place) const {
    const auto width = static_cast<std::uint32_t>(width_);
    return {left_ + static_cast<std::int32_t>(place % width),
            bottom_ + static_cast<std::int32_t>(place / width)};
  }

  void mark(const Vector2& at, double radius) {
    const auto from = [](double value) { return static_cast<std::int32_t>(std::floor(value)); };
    for (std::int32_t row = from(at.y() - radius); row <= from(at.y() + radius); ++row) {
      const double dy = row + 0.5 - at.y(), square = radius * radius - dy * dy;
      if (square < 0) continue;
      const double half = std::sqrt(square);
      for (std::int32_t column = from(at.x() - half); column <= from(at.x() + half); ++column)
        if (contains({column, row})) inside_[place({column, row})] = true;
    }
  }

  /// Whether a cell is free and far enough from those that are not; asked once a cell.
  bool drivable(Cell cell) {
    if (!contains(cell)) return false;
    std::uint8_t& known = drivable_[place(cell)];
    if (known == 0) {
      const Vector2 centre = grid_.frame().centre(cell);
      known = grid_.free(cell) && (min_clearance_ <= 0 ||
                                   grid_.clearance(centre, min_clearance_) >= min_clearance_)
                  ? 1
                  : 2;
    }
    return known == 1;
  }

  bool sees(const Vector2& a, const Vector2& b) {
    const GridFrame& frame = grid_.frame();
    return walk_line(frame.to_grid(a.x(), a.y()), frame.to_grid(b.x(), b.y()),
                     [this](Cell cell) { return drivable(cell); });
  }

  std::vector<Cell> search(Cell from, Cell to) {
    SearchLabels labels;
    SearchHeap<WayCost> heap;
    labels.resize(static_cast<std::uint32_t>(size()));
    labels.clear();
    const auto bound = [&](Cell cell) {
      const auto dx = static_cast<WayCost>(std::abs(cell.column - to.column));
      const auto dy = static_cast<WayCost>(std::abs(cell.row - to.row));
      return kStraight * (std::max(dx, dy) - std::min(dx, dy)) + kDiagonal * std::min(dx, dy);
    };
    const std::uint32_t first = place(from), last = place(to);
    labels.set(first, 0, first);
    heap.push(bound(from), first);
    while (!heap.empty()) {
      const auto [key, at] = heap.pop();
      const Cell here = cell(at);
      const WayCost cost = labels.cost(at);
      if (key > cost + bound(here)) continue;
      if (at == last) break;
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const Cell next{here.column + dx, here.row + dy};
          if (!contains(next) || !inside_[place(next)] || !drivable(next)) continue;
          const bool diagonal = dx != 0 && dy != 0;
          if (diagonal &&
              (!drivable({here.column + dx, here.row}) || !drivable({here.column, here.row + dy})))
            continue;
          const WayCost further = cost + (diagonal ? kDiagonal : kStraight);
          if (further >= labels.cost(place(next))) continue;
          labels.set(place(next), further, at);
          heap.push(further + bound(next), place(next));
        }
      }
    }
    std::vector<Cell> cells;
    if (!labels.known(last)) return cells;
    for (std::uint32_t at = last; at != first; at = labels.arc(at)) cells.push_back(cell(at));
    cells.push_back(from);
    std::reverse(cells.begin(), cells.end());
    return cells;
  }

  /// Goes to the farthest point it sees of those ahead, then leaves out points as long as lines of
  /// sight allow.
  std::vector<Vector2> pulled_straight(const std::vector<Vector2>& points) {
    std::vector<Vector2> kept{points.front()};
    for (std::size_t i = 0; i + 1 < points.size();) {
      std::size_t next = i + 1;
      while (next + 1 < points.size() && sees(points[i], points[next + 1])) ++next;
      kept.push_back(points[next]);
      i = next;
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 1; i + 1 < kept.size();) {
        if (sees(kept[i - 1], kept[i + 1])) {
          kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
          changed = true;
        } else {
          ++i;
        }
      }
    }
    return kept;
  }

  const DrivableGrid& grid_;
  double min_clearance_;
  std::int32_t left_ = 0, bottom_ = 0, width_ = 0, height_ = 0;
  std::vector<bool> inside_;
  std::vector<std::uint8_t> drivable_;  // 0 not asked yet, 1 yes, 2 no
  Vector2 start_ = Vector2::Zero(), goal_ = Vector2::Zero();
};

}  // namespace

std::optional<std::vector<Vector2>> shortcut_along(
    const DrivableGrid& grid, const std::vector<std::vector<RoadVertex>>& lines,
    double min_clearance) {
  if (lines.empty() || lines.front().empty()) return std::nullopt;
  return Tube(grid, lines, min_clearance).way();
}

bool line_clear(const DrivableGrid& grid, const Vector2& a, const Vector2& b) {
  const GridFrame& frame = grid.frame();
  return walk_line(frame.to_grid(a.x(), a.y()), frame.to_grid(b.x(), b.y()),
                   [&](Cell cell) { return grid.free(cell); });
}

}  // namespace stope::planner
