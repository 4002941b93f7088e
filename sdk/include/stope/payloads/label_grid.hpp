#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stope/payloads/grid_frame.hpp"

namespace stope {

/// A class or region per cell; 0 is none.
struct LabelGrid {
  static constexpr std::string_view kType = "stope/LabelGrid@1";
  GridFrame frame;
  std::vector<std::int32_t> cells;  ///< row-major, row 0 lowest
  std::vector<std::string> names;   ///< of the labels, by value; may be shorter than the labels go
  std::optional<ChangedWindow> changed;  ///< none: all of it may differ from earlier items
  static constexpr void fields(auto& s, auto&& visit) {
    visit("frame", s.frame);
    visit("cells", s.cells);
    visit("names", s.names);
    visit("changed", s.changed);
  }
};

}  // namespace stope
