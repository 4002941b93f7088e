#pragma once

#include <vector>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::planner {

/// A rectangle in the map frame, by corners; used to say which part of a map matters.
struct MapBox {
  double left = 0, bottom = 0, right = 0, top = 0;
};

/// How far obstacles are, over the part of a grid around a route: signed distances from the centres
/// of cells of about half a metre, positive where it is free. A cell counts as an obstacle if any
/// cell of the grid in it is one, so distances are never too long by more than is stated. What lies
/// outside of the map is an obstacle.
class ClearanceField {
 public:
  /// Looks at the part of the grid within `reach` metres of the box. O(cells).
  ClearanceField(const OccupancyGrid& grid, const MapBox& box, double reach);

  struct Value {
    double distance = 0;              ///< metres, negative in obstacles
    Vector2 slope = Vector2::Zero();  ///< of the distance, map frame
  };
  /// Interpolated between cell centres; beyond the field's edge the edge's value.
  Value at(double x, double y) const;
  /// No obstacle is nearer to the point than this.
  double at_least(double x, double y) const;
  double cell() const { return cell_; }

  // The field's cells, for searches over it.
  std::int32_t width() const { return width_; }
  std::int32_t height() const { return height_; }
  double distance(std::int32_t column, std::int32_t row) const {
    return distances_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(column)];
  }
  /// A map point in cells of the field, from its lower-left corner.
  Vector2 to_field(double x, double y) const {
    const double dx = x - origin_.x(), dy = y - origin_.y();
    return {(cos_ * dx + sin_ * dy) / cell_, (-sin_ * dx + cos_ * dy) / cell_};
  }

 private:
  double cos_ = 1, sin_ = 0, cell_ = 0.5;
  Vector2 origin_ = Vector2::Zero();
  std::int32_t width_ = 0, height_ = 0;
  std::vector<float> distances_;
};

}  // namespace stope::planner
