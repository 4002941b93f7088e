#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stope/payloads/grid_frame.hpp"

namespace stope {

/// Distance of each cell's centre to the nearest obstacle cell's centre, in metres; 0 in obstacles.
struct DistanceGrid {
  static constexpr std::string_view kType = "stope/DistanceGrid@1";
  GridFrame frame;
  std::vector<float> cells;              ///< row-major, row 0 lowest
  std::optional<ChangedWindow> changed;  ///< none: all of it may differ from earlier items
  static constexpr void fields(auto& s, auto&& visit) {
    visit("frame", s.frame);
    visit("cells", s.cells);
    visit("changed", s.changed);
  }
};

}  // namespace stope
