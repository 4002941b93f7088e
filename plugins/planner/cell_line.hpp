#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "plugins/planner/cell_box.hpp"
#include "stope/payloads/grid_frame.hpp"

namespace stope::planner {

/// Visits the cells a straight line touches, in order from `a` to `b` (in cells from the grid's
/// lower-left corner), while `visit(Cell)` says so; where it runs through a corner, both cells
/// beside it as well. Returns whether all were visited. Amanatides and Woo 1987.
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

/// The same of the part of a line that lies in a box, of which every cell is visited; for lines
/// that may lead anywhere. To within rounding where the line enters and leaves.
template <class Visit>
void walk_line_in(const CellBox& box, const Vector2& a, const Vector2& b, const Visit& visit) {
  const Vector2 low(box.left, box.bottom), high(box.left + box.width, box.bottom + box.height);
  double from = 0, to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    const double enters = ((way > 0 ? low : high)[axis] - a[axis]) / way;
    const double leaves = ((way > 0 ? high : low)[axis] - a[axis]) / way;
    if (way == 0 && !(a[axis] >= low[axis] && a[axis] <= high[axis])) return;
    if (way == 0) continue;
    from = std::max(from, enters), to = std::min(to, leaves);
  }
  if (!(from <= to)) return;
  const Vector2 begin = from > 0 ? Vector2(a + from * (b - a)) : a;
  const Vector2 end = to < 1 ? Vector2(a + to * (b - a)) : b;
  walk_line(begin, end, [&](Cell cell) {
    if (box.contains(cell)) visit(cell);
    return true;
  });
}

}  // namespace stope::planner
