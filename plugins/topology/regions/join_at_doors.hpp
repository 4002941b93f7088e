#pragma once

#include <vector>

#include "plugins/topology/regions/basins.hpp"
#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// When two rooms are two.
struct DoorRule {
  double door_ratio = 0.93;    ///< a door's clearance over that of the narrower room, at most
  double similar_ratio = 0.8;  ///< … and over the geometric mean of both, at most
  double hub_ratio = 1.0;  ///< two hubs at least so open to each other, of the wider one, are one
  double least_area = 20;  ///< cells of the smallest room; smaller ones join a neighbour
  std::int32_t least_squared = 1;  ///< squared clearance of the narrowest way that counts as one
};

/// Makes rooms of basins: those stay apart between which the clearest way leads through a door, a
/// place at most door_ratio as clear as the clearest of the narrower room, and at most
/// similar_ratio as clear as the geometric mean of both, so that pieces of one corridor stay
/// together where a corridor and a hall are told apart. A place too narrow for a way is a door
/// between any two where there are ways, or a road could not be found through a room that has one.
/// Of those, two that have three or more neighbours each are hubs, pieces of corridors, and become
/// one if the door is at least hub_ratio as clear as the clearest place of both. Rooms are numbered
/// from the clearest on. `contacts` are those of all tiles, the clearest first.
RegionSet join_at_doors(const Ground& ground, const Basins& basins, const TileParts& tiles,
                        const std::vector<Contact>& contacts, const DoorRule& rule,
                        const Checkpoint& checkpoint);

}  // namespace stope::topology
