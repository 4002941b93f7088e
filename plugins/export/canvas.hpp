#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::exports {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// A picture in memory that lines, discs and text are drawn on, smooth at the edges. Coordinates
/// are in pixels from the upper left corner; the centre of the first pixel is at (0.5, 0.5).
class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  int width() const { return width_; }
  int height() const { return height_; }
  Colour at(int x, int y) const;
  void set(int x, int y, Colour colour);

  /// Lines of one layer: where they cross or touch, they do not darken each other. `opacity` 0..1.
  void stroke(const std::vector<std::vector<Vector2>>& lines, double line_width, Colour colour,
              double opacity = 1);
  void disc(const Vector2& centre, double radius, Colour colour);
  void box(int left, int top, int right, int bottom, Colour colour, double opacity);
  /// Digits, blanks and the letters k, m and N, each glyph 5 x 7 squares of `size` pixels.
  void text(int left, int top, int size, std::string_view text, Colour colour);
  /// How many pixels wide text() draws.
  static int text_width(int size, std::string_view text);

  /// The picture as PNG (RGB, 8 bit), the same bytes every time.
  std::vector<std::uint8_t> png() const;

 private:
  void blend(int x, int y, Colour colour, double opacity);

  int width_, height_;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace stope::exports
