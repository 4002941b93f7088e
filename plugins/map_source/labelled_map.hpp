#pragma once

#include <string>
#include <vector>

#include "plugins/map_source/colour_pieces.hpp"
#include "plugins/map_source/conical_yaml.hpp"
#include "plugins/map_source/painted_map.hpp"

namespace stope::map_source {

/// The regions of a conical map that Stope wrote: the yaml says which piece of colour is whose.
/// Throws Error where picture and yaml disagree.
RegionMap written_regions(const ConicalYaml& map, const PaintedMap& painted,
                          const ColourPieces& pieces);

/// The regions of a conical map by the paper's own rules: a piece of colour belongs to the vertex
/// whose pixel is in it; area and axes are measured. Sentences for the operator go to `warnings`.
/// Throws Error where a piece's hue is no vertex's.
RegionMap painted_regions(const ConicalYaml& map, const PaintedMap& painted,
                          const ColourPieces& pieces, std::vector<std::string>& warnings);

}  // namespace stope::map_source
