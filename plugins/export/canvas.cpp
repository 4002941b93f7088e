// Problem: thin lines must stay readable on maps of any size, and crossings must not show as dots.
// Idea: each layer of lines is first drawn as coverage alone (how much of a pixel the line takes,
// from the distance of the pixel's centre to it), keeping the greatest; then blended once.
// Cost: the pixels of all segments' boxes.
#include "plugins/export/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace stope::exports {
namespace {

struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows;  // 5 bits each, the highest leftmost
};

constexpr std::array kGlyphs{
    Glyph{'0', {14, 17, 19, 21, 25, 17, 14}}, Glyph{'1', {4, 12, 4, 4, 4, 4, 14}},
    Glyph{'2', {14, 17, 1, 2, 4, 8, 31}},     Glyph{'3', {31, 2, 4, 2, 1, 17, 14}},
    Glyph{'4', {2, 6, 10, 18, 31, 2, 2}},     Glyph{'5', {31, 16, 30, 1, 1, 17, 14}},
    Glyph{'6', {6, 8, 16, 30, 17, 17, 14}},   Glyph{'7', {31, 1, 2, 4, 8, 8, 8}},
    Glyph{'8', {14, 17, 17, 14, 17, 17, 14}}, Glyph{'9', {14, 17, 17, 15, 1, 2, 12}},
    Glyph{'m', {0, 0, 26, 21, 21, 17, 17}},   Glyph{'k', {16, 16, 18, 20, 24, 20, 18}},
    Glyph{'.', {0, 0, 0, 0, 0, 12, 12}},      Glyph{'-', {0, 0, 0, 31, 0, 0, 0}},
    Glyph{'N', {17, 17, 25, 21, 19, 17, 17}}};

double distance_to_segment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 span = b - a;
  const double square = span.squaredNorm();
  const double t = square > 0 ? std::clamp((point - a).dot(span) / square, 0.0, 1.0) : 0.0;
  return (point - a - t * span).norm();
}

/// Pixels from `low` to `high`, as columns or rows of a picture of `size`.
std::pair<int, int> clipped(double low, double high, int size) {
  const double first = std::clamp(std::floor(low), 0.0, static_cast<double>(size));
  const double last = std::clamp(std::ceil(high), 0.0, static_cast<double>(size));
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

Canvas::Canvas(int width, int height, Colour background)
    : width_(width),
      height_(height),
      pixels_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) pixels_[i] = background[i % 3];
}

Colour Canvas::at(int x, int y) const {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                             static_cast<std::size_t>(x));
  return {pixels_[i], pixels_[i + 1], pixels_[i + 2]};
}

void Canvas::set(int x, int y, Colour colour) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                             static_cast<std::size_t>(x));
  std::copy(colour.begin(), colour.end(), pixels_.begin() + static_cast<std::ptrdiff_t>(i));
}

void Canvas::blend(int x, int y, Colour colour, double opacity) {
  Colour mixed = at(x, y);
  for (std::size_t i = 0; i < 3; ++i) {
    mixed[i] = static_cast<std::uint8_t>(
        std::lround(mixed[i] + opacity * (static_cast<double>(colour[i]) - mixed[i])));
  }
  set(x, y, mixed);
}

void Canvas::stroke(const std::vector<std::vector<Vector2>>& lines, double line_width,
                    Colour colour, double opacity) {
  std::vector<std::uint8_t> coverage(static_cast<std::size_t>(width_) *
                                     static_cast<std::size_t>(height_));
  const double reach = line_width / 2 + 0.5;
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 &a = line[i - 1], &b = line[i];
      const auto [left, right] =
          clipped(std::min(a.x(), b.x()) - reach, std::max(a.x(), b.x()) + reach, width_);
      const auto [top, bottom] =
          clipped(std::min(a.y(), b.y()) - reach, std::max(a.y(), b.y()) + reach, height_);
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
          const double distance = distance_to_segment(Vector2(x + 0.5, y + 0.5), a, b);
          const double part = std::clamp(reach - distance, 0.0, 1.0);
          auto& pixel = coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                 static_cast<std::size_t>(x)];
          pixel = std::max(pixel, static_cast<std::uint8_t>(std::lround(255 * part)));
        }
      }
    }
  }
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const auto pixel = coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(x)];
      if (pixel > 0) blend(x, y, colour, opacity * pixel / 255.0);
    }
  }
}

void Canvas::disc(const Vector2& centre, double radius, Colour colour) {
  const auto [left, right] = clipped(centre.x() - radius - 1, centre.x() + radius + 1, width_);
  const auto [top, bottom] = clipped(centre.y() - radius - 1, centre.y() + radius + 1, height_);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const double distance = (Vector2(x + 0.5, y + 0.5) - centre).norm();
      blend(x, y, colour, std::clamp(radius + 0.5 - distance, 0.0, 1.0));
    }
  }
}

void Canvas::box(int left, int top, int right, int bottom, Colour colour, double opacity) {
  for (int y = std::max(0, top); y < std::min(height_, bottom); ++y) {
    for (int x = std::max(0, left); x < std::min(width_, right); ++x) blend(x, y, colour, opacity);
  }
}

void Canvas::text(int left, int top, int size, std::string_view text, Colour colour) {
  for (const char letter : text) {
    for (const Glyph& glyph : kGlyphs) {
      if (glyph.letter != letter) continue;
      for (int row = 0; row < 7; ++row) {
        for (int column = 0; column < 5; ++column) {
          if (((glyph.rows[static_cast<std::size_t>(row)] >> (4 - column)) & 1) == 0) continue;
          const int x = left + column * size, y = top + row * size;
          box(x, y, x + size, y + size, colour, 1);
        }
      }
    }
    left += 6 * size;
  }
}

int Canvas::text_width(int size, std::string_view text) {
  return 6 * size * static_cast<int>(text.size()) - size;
}

}  // namespace stope::exports
