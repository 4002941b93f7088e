#pragma once

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// When two rooms are two.
struct DoorRule {
  double door_ratio = 0.9;  ///< a door's clearance over that of the smaller room, at most
  double least_area = 20;   ///< cells of the smallest room; smaller ones join a neighbour
};

/// Divides free space at the doors: the places where the clearance along a way from one room to
/// another is least, at most door_ratio of what both rooms have. Returns regions counted from 1.
RegionCells divide_at_doors(const Ground& ground, const DoorRule& rule, std::int32_t& count,
                            const Checkpoint& checkpoint);

}  // namespace stope::topology
