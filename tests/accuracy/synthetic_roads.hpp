#pragma once

#include <cstdint>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::testing {

enum class Extractor { kVoronoi, kWatershed };

/// What a synthetic pit knows of itself.
struct SyntheticRoads {
  OccupancyGrid grid;  ///< drivable or not
  RoadGraph roads;     ///< centre lines and widths
};

/// The truth of source/synthetic_pit for a side length in metres. Throws Error if the stage fails.
SyntheticRoads synthetic_roads(double size, std::uint64_t seed);

/// The same for the quickstart's pit, with the grid as the quickstart maps it: from scans, by
/// cloud, rasterizer, prior and fusion with their default parameters and a road width of 16 m.
SyntheticRoads mapped_roads(std::uint64_t seed);

/// Runs an extractor with its default parameters. Throws Error if it fails.
RoadGraph extract_roads(const OccupancyGrid& grid, Extractor extractor);

}  // namespace stope::testing
