#include "plugins/planner/shortcut_ground.hpp"

#include <algorithm>

#include "plugins/planner/cell_line.hpp"

namespace stope::planner {

ShortcutGround::ShortcutGround(const DrivableGrid& grid, const RoadGround& roads,
                               const CellBox& box, const std::vector<RoadVertex>& route,
                               double min_clearance)
    : grid_(grid),
      roads_(roads),
      box_(box),
      min_clearance_(min_clearance),
      known_(box.size(), Known::kNotAsked) {
  for (std::size_t i = 0; i < route.size(); ++i) {
    const RoadVertex &a = route[i], &b = route[std::min(i + 1, route.size() - 1)];
    walk_line_in(box_, frame().to_grid(a.x, a.y), frame().to_grid(b.x, b.y), [&](Cell cell) {
      known_[box_.place(cell)] = grid.free(cell) ? Known::kYes : Known::kNo;
    });
  }
}

bool ShortcutGround::has_room(Cell cell) const {
  return grid_.free(cell) &&
         (min_clearance_ <= 0 ||
          grid_.clearance(frame().centre(cell), min_clearance_) >= min_clearance_);
}

std::optional<double> ShortcutGround::cost_of_sight(const Vector2& a, const Vector2& b) {
  const Vector2 from = frame().to_grid(a.x(), a.y()), to = frame().to_grid(b.x(), b.y());
  std::optional<Cell> before;
  double count = 0, sum = 0;
  const bool clear = walk_line(from, to, [&](Cell cell) {
    if (!drivable(cell)) return false;
    if (!roads_.open()) {
      if (before && !roads_.passable(*before, cell, to - from)) return false;
      before = cell;
      sum += roads_.factor(cell), count += 1;
    }
    return true;
  });
  if (!clear) return std::nullopt;
  return (b - a).norm() * (count > 0 ? sum / count : 1);
}

}  // namespace stope::planner
