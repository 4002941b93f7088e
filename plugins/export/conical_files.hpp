#pragma once

#include <string>

#include "stope/context.hpp"
#include "stope/payloads/artefact.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::exports {

/// How a conical map is written.
struct ConicalStyle {
  std::string stem = "map";  ///< the files' name without its ending
  double floor = 0.35;       ///< saturation of free cells, 0.0118 … 0.5
};

/// The picture (PPM) and the yaml of a conical map. Without a grid, regions are free and the rest
/// is unknown. Throws Error where the regions are not as a RegionMap has them, or are not the
/// grid's.
Artefact conical_files(const RegionMap& regions, const OccupancyGrid* grid,
                       const ConicalStyle& style, Context& context);

}  // namespace stope::exports
