#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "stope/geometry.hpp"

namespace stope {

/// A measured relative pose between two nodes of a pose graph, known by their ids.
struct PoseConstraint {
  static constexpr std::string_view kType = "stope/PoseConstraint@1";
  enum class Kind : std::uint8_t { kOdometry, kLoopClosure, kInertial, kNav };
  std::uint64_t from = 0, to = 0;  ///< node ids
  Pose T_from_to;
  std::array<double, 36>
      information{};  ///< row-major; translation (1/m^2), then rotation (1/rad^2)
  double score = 0;   ///< of a loop closure: the matcher's confidence, 0 to 1
  Kind kind = Kind::kOdometry;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("from", s.from);
    visit("to", s.to);
    visit("T_from_to", s.T_from_to);
    visit("information", s.information);
    visit("score", s.score);
    visit("kind", s.kind);
  }
};

}  // namespace stope
