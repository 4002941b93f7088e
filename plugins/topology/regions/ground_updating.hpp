#pragma once

#include "plugins/topology/named_outlines.hpp"
#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// What of a ground can change in places.
struct Ground::Updating {
  Updating(const FreeSpace& space, const Outlines& traced, const EdgeGrid& edges,
           const Checkpoint& checkpoint);

  NamedOutlines outlines;
  ColumnReach reach;
  PaddedGrid<std::uint8_t> scratch;
  std::size_t names_at_first;
};

}  // namespace stope::topology
