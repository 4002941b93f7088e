#include "plugins/topology/regions/ground.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "plugins/topology/for_each_band.hpp"
#include "plugins/topology/nearest_outline.hpp"
#include "plugins/topology/regions/ground_updating.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kGap = 64;  // between numbers of outlines; nothing here depends on it
constexpr std::int32_t kBandRows = 64;

double cells_of_area(const OccupancyGrid& grid, double area) {
  return area / (grid.frame.resolution * grid.frame.resolution);
}

}  // namespace

Ground::Ground(const OccupancyGrid& grid, const ExtractionParams& params,
               const Checkpoint& checkpoint)
    : frame_(grid.frame),
      rule_{params.occupied_threshold, params.unknown_is_obstacle},
      least_obstacle_(0),
      space_(make_free_space(grid, rule_, checkpoint)),
      edges_(space_.width(), space_.height()),
      outlines_(trace_outlines(space_, edges_, cells_of_area(grid, params.min_obstacle_area), kGap,
                               checkpoint)),
      squared_(space_.width(), space_.height()) {
  least_obstacle_ = cells_of_area(grid, params.min_obstacle_area);
  find_nearest_outline(space_, outlines_, edges_, checkpoint);
  std::fill_n(squared_.padded_row(-1), stride(), 0);
  std::fill_n(squared_.padded_row(height()), stride(), 0);
  std::atomic<std::size_t> free_cells{0};
  for_each_band((height() + kBandRows - 1) / kBandRows, checkpoint, [&] {
    return [&](std::int32_t band) {
      std::size_t found = 0;
      for (std::int32_t row = band * kBandRows; row < std::min((band + 1) * kBandRows, height());
           ++row) {
        std::int32_t* squared = squared_.padded_row(row);
        squared[0] = squared[stride() - 1] = 0;
        measure(index(0, row), 0, width(), row);
        found += static_cast<std::size_t>(
            std::count_if(squared, squared + stride(), [](std::int32_t s) { return s != 0; }));
      }
      free_cells += found;
    };
  });
  free_cells_ = free_cells;
}

Ground::~Ground() = default;
Ground::Ground(Ground&&) noexcept = default;
Ground& Ground::operator=(Ground&&) noexcept = default;

void Ground::measure(CellIndex first, std::int32_t column, std::int32_t count, std::int32_t row) {
  const auto* places =
      updating_ ? updating_->outlines.by_name.place.data() : outlines_.place.data();
  for (std::int32_t i = 0; i < count; ++i) {
    const CellIndex cell = first + i;
    squared_[cell] = 0;
    if (!free(cell)) continue;
    const Outlines::Place place = places[edges_[cell]];
    const std::int32_t dx = column + i - place.column, dy = row - place.row;
    squared_[cell] = dx * dx + dy * dy;
  }
}

double Ground::distance_at(double x, double y) const {
  const auto& places = updating_ ? updating_->outlines.by_name.place : outlines_.place;
  const auto column = static_cast<std::int32_t>(std::floor(x));
  const auto row = static_cast<std::int32_t>(std::floor(y));
  double least = -1;  // squared
  for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, height() - 1); ++r) {
    for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, width() - 1); ++c) {
      const CellIndex cell = index(c, r);
      if (!free(cell)) continue;
      const auto place = places[static_cast<std::size_t>(edges_[cell])];
      const double dx = x - place.column - 0.5, dy = y - place.row - 0.5;
      const double there = dx * dx + dy * dy;
      least = least < 0 ? there : std::min(least, there);
    }
  }
  return std::sqrt(std::max(least, 0.0));
}

RegionCells without_regions(const Ground& ground) {
  RegionCells cells(ground.width(), ground.height());
  std::fill_n(cells.data(), cells.size(), 0);
  return cells;
}

}  // namespace stope::topology
