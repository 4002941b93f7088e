#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stope/payloads/grid_frame.hpp"

namespace stope {

/// Height of the ground per cell in metres; NaN where it is not known.
struct ElevationGrid {
  static constexpr std::string_view kType = "stope/ElevationGrid@1";
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
