#pragma once

#include <cstdint>
#include <vector>

#include "plugins/map_source/conical_yaml.hpp"
#include "stope/context.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::map_source {

/// The picture of a conical map, read: what each cell holds, and which hue each pixel has.
struct PaintedMap {
  OccupancyGrid grid;
  std::vector<std::int16_t> hues;  ///< row-major, row 0 at the top; -1: none
};

/// Reads the picture of a conical map. Reports progress and gives up when the run is cancelled.
/// Throws Error where the picture is damaged, has another size than the yaml says, or holds a
/// colour that no map of this kind has.
PaintedMap read_painted_map(const ConicalYaml& map, Context& context);

}  // namespace stope::map_source
