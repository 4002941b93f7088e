#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/payloads/pose_constraint.hpp"
#include "stope/time.hpp"

namespace stope {

/// A node of a pose graph.
struct PoseNode {
  std::uint64_t id = 0;
  Stamp stamp = 0;
  Pose T_map_node;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("id", s.id);
    visit("stamp", s.stamp);
    visit("T_map_node", s.T_map_node);
  }
};

/// Poses and the constraints between them.
struct PoseGraph {
  static constexpr std::string_view kType = "stope/PoseGraph@1";
  std::vector<PoseNode> nodes;  ///< ids strictly increasing
  std::vector<PoseConstraint> constraints;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("nodes", s.nodes);
    visit("constraints", s.constraints);
  }
};

}  // namespace stope
