#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stope/payloads/grid_frame.hpp"

namespace stope {

/// Probability of an obstacle per cell: 0 to 254 means value / 254, 255 is unknown. Unknown is
/// never free.
struct OccupancyGrid {
  static constexpr std::string_view kType = "stope/OccupancyGrid@1";
  static constexpr std::uint8_t kFree = 0, kOccupied = 254, kUnknown = 255;
  GridFrame frame;
  std::vector<std::uint8_t> cells;       ///< row-major, row 0 lowest
  std::optional<ChangedWindow> changed;  ///< none: all of it may differ from earlier items
  static constexpr void fields(auto& s, auto&& visit) {
    visit("frame", s.frame);
    visit("cells", s.cells);
    visit("changed", s.changed);
  }
};

}  // namespace stope
