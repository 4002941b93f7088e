#pragma once

#include <cstdint>
#include <stope/fields.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace acme {

/// A part of a mine, a payload that Stope has never heard of.
struct Sector {
  static constexpr std::string_view kType = "acme/Sector@1";
  std::int64_t cells = 0;
  std::string name;
  std::vector<double> outline;  ///< x, y of its corners in turn, m, map frame
  static constexpr void fields(auto& s, auto&& visit) {
    visit("cells", s.cells);
    visit("name", s.name);
    visit("outline", s.outline);
  }
};

}  // namespace acme
