// Problem: where regions grow from: the middle of free space, which is far from obstacles.
// Idea: cells none of whose neighbours is clearer, which only their neighbours decide; in the open
// the first cell of each square. Both are found in any part of a grid by itself, so side by side,
// and after a change where it can be seen.
// Cost: a look at every cell and its neighbours.
#include "plugins/topology/regions/growth_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "plugins/topology/for_each_band.hpp"
#include "stope/random.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kBandRows = 64;

std::int32_t squared_bound(double max_radius) {
  const double squared = std::floor(max_radius * max_radius);
  return static_cast<std::int32_t>(std::clamp(squared, 1.0, 1e9));
}

/// Row after row, a change would pass on from one region to the next through all of a wide yard.
/// In an order that is as good as random, chains of regions that depend on each other are short.
std::uint64_t turn_of_square(std::int32_t column, std::int32_t row) {
  return mix_seed(static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(column));
}

/// Finds middle points in parts of a ground.
class MiddlePoints {
 public:
  MiddlePoints(const Ground& ground, double max_radius)
      : ground_(ground),
        bound_(squared_bound(max_radius)),
        spacing_(spacing_in_the_open(max_radius)),
        steps_(neighbour_steps(ground.stride())) {}

  std::int32_t bound() const { return bound_; }
  std::int32_t spacing() const { return spacing_; }

  /// Those of a row's columns from `left` to before `right` that are not in the open.
  void find(std::int32_t left, std::int32_t right, std::int32_t row,
            std::vector<GrowthPoint>& points) const {
    const std::int32_t* squared = ground_.squared_cells();
    for (CellIndex cell = ground_.index(left, row); left < right; ++left, ++cell) {
      const std::int32_t own = squared[cell];
      if (own == 0 || own >= bound_) continue;
      bool is_middle = true;
      for (const CellIndex step : steps_) is_middle &= squared[cell + step] <= own;
      if (is_middle) points.push_back({cell, left, row, own, 0});
    }
  }

  /// The first cell in the open of each square in a box of whole squares.
  void find_open(std::int32_t left, std::int32_t right, std::int32_t bottom, std::int32_t top,
                 std::vector<GrowthPoint>& points) const {
    const std::int32_t first = left / spacing_;
    // Of the squares in this row of squares: whether the first cell in the open has been passed.
    std::vector<std::uint8_t> has_point(static_cast<std::size_t>((right - left) / spacing_) + 1);
    for (std::int32_t row = bottom; row < top; ++row) {
      if (row % spacing_ == 0) std::fill(has_point.begin(), has_point.end(), std::uint8_t{0});
      for (std::int32_t column = left; column < right; ++column) {
        const CellIndex cell = ground_.index(column, row);
        if (ground_.squared(cell) < bound_) continue;
        const std::int32_t square = column / spacing_;
        auto& passed = has_point[static_cast<std::size_t>(square - first)];
        if (!passed)
          points.push_back({cell, column, row, bound_, turn_of_square(square, row / spacing_)});
        passed = 1;
      }
    }
  }

 private:
  const Ground& ground_;
  std::int32_t bound_, spacing_;
  std::array<CellIndex, 8> steps_;
};

}  // namespace

bool tried_before(const GrowthPoint& a, const GrowthPoint& b) {
  if (a.squared != b.squared) return a.squared > b.squared;
  return a.turn != b.turn ? a.turn < b.turn : a.cell < b.cell;
}

std::int32_t spacing_in_the_open(double max_radius) {
  return std::max(1, static_cast<std::int32_t>(max_radius / 4));
}

bool is_open(std::int32_t squared, double max_radius) {
  return squared >= squared_bound(max_radius);
}

std::vector<GrowthPoint> middle_points(const Ground& ground, double max_radius,
                                       const Checkpoint& checkpoint) {
  const MiddlePoints middle(ground, max_radius);
  // Bands of whole squares, so that none is in two.
  const std::int32_t rows =
      (kBandRows + middle.spacing() - 1) / middle.spacing() * middle.spacing();
  const std::int32_t bands = (ground.height() + rows - 1) / rows;
  std::vector<std::vector<GrowthPoint>> found(static_cast<std::size_t>(bands));
  for_each_band(bands, checkpoint, [&] {
    return [&](std::int32_t band) {
      const std::int32_t end = std::min(ground.height(), (band + 1) * rows);
      auto& points = found[static_cast<std::size_t>(band)];
      for (std::int32_t row = band * rows; row < end; ++row)
        middle.find(0, ground.width(), row, points);
      middle.find_open(0, ground.width(), band * rows, end, points);
    };
  });
  std::vector<GrowthPoint> points;
  for (const auto& those : found) points.insert(points.end(), those.begin(), those.end());
  std::sort(points.begin(), points.end(), tried_before);
  return points;
}

void update_middle_points(const Ground& ground, double max_radius, const ChangedSquares& changed,
                          std::vector<GrowthPoint>& points) {
  const MiddlePoints middle(ground, max_radius);
  const std::int32_t spacing = middle.spacing();
  std::vector<GrowthPoint> now;
  std::vector<std::pair<std::int32_t, std::int32_t>> squares;  // in the open: row, column
  changed.for_each([&](std::int32_t left, std::int32_t bottom) {
    const std::int32_t right = std::min(left + ChangedSquares::kSide, ground.width());
    const std::int32_t top = std::min(bottom + ChangedSquares::kSide, ground.height());
    left = std::max(left, 0), bottom = std::max(bottom, 0);
    if (left >= right || bottom >= top) return;
    for (std::int32_t row = bottom; row < top; ++row) middle.find(left, right, row, now);
    for (std::int32_t y = bottom / spacing; y <= (top - 1) / spacing; ++y)
      for (std::int32_t x = left / spacing; x <= (right - 1) / spacing; ++x)
        squares.emplace_back(y, x);
  });
  std::sort(squares.begin(), squares.end());
  squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
  for (const auto& [y, x] : squares)
    middle.find_open(x * spacing, std::min((x + 1) * spacing, ground.width()), y * spacing,
                     std::min((y + 1) * spacing, ground.height()), now);
  std::erase_if(points, [&](const GrowthPoint& point) {
    if (point.squared < middle.bound()) return changed.touch(point.column, point.row, 0);
    return std::binary_search(squares.begin(), squares.end(),
                              std::pair{point.row / spacing, point.column / spacing});
  });
  std::sort(now.begin(), now.end(), tried_before);
  std::vector<GrowthPoint> all;
  all.reserve(points.size() + now.size());
  std::merge(points.begin(), points.end(), now.begin(), now.end(), std::back_inserter(all),
             tried_before);
  points = std::move(all);
}

std::vector<GrowthPoint> points_at(const Ground& ground, std::vector<CellIndex> cells,
                                   double max_radius) {
  const std::int32_t bound = squared_bound(max_radius);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<GrowthPoint> points;
  for (const CellIndex cell : cells)
    if (ground.free(cell))
      points.push_back(
          {cell, ground.column(cell), ground.row(cell), std::min(bound, ground.squared(cell)), 0});
  std::sort(points.begin(), points.end(), tried_before);
  return points;
}

}  // namespace stope::topology
