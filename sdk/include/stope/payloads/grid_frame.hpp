#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "stope/geometry.hpp"

namespace stope {

/// A cell of a grid by column (along x of the grid) and row (along y); row 0 is the lowest.
struct Cell {
  std::int32_t column = 0, row = 0;
  bool operator==(const Cell&) const = default;
};

/// Where a grid lies: row-major cells, row 0 lowest, `origin` the pose of the outer lower-left
/// corner of cell (0, 0) in the map frame (as map_server has it), so that a cell's centre is half a
/// cell further.
struct GridFrame {
  std::int32_t width = 0, height = 0;  ///< cells
  double resolution = 1.0;             ///< metres a cell
  Pose2 origin;

  bool operator==(const GridFrame&) const = default;
  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t place(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.column);
  }
  bool contains(Cell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width && cell.row < height;
  }
  /// Map coordinates of a point given in cells from the lower-left corner.
  Vector2 to_map(double column, double row) const {
    const double x = column * resolution, y = row * resolution;
    const double c = std::cos(origin.yaw), s = std::sin(origin.yaw);
    return {origin.x + c * x - s * y, origin.y + s * x + c * y};
  }
  Vector2 centre(Cell cell) const { return to_map(cell.column + 0.5, cell.row + 0.5); }
  /// A map point in cells from the lower-left corner.
  Vector2 to_grid(double x, double y) const {
    const double dx = x - origin.x, dy = y - origin.y;
    const double c = std::cos(origin.yaw), s = std::sin(origin.yaw);
    return {(c * dx + s * dy) / resolution, (-s * dx + c * dy) / resolution};
  }
  /// The cell that holds a map point, if it is on the grid.
  std::optional<Cell> cell_at(double x, double y) const {
    const Vector2 point = to_grid(x, y);
    if (!(point.x() >= 0 && point.y() >= 0 && point.x() < width && point.y() < height))
      return std::nullopt;
    return Cell{static_cast<std::int32_t>(point.x()), static_cast<std::int32_t>(point.y())};
  }
  static constexpr void fields(auto& s, auto&& visit) {
    visit("width", s.width);
    visit("height", s.height);
    visit("resolution", s.resolution);
    visit("origin", s.origin);
  }
};

/// The part of a grid that differs from the grid of an earlier item of the same stream.
struct ChangedWindow {
  std::int32_t column = 0, row = 0, width = 0, height = 0;  ///< cells
  std::uint64_t since = 0;  ///< index of the item it is compared with
  static constexpr void fields(auto& s, auto&& visit) {
    visit("column", s.column);
    visit("row", s.row);
    visit("width", s.width);
    visit("height", s.height);
    visit("since", s.since);
  }
};

}  // namespace stope
