#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/geometry.hpp"

namespace stope {

/// A sparse voxel map made of nodes (submaps): each node owns a run of 8x8x8 bricks, each brick 512
/// voxels, in the node's own frame, so that correcting a node's pose moves its voxels without
/// touching them.
struct VoxelMap {
  static constexpr std::string_view kType = "stope/VoxelMap@1";
  double resolution = 0.2;                 ///< metres a voxel
  std::vector<std::uint64_t> node_ids;     ///< strictly increasing
  std::vector<Pose> T_map_node;            ///< by node
  std::vector<std::uint64_t> brick_begin;  ///< by node, plus one past the last
  std::vector<std::int32_t>
      brick_place;  ///< x, y, z of each brick in bricks, ordered by (z, y, x) in a node
  std::vector<std::uint8_t> occupancy;  ///< 512 a brick, x fastest; as OccupancyGrid
  static constexpr void fields(auto& s, auto&& visit) {
    visit("resolution", s.resolution);
    visit("node_ids", s.node_ids);
    visit("T_map_node", s.T_map_node);
    visit("brick_begin", s.brick_begin);
    visit("brick_place", s.brick_place);
    visit("occupancy", s.occupancy);
  }
};

}  // namespace stope
