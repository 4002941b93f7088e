#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/regions/tile_parts.hpp"
#include "stope/payloads/label_grid.hpp"

namespace stope::topology {

/// The label of each cell's name; `tiles` are of these names. With the ground, if it is still there
/// and only free cells have names, fewer of them are read.
void write_labels(const GridFrame& frame, const PaddedGrid<std::int32_t>& names,
                  const TileParts& tiles, const std::vector<std::int32_t>& label_of_name,
                  LabelGrid& labels, const Checkpoint& checkpoint, const Ground* ground = nullptr);

}  // namespace stope::topology
