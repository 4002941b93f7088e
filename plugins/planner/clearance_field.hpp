#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::planner {

/// A rectangle in the map frame, by corners; used to say which part of a map matters.
struct MapBox {
  double left = 0, bottom = 0, right = 0, top = 0;
};

/// How far obstacles are, over the part of a grid around a route: signed distances from the centres
/// of cells of about half a metre, positive where it is free. A cell counts as an obstacle if any
/// cell of the grid in it is one, so distances are never too long by more than is stated; those
/// beyond `most` metres are given as about that. What lies outside of the map is an obstacle.
class ClearanceField {
 public:
  static constexpr double kMost = 12;
  /// Looks at the part of the grid within `reach` metres of the box. O(cells).
  ClearanceField(const OccupancyGrid& grid, const MapBox& box, double reach, double most = kMost);
  /// Looks no farther than about `reach` metres from a line's points, which are no farther than
  /// that from each other. O(cells looked at).
  ClearanceField(const OccupancyGrid& grid, const std::vector<Vector2>& line, double reach,
                 double most = kMost);

  struct Value {
    double distance = 0;              ///< metres, negative in obstacles
    Vector2 slope = Vector2::Zero();  ///< of the distance, map frame
  };
  /// Interpolated between cell centres; beyond the field's edge the edge's value, and where nobody
  /// looked as if obstacles were far.
  Value at(double x, double y) const;
  /// No obstacle is nearer to the point than this.
  double at_least(double x, double y) const;
  double cell() const { return cell_; }

  // The field's cells, for searches over it.
  std::int32_t width() const { return width_; }
  std::int32_t height() const { return height_; }
  /// 0 where nobody looked.
  double distance(std::int32_t column, std::int32_t row) const {
    return known(column, row) ? stored(column, row) : 0;
  }
  /// A map point in cells of the field, from its lower-left corner.
  Vector2 to_field(double x, double y) const {
    const double dx = x - origin_.x(), dy = y - origin_.y();
    return {(cos_ * dx + sin_ * dy) / cell_, (-sin_ * dx + cos_ * dy) / cell_};
  }

 private:
  static constexpr std::int32_t kTile = 64;  // cells
  void lay_out(const OccupancyGrid& grid, const MapBox& box, double reach);
  void fill(const OccupancyGrid& grid, double most);
  void fill_tiles(const OccupancyGrid& grid, std::int32_t tile_row, std::int32_t first,
                  std::int32_t count);
  bool known(std::int32_t column, std::int32_t row) const {
    return tiles_[static_cast<std::size_t>(row / kTile) * static_cast<std::size_t>(tile_columns_) +
                  static_cast<std::size_t>(column / kTile)] != 0;
  }
  std::size_t place(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }
  double stored(std::int32_t column, std::int32_t row) const {
    return distances_[place(column, row)];
  }

  double cos_ = 1, sin_ = 0, cell_ = 0.5;
  Vector2 origin_ = Vector2::Zero();
  std::int32_t width_ = 0, height_ = 0, tile_columns_ = 0, tile_rows_ = 0;
  std::int32_t factor_ = 1, first_column_ = 0, first_row_ = 0;  // of the grid's cells
  std::int32_t columns_ = 0, rows_ = 0;                         // of the grid looked at
  std::int32_t reach_ = 0;                                      // cells of the field
  double far_ = kMost;                                          // metres, of what is not looked at
  std::vector<std::uint8_t> tiles_;  // of each square of kTile cells: whether it was looked at
  // Not written, and so not even held in memory, where nobody looked.
  std::unique_ptr<float[]> distances_;
};

}  // namespace stope::planner
