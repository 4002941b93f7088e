#pragma once

#include <string>

#include "plugins/export/region_colours.hpp"
#include "plugins/export/region_pieces.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::exports {

/// What the yaml beside a conical map's picture says of its values.
struct ConicalSettings {
  std::string image;     ///< the picture's file name
  int floor = 89;        ///< chroma of free cells, of 255
  bool trinary = true;   ///< no other cells than free, occupied and unknown
  bool measured = true;  ///< occupancy is a grid's; else regions are taken to be free, the rest
                         ///< unknown
};

/// The yaml: the keys of Wang et al., sec. 3.3, and all that the picture cannot say.
std::string conical_yaml(const RegionMap& map, const RegionPieces& pieces,
                         const RegionColours& colours, const ConicalSettings& settings);

}  // namespace stope::exports
