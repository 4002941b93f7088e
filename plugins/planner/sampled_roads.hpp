#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plugins/planner/free_ground.hpp"

namespace stope::planner {

/// Adds roads through free ground to a graph, found by OMPL's PRM: the graph's open road nodes are
/// its milestones, `samples` random ones near roads are added, and each is joined to those of its
/// `neighbours` nearest that it sees. Added roads have id 0. The same for the same seed, on any
/// machine that counts alike; uses neither a second thread nor time.
void add_prm_roads(RoadGraph& roads, const FreeGround& ground, const RoadNetwork& network,
                   std::uint32_t samples, std::uint32_t neighbours, std::uint64_t seed);

/// The shortest way from a point to another through free ground that OMPL's BIT* finds in
/// `iterations` steps: the vertices of the roads are its first samples, random ones near roads
/// follow. None if it finds none. The nearest-neighbour tree of OMPL 1.5's BIT* picks its pivots
/// with a generator that cannot be seeded or replaced, so equal distances may be told apart
/// differently from run to run.
std::optional<std::vector<Vector2>> bit_star_way(const FreeGround& ground,
                                                 const RoadNetwork& network, const Vector2& start,
                                                 const Vector2& goal, std::uint32_t iterations,
                                                 std::uint32_t batch, std::uint64_t seed);

/// Adds a way as one road between two new nodes.
void add_way(RoadGraph& roads, const std::vector<Vector2>& way, const FreeGround& ground);

}  // namespace stope::planner
