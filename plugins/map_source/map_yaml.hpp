#pragma once

#include <filesystem>

#include "plugins/map_source/cell_rule.hpp"
#include "stope/geometry.hpp"

namespace stope::map_source {

/// What a map_server yaml file says.
struct MapYaml {
  std::filesystem::path image;  ///< absolute, or as the yaml's own folder makes it
  double resolution = 0;        ///< metres a cell
  Pose2 origin;                 ///< of the picture's lower-left corner, metres and radians
  CellRule rule;
};

/// Reads a map yaml. As nav2 it asks for image, resolution, origin, negate, occupied_thresh and
/// free_thresh; mode may be left out (trinary). Throws Error, naming the key and the line.
MapYaml read_map_yaml(const std::filesystem::path& file);

}  // namespace stope::map_source
