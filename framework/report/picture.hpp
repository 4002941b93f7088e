#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace stope::report {

/// Red, green, blue, opacity.
using Colour = std::array<std::uint8_t, 4>;

/// A picture, row-major, row 0 at the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<Colour> pixels;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("width", s.width);
    visit("height", s.height);
    visit("pixels", s.pixels);
  }

  Colour& at(int column, int row) {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
  const Colour& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

}  // namespace stope::report
