#pragma once

#include <cstdint>
#include <optional>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::testing {

enum class Extractor { kVoronoi, kSkeleton, kSkeletonByLambda, kWatershedOfParts, kWatershed };

/// The ones that find dead ends, by name.
struct NamedExtractor {
  const char* name;
  Extractor extractor;
};
inline constexpr NamedExtractor kWithDeadEnds[]{
    {"voronoi", Extractor::kVoronoi},
    {"skeleton", Extractor::kSkeleton},
    {"skeleton by lambda", Extractor::kSkeletonByLambda},
    {"watershed of parts", Extractor::kWatershedOfParts}};

/// What a synthetic pit knows of itself.
struct SyntheticRoads {
  OccupancyGrid grid;  ///< drivable or not
  RoadGraph roads;     ///< centre lines and widths
};

/// The truth of source/synthetic_pit for a side length in metres and, unless the stage's default is
/// meant, an amplitude of freshly dug faces. Throws Error if the stage fails.
SyntheticRoads synthetic_roads(double size, std::uint64_t seed, std::optional<double> rough = {});

/// The same for the quickstart's pit, with the grid as the quickstart maps it: from scans, by
/// cloud, rasterizer, prior and fusion with their default parameters and a road width of 16 m.
SyntheticRoads mapped_roads(std::uint64_t seed);

/// Runs an extractor with its default parameters, but for what makes it the one asked for. Throws
/// Error if it fails.
RoadGraph extract_roads(const OccupancyGrid& grid, Extractor extractor);

}  // namespace stope::testing
