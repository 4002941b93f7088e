#pragma once

#include "plugins/topology/extract_roads.hpp"

namespace stope::topology {

/// Every obstacle counts, however small, and every way, however narrow.
inline ExtractionParams everything() {
  ExtractionParams params;
  params.min_clearance = 0;
  params.min_obstacle_area = 0;
  return params;
}

}  // namespace stope::topology
