// Problem: a planner asks thousands of times how far the nearest obstacle is, and which way.
// Idea: the exact signed distance transform (Felzenszwalb and Huttenlocher 2012) of the part of the
// grid around the route, on cells of about half a metre whatever the grid's own; what a cell hides
// is bounded by half its diagonal.
// Cost: O(cells of the part), 4 bytes each, and twice a row of them in between.
#include "plugins/planner/clearance_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stope::planner {
namespace {

constexpr double kTarget = 0.5;     // metres a cell
constexpr double kMostCells = 4e7;  // coarser beyond
constexpr float kFar = 1e6F;        // cells

/// Squared distances along one row or column: the lower envelope of parabolas.
class LineTransform {
 public:
  explicit LineTransform(std::size_t length) : place_(length), from_(length + 1), value_(length) {}
  template <class Get, class Set>
  void run(std::size_t length, const Get& get, const Set& set) {
    for (std::size_t i = 0; i < length; ++i) value_[i] = get(i);
    std::size_t top = 0;
    place_[0] = 0;
    from_[0] = -1e30, from_[1] = 1e30;
    for (std::size_t q = 1; q < length; ++q) {
      double cross = crossing(q, place_[top]);
      while (cross <= from_[top]) cross = crossing(q, place_[--top]);
      place_[++top] = q;
      from_[top] = cross, from_[top + 1] = 1e30;
    }
    top = 0;
    for (std::size_t q = 0; q < length; ++q) {
      while (from_[top + 1] < static_cast<double>(q)) ++top;
      const double d = static_cast<double>(q) - static_cast<double>(place_[top]);
      set(q, d * d + value_[place_[top]]);
    }
  }

 private:
  double crossing(std::size_t q, std::size_t p) const {
    const auto a = static_cast<double>(q), b = static_cast<double>(p);
    return ((value_[q] + a * a) - (value_[p] + b * b)) / (2 * a - 2 * b);
  }
  std::vector<std::size_t> place_;
  std::vector<double> from_, value_;
};

/// Distance of each cell's centre to that of the nearest cell of a kind, in cells.
std::vector<float> distance_to(const std::vector<std::uint8_t>& kinds, std::uint8_t kind,
                               std::size_t width, std::size_t height) {
  std::vector<float> squared(kinds.size());
  constexpr double kNone = 1e12;
  LineTransform along(std::max(width, height));
  for (std::size_t column = 0; column < width; ++column) {
    along.run(
        height, [&](std::size_t row) { return kinds[row * width + column] == kind ? 0.0 : kNone; },
        [&](std::size_t row, double value) {
          squared[row * width + column] = static_cast<float>(value);
        });
  }
  for (std::size_t row = 0; row < height; ++row) {
    along.run(
        width, [&](std::size_t column) { return squared[row * width + column]; },
        [&](std::size_t column, double value) {
          squared[row * width + column] = std::min(static_cast<float>(std::sqrt(value)), kFar);
        });
  }
  return squared;
}

}  // namespace

ClearanceField::ClearanceField(const OccupancyGrid& grid, const MapBox& box, double reach) {
  const GridFrame& frame = grid.frame;
  cos_ = std::cos(frame.origin.yaw), sin_ = std::sin(frame.origin.yaw);
  double left = 1e300, bottom = 1e300, right = -1e300, top = -1e300;
  for (const auto& [x, y] : {std::pair{box.left, box.bottom}, std::pair{box.right, box.bottom},
                             std::pair{box.left, box.top}, std::pair{box.right, box.top}}) {
    const Vector2 at = frame.to_grid(x, y);
    left = std::min(left, at.x()), right = std::max(right, at.x());
    bottom = std::min(bottom, at.y()), top = std::max(top, at.y());
  }
  const double around = reach / frame.resolution;
  const auto low = [&](double value, std::int32_t most) {
    return static_cast<std::int32_t>(std::clamp(std::floor(value - around), 0.0, double(most)));
  };
  const auto high = [&](double value, std::int32_t most) {
    return static_cast<std::int32_t>(std::clamp(std::ceil(value + around), 0.0, double(most)));
  };
  const std::int32_t first_column = low(left, frame.width), first_row = low(bottom, frame.height);
  const std::int32_t columns = std::max(0, high(right, frame.width) - first_column);
  const std::int32_t rows = std::max(0, high(top, frame.height) - first_row);

  std::int32_t factor = std::max(1, static_cast<std::int32_t>(kTarget / frame.resolution + 1e-6));
  while (double(columns) * rows / (double(factor) * factor) > kMostCells) ++factor;
  cell_ = factor * frame.resolution;
  // One ring of obstacle around: nothing is planned beyond the part.
  width_ = (columns + factor - 1) / factor + 2, height_ = (rows + factor - 1) / factor + 2;
  origin_ = frame.to_map(first_column - factor, first_row - factor);

  const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
  std::vector<std::uint8_t> blocked(width * height, 1);
  for (std::size_t row = 1; row + 1 < height; ++row)
    std::fill_n(blocked.begin() + static_cast<std::ptrdiff_t>(row * width + 1), width - 2, 0);
  for (std::int32_t row = 0; row < rows; ++row) {
    const std::size_t field_row = static_cast<std::size_t>(row / factor) + 1;
    const std::uint8_t* cells = &grid.cells[frame.place({first_column, first_row + row})];
    for (std::int32_t column = 0; column < columns; ++column) {
      if (cells[column] >= 127)
        blocked[field_row * width + static_cast<std::size_t>(column / factor) + 1] = 1;
    }
  }
  distances_ = distance_to(blocked, 1, width, height);
  const std::vector<float> inside = distance_to(blocked, 0, width, height);
  for (std::size_t i = 0; i < distances_.size(); ++i) {
    // The border between two cells lies half a cell before either's centre.
    distances_[i] =
        static_cast<float>(cell_) * (blocked[i] ? -(inside[i] - 0.5F) : distances_[i] - 0.5F);
  }
}

ClearanceField::Value ClearanceField::at(double x, double y) const {
  const Vector2 at = to_field(x, y);
  const double u = std::clamp(at.x() - 0.5, 0.0, width_ - 1.001);
  const double v = std::clamp(at.y() - 0.5, 0.0, height_ - 1.001);
  const auto column = static_cast<std::int32_t>(u), row = static_cast<std::int32_t>(v);
  const double a = u - column, b = v - row;
  const double d00 = distance(column, row), d10 = distance(column + 1, row);
  const double d01 = distance(column, row + 1), d11 = distance(column + 1, row + 1);
  const double low = d00 + a * (d10 - d00), high = d01 + a * (d11 - d01);
  const double du = ((1 - b) * (d10 - d00) + b * (d11 - d01)) / cell_;
  const double dv = (high - low) / cell_;
  return {low + b * (high - low), {cos_ * du - sin_ * dv, sin_ * du + cos_ * dv}};
}

double ClearanceField::at_least(double x, double y) const {
  const Vector2 at = to_field(x, y);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < width_ && at.y() < height_)) return 0;
  const double value =
      distance(static_cast<std::int32_t>(at.x()), static_cast<std::int32_t>(at.y()));
  // From any place of its cell to any place of the obstacle's: a whole diagonal, of which half a
  // cell was taken off already.
  return std::max(0.0, value - (std::numbers::sqrt2 - 0.5) * cell_);
}

}  // namespace stope::planner
