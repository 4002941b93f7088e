#pragma once

#include "plugins/topology/regions/ground.hpp"

namespace stope::topology {

/// When two rooms are two.
struct DoorRule {
  double door_ratio = 0.93;     ///< a door's clearance over that of the narrower room, at most
  double similar_ratio = 0.8;  ///< … and over the geometric mean of both, at most
  double least_area = 20;      ///< cells of the smallest room; smaller ones join a neighbour
};

/// Divides free space at the doors: the places where the clearance along a way from one room to
/// another is least: at most door_ratio of the clearest place of the narrower room, and
/// similar_ratio of the geometric mean of both, so that pieces of one corridor stay together where
/// a corridor and a hall are told apart. Returns regions counted from 1.
RegionCells divide_at_doors(const Ground& ground, const DoorRule& rule, std::int32_t& count,
                            const Checkpoint& checkpoint);

}  // namespace stope::topology
