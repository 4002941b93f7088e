#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/checkpoint.hpp"
#include "plugins/topology/padded_grid.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::topology {

/// The label of each cell's name. Cost: three quarters of it are for the payload's fresh memory.
void write_labels(const GridFrame& frame, const PaddedGrid<std::int32_t>& names,
                  const std::vector<std::int32_t>& label_of_name, RegionLabels& labels,
                  const Checkpoint& checkpoint);

}  // namespace stope::topology
