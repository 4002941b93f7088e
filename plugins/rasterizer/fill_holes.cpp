#include "plugins/rasterizer/fill_holes.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace stope::rasterizer {
namespace {

/// One hole, as a flood over unknown cells finds it.
struct Hole {
  std::vector<Cell> cells;
  bool enclosed = true;                                             // by free cells alone
  float low = std::numeric_limits<float>::infinity(), high = -low;  // of the ground round it
  Cell least, most;                                                 // its box
};

class HoleFinder {
 public:
  HoleFinder(const OccupancyGrid& grid, const LocalGround& ground)
      : grid_(grid), ground_(ground), seen_(grid.cells.size(), false) {}

  bool fresh(Cell cell) const { return unknown(cell) && !seen_[grid_.frame.place(cell)]; }

  Hole find(Cell start) {
    Hole hole;
    hole.least = hole.most = start;
    take(hole, start);
    for (std::size_t next = 0; next < hole.cells.size(); ++next) {
      const Cell cell = hole.cells[next];
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) visit(hole, {cell.column + dx, cell.row + dy});
      }
    }
    return hole;
  }

 private:
  bool unknown(Cell cell) const {
    return grid_.cells[grid_.frame.place(cell)] == OccupancyGrid::kUnknown;
  }
  void take(Hole& hole, Cell cell) {
    seen_[grid_.frame.place(cell)] = true;
    hole.cells.push_back(cell);
    hole.least = {std::min(hole.least.column, cell.column), std::min(hole.least.row, cell.row)};
    hole.most = {std::max(hole.most.column, cell.column), std::max(hole.most.row, cell.row)};
  }
  void visit(Hole& hole, Cell cell) {
    if (!grid_.frame.contains(cell)) {
      hole.enclosed = false;
    } else if (unknown(cell)) {
      if (!seen_[grid_.frame.place(cell)]) take(hole, cell);
    } else if (grid_.cells[grid_.frame.place(cell)] != OccupancyGrid::kFree) {
      hole.enclosed = false;
    } else {
      const Vector2 centre = grid_.frame.centre(cell);
      const auto under = ground_.frame.cell_at(centre.x(), centre.y());
      if (!under) return;
      const float height = ground_.height[ground_.frame.place(*under)];
      hole.low = std::min(hole.low, height);
      hole.high = std::max(hole.high, height);
    }
  }

  const OccupancyGrid& grid_;
  const LocalGround& ground_;
  std::vector<bool> seen_;
};

}  // namespace

void fill_holes(OccupancyGrid& grid, const LocalGround& ground, double most_area, double most_step,
                double slope) {
  const double resolution = grid.frame.resolution;
  HoleFinder finder(grid, ground);
  for (std::int32_t row = 0; row < grid.frame.height; ++row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      if (!finder.fresh({column, row})) continue;
      const Hole hole = finder.find({column, row});
      const double area = static_cast<double>(hole.cells.size()) * resolution * resolution;
      const double width = resolution * (1 + std::max(hole.most.column - hole.least.column,
                                                      hole.most.row - hole.least.row));
      if (!hole.enclosed || area > most_area || hole.high - hole.low > most_step + slope * width)
        continue;
      for (const Cell& cell : hole.cells) grid.cells[grid.frame.place(cell)] = OccupancyGrid::kFree;
    }
  }
}

}  // namespace stope::rasterizer
