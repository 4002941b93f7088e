#include "plugins/map_source/cell_rule.hpp"

#include <cmath>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::map_source {

std::uint8_t CellRule::cell(double shade, bool transparent) const {
  if (mode == MapMode::kRaw) {
    const double percent = std::round(shade * 255.0);
    if (percent > 100.0) return OccupancyGrid::kUnknown;
    return static_cast<std::uint8_t>(std::lround(percent * OccupancyGrid::kOccupied / 100.0));
  }
  if (mode == MapMode::kScale && transparent) return OccupancyGrid::kUnknown;
  const double occupied = negate ? shade : 1.0 - shade;
  if (occupied > occupied_thresh) return OccupancyGrid::kOccupied;
  if (occupied < free_thresh) return OccupancyGrid::kFree;
  if (mode == MapMode::kTrinary) return OccupancyGrid::kUnknown;
  const double probability = (occupied - free_thresh) / (occupied_thresh - free_thresh);
  return static_cast<std::uint8_t>(std::lround(probability * OccupancyGrid::kOccupied));
}

}  // namespace stope::map_source
