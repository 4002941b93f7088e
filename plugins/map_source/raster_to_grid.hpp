#pragma once

#include "plugins/map_source/map_yaml.hpp"
#include "plugins/map_source/raster_reader.hpp"
#include "stope/context.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::map_source {

/// Turns a picture into a grid: the picture's top row becomes the grid's highest. Reports progress
/// and gives up when the run is cancelled. Throws Error where the picture is damaged.
OccupancyGrid raster_to_grid(RasterReader& raster, const MapYaml& map, Context& context);

}  // namespace stope::map_source
